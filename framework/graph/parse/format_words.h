// Purpose: the words of the graph format by the place where they stand, read off the parser's own tables, so
// that what else describes the format (its schema, its reference) can be held against them. A place is what
// the schema calls it in "definitions"; the file itself is "graph".
#pragma once

#include <string>
#include <vector>

namespace weft {

struct FormatWords {
    std::string place;      // "resource", "computePass", "cull", …
    bool are_keys = false;  // of an object; else what a string may be
    std::vector<std::string> words;
    std::vector<std::string> required = {};  // of the keys of a kind of pass or resource
    std::string kind_of = {};                // the place that has the keys of all kinds
};

[[nodiscard]] std::vector<FormatWords> format_words();
// What a buffer may be made of, besides the structs that the program shares.
[[nodiscard]] std::vector<std::string> plain_elements();

}  // namespace weft
