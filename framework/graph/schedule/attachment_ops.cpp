// Chooses the load and store operations of attachments from the declarations alone. An attachment is stored
// if another pass reads the written content, or if the resource outlives the frame. The first write to an
// attachment clears it, unless the pass covers every texel.
#include <algorithm>
#include <tuple>

#include "graph/schedule/attachment_ops.h"

namespace weft {
namespace {

struct Written {
    PassId producer;
    ResourceId resource;
    SubresourceRange range;
    bool operator<(const Written& other) const {
        return std::tie(producer, resource) < std::tie(other.producer, other.resource);
    }
};

// Returns every version (content of a resource after one pass has written it) that a live pass reads, if the
// writing pass has attachments. The entries are sorted by the writing pass, then by resource.
std::vector<Written> versions_read(const ResolvedGraph& graph, const LiveGraph& live) {
    std::vector<Written> versions;
    // Index: PassId. 1 if the pass has attachments.
    std::vector<uint8_t> draws(graph.passes.size(), 0);
    bool any = false;
    for (PassId id(0); id < graph.passes.size(); ++id) {
        draws[id] = !graph.passes[id].colors.empty() || graph.passes[id].depth ? 1 : 0;
        any = any || draws[id] != 0;
    }
    if (!any) return versions;
    for (PassId id(0); id < graph.passes.size(); ++id) {
        if (!live.live_passes[id]) continue;
        for (const UseDecl& use : graph.passes[id].uses)
            // While a pass with a switch is off, the readers of its version see the versions in `passes_on`.
            for (const std::vector<VersionSource>* seen : {&use.sources, &use.passes_on})
                for (const VersionSource& source : *seen)
                    if (source.producer != kNoId && draws[source.producer] != 0)
                        versions.push_back({source.producer, use.resource, source.range});
    }
    std::stable_sort(versions.begin(), versions.end());
    return versions;
}

bool is_read(const std::vector<Written>& versions, const Written& version) {
    const auto [first, last] = std::equal_range(versions.begin(), versions.end(), version);
    return std::any_of(first, last, [&](const Written& v) { return overlaps(v.range, version.range); });
}

LoadOp load_op(const UseDecl& use, const AttachmentDecl& attachment) {
    const bool first_write = use.access == Access::color_write || use.access == Access::depth_write;
    if (!first_write) return LoadOp::load;
    return attachment.covers ? LoadOp::dont_care : LoadOp::clear;
}

StoreOp store_op(const ResolvedGraph& graph, PassId pass, const UseDecl& use,
                 const std::vector<Written>& versions) {
    if (!writes(use.access)) return StoreOp::none;
    if (graph.resources[use.resource].lifetime != ResourceLifetime::transient) return StoreOp::store;
    return is_read(versions, {pass, use.resource, use.range}) ? StoreOp::store : StoreOp::dont_care;
}

}  // namespace

AttachmentTable attachment_ops(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order) {
    const std::vector<Written> versions = versions_read(graph, live);
    AttachmentTable result(order.order.size());
    for (Position position(0); position < order.order.size(); ++position) {
        const PassId id = order.order[position];
        const PassDecl& pass = graph.passes[id];
        const auto add = [&](const AttachmentDecl& attachment) {
            const UseDecl& use = pass.uses[attachment.use];
            result[position].push_back(
                {attachment.use, load_op(use, attachment), store_op(graph, id, use, versions)});
        };
        for (const AttachmentDecl& color : pass.colors) add(color);
        if (pass.depth) add(*pass.depth);
    }
    return result;
}

}  // namespace weft
