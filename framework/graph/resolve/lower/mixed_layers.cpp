#include "graph/resolve/lower/mixed_layers.h"

#include <algorithm>

#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

// Returns true if a pass that draws only this layer of the attachment would load the content of this layer.
bool loads_layer(const Declared& declared, const UseDecl& use, const PortDraft& port, uint32_t layer) {
    return std::ranges::any_of(use.sources, [&](const VersionSource& source) {
        const SubresourceRange& range = source.range;
        if (layer < range.layer || layer >= range.layer + range.layers) return false;
        if (port.rank == WriteRank::in_place) return true;
        return source.producer != kNoId && !declared.expansion.passes[source.producer].decl.carries;
    });
}

// Returns true if the pass loads the attachment, although a pass that draws only one of its layers would not
// load that layer.
bool is_mixed(const Declared& declared, const UseDecl& use, const PortDraft& port) {
    const bool is_attachment = port.color_output != nullptr || port.is_depth_port;
    if (!is_attachment || !reads(use.access)) return false;
    for (uint32_t layer = use.range.layer; layer < use.range.layer + use.range.layers; ++layer)
        if (!loads_layer(declared, use, port, layer)) return true;
    return false;
}

}  // namespace

SeparateViews find_mixed_layers(const Declared& declared, const VersionedGraph& graph, Reporter& reporter) {
    SeparateViews found;
    if (reporter.has_errors()) return found;
    for (PassId id(0); id < graph.passes.size(); ++id) {
        const PassDraft& draft = declared.expansion.passes[id];
        const BoundPass& pass = graph.passes[id];
        for (uint32_t u = 0; draft.views > 0 && u < pass.uses.size(); ++u) {
            if (!is_mixed(declared, pass.uses[u], pass.ports[u])) continue;
            const PassDesc& desc = *draft.desc;
            const std::string reason = "other passes write some of the layers of " +
                                       quote(declared.resource_name(pass.uses[u].resource)) +
                                       " earlier in the frame, so some layers are loaded and others cleared";
            found.emplace(desc.name, reason);
            if (desc.lowering == LoweringDesc::automatic) break;
            Diagnostic& d = reporter.error(
                desc.lowering_loc, "W199",
                "the views of pass " + quote(desc.name) + " cannot be drawn by one pass: " + reason);
            add_help(d, "let earlier passes write all of these layers, or none of them");
            add_help(d, "or remove \"lowering\", so that Weft chooses");
            break;
        }
    }
    return found;
}

}  // namespace weft
