#include "graph/resolve/check/resource_names.h"
#include "graph/resolve/checks.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {

bool is_included(const SourceMap& sources, SourceLoc loc) {
    const std::vector<SourceFile>& files = sources.files;
    return loc.file < files.size() && files[loc.file].included_at.file < files.size();
}

// Warns about resources that no pass names. A resource counts as used even if only a removed pass or an
// unused "else" names it, because with other parameter values that pass or "else" may be used.
void warn_unused(const Declared& declared, Reporter& reporter) {
    ResourceNames used;
    for (const auto& [name, desc] : declared.input.graph.passes) {
        add_inputs(desc, used);
        for (const PortDesc* port : written_ports(desc)) add_names(*port, used);
    }
    for (const auto& [name, list] : declared.input.graph.views)
        if (list.buffer) add_names(*list.buffer, used);
    const Shapes& shapes = declared.shapes;
    for (ResourceId id(0); id < shapes.resources.size(); ++id) {
        const ResourceDecl& resource = shapes.resources[id];
        if (used.contains(resource.name) || !shapes.origins[id].desc || resource.age > 0) continue;
        if (is_included(reporter.sources(), resource.loc)) continue;
        reporter.warn(resource.loc, "W130", "no pass uses resource " + quote(resource.name),
                      "remove the resource, or use it in a pass");
    }
}

}  // namespace weft
