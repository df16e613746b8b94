// Purpose: the words that tell how a long piece of work goes on: on a terminal one line that renews itself,
// elsewhere a line for every tenth. Short work is not worth a word.
#pragma once

#include <cstdint>
#include <string>

namespace weft::viewer {

class ProgressText {
 public:
    // `task` stands before the colon: "loading hall.glb".
    ProgressText(std::string task, bool terminal) : task_(std::move(task)), terminal_(terminal) {}

    // What to print when `done` of `total` `what` are done, `elapsed_s` after the beginning; often nothing.
    [[nodiscard]] std::string at(double elapsed_s, const std::string& what, uint64_t done, uint64_t total);
    // What to print when all is over: wipes the line.
    [[nodiscard]] std::string finish();

 private:
    std::string task_;
    bool terminal_;
    std::string what_;         // the stage that was told of last
    uint64_t tenth_ = 0;       // of that stage, up to where lines were printed
    double last_line_s_ = -1;  // when the terminal's line was renewed; negative: it is not there
};

}  // namespace weft::viewer
