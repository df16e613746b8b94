// Purpose: texts that show the progress of long tasks. On a terminal, one line is updated; otherwise, a new
// line is printed for every tenth of the task. Tasks shorter than one second print nothing.
#pragma once

#include <cstdint>
#include <string>

namespace weft::viewer {

class ProgressText {
 public:
    // `task` is the start of each line, before a colon, such as "loading hall.glb".
    ProgressText(std::string task, bool terminal) : task_(std::move(task)), terminal_(terminal) {}

    // Returns the text to print when `done` of `total` units are complete, `elapsed_s` seconds after the
    // start. The unit `what` is a word such as "frames". The text is often empty, so that it is not printed
    // too often.
    [[nodiscard]] std::string at(double elapsed_s, const std::string& what, uint64_t done, uint64_t total);
    // Returns the text to print at the end of the task. On a terminal, this text clears the progress line.
    [[nodiscard]] std::string finish();

 private:
    std::string task_;
    bool terminal_;
    std::string what_;    // The unit that was printed last, such as "frames".
    uint64_t tenth_ = 0;  // The last tenth of the task for which a line was printed.
    // Time of the last update of the line on the terminal, in seconds since the task started. Negative if no
    // line is visible.
    double last_line_s_ = -1;
};

}  // namespace weft::viewer
