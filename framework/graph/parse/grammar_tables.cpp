#include "graph/parse/grammar_tables.h"

#include "graph/parse/debug_view.h"
#include "graph/parse/parse_context.h"
#include "weft/format.h"

namespace weft {

std::vector<GrammarTable> grammar_tables() {
    std::vector<GrammarTable> words;
    for (const auto list :
         {list_graph_words, list_param_words, list_resource_words, list_pass_words, list_port_words,
          list_state_words, list_blend_words, list_debug_words, list_test_words})
        list(words);
    words.push_back({"formatName", false, format_names()});
    words.push_back({"plainElement", false, plain_elements()});
    words.push_back({"decoder", false, debug_decoders()});
    return words;
}

}  // namespace weft
