// Purpose: texts that show the progress of long tasks. On a terminal, one line is updated. Otherwise, a new
// line is printed whenever another tenth of the task is complete. Tasks shorter than one second print
// nothing.
#pragma once

#include <cstdint>
#include <string>

namespace weft::viewer {

class ProgressText {
 public:
    // `task` is part of each line. Example: "loading hall.glb" gives "weft: loading hall.glb: textures, 3 of
    // 8". `terminal` is true if the texts are printed to a terminal.
    ProgressText(std::string task, bool terminal) : task_(std::move(task)), terminal_(terminal) {}

    // Returns the text to print when `done` of `total` units are complete, `elapsed_s` seconds after the
    // start. `what` is the name of the units, such as "frames". The returned text is often empty, because the
    // progress must not be printed at every call.
    [[nodiscard]] std::string at(double elapsed_s, const std::string& what, uint64_t done, uint64_t total);
    // Returns the text to print at the end of the task. On a terminal, this text clears the progress line.
    [[nodiscard]] std::string finish();

 private:
    std::string task_;
    bool terminal_;
    std::string what_;    // The name of the units in the last call of at(), such as "frames".
    uint64_t tenth_ = 0;  // The last tenth of the task for which a line was printed.
    // Time of the last update of the line on the terminal, in seconds since the task started. Negative if no
    // line is visible.
    double last_line_s_ = -1;
};

}  // namespace weft::viewer
