// Purpose: detects requests to end a command that renders continuously. A request is the signal SIGINT, the
// signal SIGTERM, or the end of stdin.
#pragma once

#include <chrono>

namespace weft::viewer {

class EndSignals {
 public:
    // Blocks SIGINT and SIGTERM, so that they do not end the process. Threads that are created later inherit
    // the blocked signals. If `watch_stdin` is true, the end of stdin is a request to end, too, unless stdin
    // is a terminal.
    explicit EndSignals(bool watch_stdin);
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    // Waits until a request to end arrives, but at most for `time`. Returns true if the command must end. If
    // text arrives on a watched stdin, the function returns false early.
    [[nodiscard]] bool within(std::chrono::nanoseconds time);

 private:
    int signals_ = -1;
    bool watch_stdin_;
};

}  // namespace weft::viewer
