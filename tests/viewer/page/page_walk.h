// Reads a page of the documentation as a list of steps, in the order of the page: files to write, commands to
// run, output to expect.
//   <!-- file: NAME -->                      the next fence is the content of file NAME
//   ```sh                                    the fence contains commands, one per line
//   ```console                               the fence contains "$ COMMAND" and its output
//   <!-- mistake: FILE: OLD => NEW -->       for the next fence, FILE has every OLD replaced by NEW
#pragma once

#include <string>
#include <vector>

namespace weft::test {

struct PageMistake {
    // File in which the mistake is made; empty if the step makes no mistake.
    std::string file;
    // The correct text (OLD).
    std::string right;
    // The faulty text that replaces it (NEW).
    std::string wrong;
};

struct PageEvent {
    enum class Kind { file, commands, console };
    Kind kind = Kind::file;
    // Name of the file to write, if the step is a file.
    std::string name;
    // Lines inside the fenced block.
    std::vector<std::string> lines;
    PageMistake mistake;
    // Line number of the fence on the page; the first line is 1.
    int line = 0;
};

// Returns the steps of a page in docs/. `page` is the path relative to docs/. A fence of another language is
// ignored, unless a file comment precedes it.
[[nodiscard]] std::vector<PageEvent> events_of(const std::string& page);

[[nodiscard]] std::string joined(const std::vector<std::string>& lines);

}  // namespace weft::test
