#include "viewer/output/port_bytes.h"

namespace weft::viewer {

uint64_t port_bytes(const ResolvedGraph& graph, const PassDecl& pass) {
    uint64_t bytes = 0;
    for (const UseDecl& use : pass.uses) {
        const ResourceDecl& resource = graph.resources[use.resource];
        ResourceDecl part = resource;
        if (resource.kind == ResourceKind::image) {
            part.extent = mip_extent(resource.extent, use.range.mip);
            part.mips = use.range.mips;
            part.layers = use.range.layers;
        }
        const uint64_t once = resource.kind == ResourceKind::buffer ? used_bytes(resource, use).size_bytes
                                                                    : content_bytes(part);
        bytes += (reads(use.access) ? once : 0) + (writes(use.access) ? once : 0);
    }
    return bytes;
}

}  // namespace weft::viewer
