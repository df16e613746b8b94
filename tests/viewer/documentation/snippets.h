// Reads the example files of a documentation page: each is a line "<!-- file: NAME -->" followed by a fenced
// block. Tests write the files to a folder and run them, so that the examples of the pages stay correct.
#pragma once

#include <map>
#include <string>

namespace weft::test {

// Returns the content of each example file by file name, for a page in docs/.
[[nodiscard]] std::map<std::string, std::string> snippets_of(const std::string& page);

}  // namespace weft::test
