#include "graph/resolve/declared.h"

#include "graph/resolve/fault_text.h"

namespace weft {

std::string name_reader(const PassDraft& pass) {
    return pass.is_observer ? "the observer" : "pass " + quote(pass.decl.name);
}

std::vector<std::string> list_pass_names(const GraphDesc& graph) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : graph.passes) names.push_back(name);
    return names;
}

}  // namespace weft
