// Purpose: detects requests to end a command that runs continuously: SIGINT, SIGTERM, or the end of its
// stdin.
#pragma once

#include <chrono>

namespace weft::viewer {

class EndSignals {
 public:
    // From now on the signals do not end the process; threads created later inherit this. With `watch_stdin`
    // the end of stdin is a request too, unless stdin is a terminal.
    explicit EndSignals(bool watch_stdin);
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    // Waits for at most `time`; returns true if the command shall end.
    [[nodiscard]] bool within(std::chrono::nanoseconds time);

 private:
    int signals_ = -1;
    bool watch_stdin_;
};

}  // namespace weft::viewer
