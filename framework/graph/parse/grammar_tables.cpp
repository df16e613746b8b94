#include "graph/parse/grammar_tables.h"

#include "graph/parse/debug_view.h"
#include "graph/parse/parse_context.h"
#include "graph/syntax/include_item.h"
#include "weft/format.h"

namespace weft {

std::vector<GrammarTable> grammar_tables() {
    std::vector<GrammarTable> words;
    for (const auto list : {list_graph_grammar, list_param_grammar, list_resource_grammar, list_pass_grammar,
                            list_group_grammar, list_view_grammar, list_port_grammar, list_state_grammar,
                            list_blend_grammar, list_debug_grammar, list_test_grammar})
        list(words);
    words.push_back({"module", true, include_keys()});
    words.push_back({"formatName", false, format_names()});
    words.push_back({"plainElement", false, plain_elements()});
    words.push_back({"decoder", false, debug_decoders()});
    return words;
}

}  // namespace weft
