// Purpose: lists the keys and words of the graph format for each place in the grammar, from the parser's own
// tables, so that tests can compare the schema and the reference with them. A place has the name of its
// definition in the schema; the file itself is "graph".
#pragma once

#include <string>
#include <vector>

namespace weft {

struct GrammarTable {
    std::string place;      // "resource", "computePass", "cull", …
    bool are_keys = false;  // true: keys of an object; false: allowed strings
    std::vector<std::string> words;
    std::vector<std::string> required = {};  // for the keys of a kind of pass or resource
    std::string kind_of = {};                // the place with the keys of all kinds
};

[[nodiscard]] std::vector<GrammarTable> grammar_tables();
// Element types of a buffer, besides the structs that the program shares.
[[nodiscard]] std::vector<std::string> plain_elements();

}  // namespace weft
