// The files shown on a page of the documentation: a line "<!-- file: NAME -->" followed by a fenced block.
// Tests write the files to a folder and run them, so that the pages stay correct.
#pragma once

#include <map>
#include <string>

namespace weft::test {

// Content by file name, for a page in docs/.
[[nodiscard]] std::map<std::string, std::string> snippets_of(const std::string& page);

}  // namespace weft::test
