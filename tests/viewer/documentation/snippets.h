// The files that a page of the documentation shows: a line "<!-- file: NAME -->" followed by a fence. Tests
// write them into a folder and run them, so that no page can rot.
#pragma once

#include <map>
#include <string>

namespace weft::test {

// NAME → content, for a page under docs/.
[[nodiscard]] std::map<std::string, std::string> snippets_of(const std::string& page);

}  // namespace weft::test
