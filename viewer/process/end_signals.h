// Purpose: how a command that runs on and on is told to end: SIGINT, SIGTERM, or its stdin closes.
#pragma once

#include <chrono>

namespace weft::viewer {

class EndSignals {
 public:
    // From now on the signals end nothing by themselves, in threads that are made later neither. With
    // `watch_stdin` a stdin that closes counts; a terminal's doesn't.
    explicit EndSignals(bool watch_stdin);
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    // Waits for `time` at most; true: it shall end.
    [[nodiscard]] bool within(std::chrono::nanoseconds time);

 private:
    int signals_ = -1;
    bool watch_stdin_;
};

}  // namespace weft::viewer
