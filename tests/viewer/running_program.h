// Purpose: runs a `weft` program in the background; a test can read the output so far, send signals, and end
// the program.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

class RunningProgram {
 public:
    // Starts `weft`. `environment` is added to the environment of the test. The program is killed after
    // `most_cpu_s` seconds of processor time, or after kMostWall_s seconds of elapsed time.
    explicit RunningProgram(const std::vector<std::string>& arguments, const Environment& environment = {},
                            unsigned most_cpu_s = kMostCpu_s);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    // Returns the output so far: stdout and stderr together.
    [[nodiscard]] std::string err() const { return read_text(scratch_ / "err"); }
    // Waits until the output (stdout and stderr) contains `text` at least `times` times. Stops waiting when
    // the program has ended or after kMostWall_s seconds. Returns true if the text was found so often.
    [[nodiscard]] bool says(const std::string& text, int times = 1) const;
    [[nodiscard]] pid_t id() const { return child_; }
    void close_stdin();
    void send(int signal) const;
    // Waits for the end of the program. Returns its exit code, or 128 + the number of the signal that killed
    // it.
    [[nodiscard]] int exit_code();

 private:
    [[nodiscard]] bool has_ended() const;

    ScratchFolder scratch_;
    pid_t child_ = -1;
    int stdin_ = -1;
};

}  // namespace weft::test
