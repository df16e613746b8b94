// Purpose: texts for the progress of long tasks: on a terminal, one line that is updated; elsewhere, a new
// line for every tenth. Short tasks print nothing.
#pragma once

#include <cstdint>
#include <string>

namespace weft::viewer {

class ProgressText {
 public:
    // `task` is the text before the colon: "loading hall.glb".
    ProgressText(std::string task, bool terminal) : task_(std::move(task)), terminal_(terminal) {}

    // The text to print when `done` of `total` `what` are complete, `elapsed_s` seconds after the start;
    // often empty.
    [[nodiscard]] std::string at(double elapsed_s, const std::string& what, uint64_t done, uint64_t total);
    // The text to print at the end: it clears the terminal's line.
    [[nodiscard]] std::string finish();

 private:
    std::string task_;
    bool terminal_;
    std::string what_;         // the stage that was printed last
    uint64_t tenth_ = 0;       // last tenth of that stage for which a line was printed
    double last_line_s_ = -1;  // time of the last update of the terminal's line; negative: there is no line
};

}  // namespace weft::viewer
