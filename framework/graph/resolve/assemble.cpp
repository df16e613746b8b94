#include "graph/resolve/assemble.h"

#include <algorithm>

#include "graph/resolve/views/view_lists.h"

namespace weft {
namespace {

void add_bound(const BoundPass& bound, PassDecl& pass) {
    pass.uses = bound.uses;
    pass.spec_values = bound.spec_values;
    pass.draw_lists = bound.draw_lists;
    pass.vertices = bound.vertices;
    pass.instances = bound.instances;
    pass.view = bound.view;
    const auto view = std::ranges::find_if(bound.ports, &PortDraft::is_view);
    if (view != bound.ports.end()) pass.view_use = static_cast<uint32_t>(view - bound.ports.begin());
    pass.views = bound.views;
    pass.clear = bound.clear;
}

void add_attachments(const PassAttachments& attachments, PassDecl& pass) {
    pass.colors = attachments.colors;
    pass.depth = attachments.depth;
    pass.render_extent = attachments.render_extent;
    if (attachments.rect) pass.state.viewport = pass.state.scissor = attachments.rect;
}

void add_dispatch(const PassDispatch& dispatch, PassDecl& pass) {
    pass.groups = dispatch.groups;
    pass.indirect_use = dispatch.indirect_use;
    pass.draw_commands_use = dispatch.draw_commands_use;
    pass.draw_count_use = dispatch.draw_count_use;
    pass.most_draws = dispatch.most_draws;
}

// Returns true if the CPU knows the frustum of the pass, and a draw whose box is outside of this frustum
// cannot change the picture. Returns false for lines and points, because they are wider than their vertices,
// for indirect draws, because their commands are on the GPU, and for views in buffers, because the CPU cannot
// read them.
bool may_cull(const PassDecl& pass) {
    const Topology topology = pass.state.topology;
    return pass.kind == PassKind::raster && !pass.draw_lists.empty() && pass.draw_commands_use == kNoId &&
           pass.state.fill == FillMode::fill && pass.view_use == kNoId &&
           (topology == Topology::triangles || topology == Topology::triangle_strip);
}

void add_block(const PassBlock& block, PassDecl& pass) {
    pass.params = block.params;
    pass.params_bytes = block.bytes;
    pass.params_push = block.push_constants;
}

// Returns true if the pass writes a resource that the program uses between frames: an import with `observed`,
// or an export (GraphRequest::exports) that lives within one frame. Such an export has the lifetime
// `imported`. Other exports are not counted, because a counted pass has a side effect and cannot rest. cull()
// keeps the passes that write these other exports.
bool writes_for_program(const Declared& declared, const std::vector<ResourceDecl>& resources,
                        const PassDecl& pass) {
    return std::ranges::any_of(pass.uses, [&](const UseDecl& use) {
        const ResourceDecl& decl = resources[use.resource];
        if (!writes(use.access) || decl.lifetime != ResourceLifetime::imported) return false;
        if (declared.input.request.exports.contains(decl.name)) return true;
        const auto import = declared.input.imports.imports.find(decl.name);
        return import != declared.input.imports.imports.end() && import->second.observed;
    });
}

}  // namespace

ResolvedGraph assemble(const Declared& declared, const VersionedGraph& graph, const Attachments& attachments,
                       const Dispatches& dispatches, const Blocks& blocks) {
    ResolvedGraph resolved;
    resolved.name = declared.input.graph.name;
    resolved.output_extent = declared.input.request.size;
    resolved.resources = graph.resources;
    resolved.edges = graph.edges;
    resolved.output = declared.shapes.output;
    resolved.params = declared.values.params;
    resolved.frames = declared.values.frames;
    resolved.rest_unit_count = graph.rest_unit_count;
    resolved.groups = graph.groups;
    for (PassId id(0); id < graph.passes.size(); ++id) {
        PassDecl& pass = resolved.passes.emplace_back(declared.expansion.passes[id].decl);
        add_bound(graph.passes[id], pass);
        if (!graph.rest_units.empty()) pass.rest_unit = graph.rest_units[id];
        add_attachments(attachments.passes[id], pass);
        add_dispatch(dispatches.passes[id], pass);
        add_block(blocks.passes[id], pass);
        pass.side_effect |= writes_for_program(declared, resolved.resources, pass);
        pass.culls_draws = declared.expansion.passes[id].desc->frustum && may_cull(pass);
    }
    resolved.views = used_view_lists(declared.values, resolved.passes);
    return resolved;
}

}  // namespace weft
