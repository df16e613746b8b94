// A page of the documentation as something to follow: what a reader writes, runs and sees, in the page's
// order.
//   <!-- file: NAME -->                      the next fence is that file; it replaces an earlier one
//   ```sh                                    commands, one a line
//   ```console                               "$ COMMAND" and what it prints
//   <!-- mistake: FILE: OLD => NEW -->       the next fence is about FILE with every OLD made NEW
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
    std::string name;                // of the file
    std::vector<std::string> lines;  // inside the fence
    PageMistake mistake;
    int line = 0;  // where the fence begins, from 1
};

// For a page under docs/. Fences of other kinds are left out.
[[nodiscard]] std::vector<PageEvent> events_of(const std::string& page);

[[nodiscard]] std::string joined(const std::vector<std::string>& lines);

}  // namespace weft::test
