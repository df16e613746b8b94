// Purpose: a running `weft` program: reads its output so far, and can end it.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

class RunningProgram {
 public:
    // `environment` is added to the test's environment. The program is killed after this much processor time.
    explicit RunningProgram(const std::vector<std::string>& arguments, const Environment& environment = {},
                            unsigned most_cpu_s = kMostCpu_s);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    [[nodiscard]] std::string err() const { return read_text(scratch_ / "err"); }
    // Waits until stderr contains `text` this many times, or the program has ended.
    [[nodiscard]] bool says(const std::string& text, int times = 1) const;
    [[nodiscard]] pid_t id() const { return child_; }
    void close_stdin();
    void send(int signal) const;
    // Waits for the end of the program. 128 + signal if it was killed.
    [[nodiscard]] int exit_code();

 private:
    [[nodiscard]] bool has_ended() const;

    ScratchFolder scratch_;
    pid_t child_ = -1;
    int stdin_ = -1;
};

}  // namespace weft::test
