// Purpose: lists the keys and words of the graph format for each place in the grammar. The lists come from
// the parser's own tables, so that tests can compare the JSON schema and the reference documentation with the
// parser. A place has the name of its definition in the schema; the place of a whole graph file is "graph".
#pragma once

#include <string>
#include <vector>

namespace weft {

struct GrammarTable {
    // Name of the place in the grammar, such as "resource", "computePass" or "cull".
    std::string place;
    // True if `words` are the keys of an object, false if `words` are the strings that are allowed as a
    // value.
    bool are_keys = false;
    std::vector<std::string> words;
    // Keys that must be present. Filled only if `words` are the keys of one kind of pass or resource.
    std::vector<std::string> required = {};
    // If `words` are the keys of one kind of pass or resource: the place that lists the keys of all kinds.
    // For example, this is "anyPass" for the place "computePass". Otherwise empty.
    std::string kind_of = {};
};

[[nodiscard]] std::vector<GrammarTable> grammar_tables();
// Returns the built-in element types of buffers. A buffer can also have elements of a struct type that the
// program shares with the shaders.
[[nodiscard]] std::vector<std::string> plain_elements();

}  // namespace weft
