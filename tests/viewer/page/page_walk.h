// A page of the documentation as a list of steps, in the order of the page: files to write, commands to run,
// output to expect.
//   <!-- file: NAME -->                      the next fence is that file; it replaces an earlier one
//   ```sh                                    commands, one per line
//   ```console                               "$ COMMAND" and its output
//   <!-- mistake: FILE: OLD => NEW -->       the next fence uses FILE with every OLD replaced by NEW
#pragma once

#include <string>
#include <vector>

namespace weft::test {

struct PageMistake {
    std::string file;  // empty: none
    std::string right;
    std::string wrong;
};

struct PageEvent {
    enum class Kind { file, commands, console };
    Kind kind = Kind::file;
    std::string name;                // name of the file
    std::vector<std::string> lines;  // lines inside the fence
    PageMistake mistake;
    int line = 0;  // first line of the fence, from 1
};

// For a page in docs/. Other kinds of fences are ignored.
[[nodiscard]] std::vector<PageEvent> events_of(const std::string& page);

[[nodiscard]] std::string joined(const std::vector<std::string>& lines);

}  // namespace weft::test
