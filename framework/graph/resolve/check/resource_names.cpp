#include "graph/resolve/check/resource_names.h"

namespace weft {

void add_names(const PortDesc& port, ResourceNames& names) {
    names.insert(port.ref.name);
    if (port.otherwise) names.insert(port.otherwise->name);
}

void add_inputs(const PassDesc& desc, ResourceNames& names) {
    for (const PortDesc& port : desc.in) add_names(port, names);
    if (desc.indirect) add_names(*desc.indirect, names);
    if (desc.draw_count) add_names(*desc.draw_count, names);
}

ResourceNames watched_resources(const GraphDesc& graph) {
    ResourceNames watched;
    for (const auto& [name, view] : graph.debug) watched.insert(view.show.name);
    for (const GraphTestDesc& test : graph.tests)
        for (const ExpectationDesc& expectation : test.expect)
            watched.insert(std::string_view(expectation.ref).substr(0, expectation.ref.find_first_of("@[.")));
    return watched;
}

}  // namespace weft
