#include "graph/resolve/bind/divide_buffers.h"

#include <algorithm>

#include "graph/resolve/fault_text.h"
#include "weft/limits.h"

namespace weft {
namespace {

// Returns the resource of the current frame (age 0) if `id` belongs to a resource with history. Otherwise
// returns `id` itself.
ResourceId newest_of(const Shapes& shapes, ResourceId id) {
    const ResourceId ring = shapes.resources[id].ring;
    return ring == kNoId ? id : ring;
}

using Cuts = std::vector<std::vector<uint64_t>>;

void collect_cuts(const Shapes& shapes, const std::vector<BoundPass>& passes, Cuts& cuts) {
    for (const BoundPass& pass : passes)
        for (const UseDecl& use : pass.uses) {
            if (!use.bytes) continue;
            std::vector<uint64_t>& all = cuts[newest_of(shapes, use.resource)];
            all.push_back(use.bytes->offset_bytes);
            all.push_back(use.bytes->end_bytes());
        }
    for (ResourceId id(0); id < cuts.size(); ++id) {
        std::vector<uint64_t>& all = cuts[id];
        std::ranges::sort(all);
        all.erase(std::unique(all.begin(), all.end()), all.end());
        std::erase_if(all, [&](uint64_t cut) { return cut == 0 || cut >= shapes.resources[id].size_bytes; });
    }
}

SubresourceRange pieces_of(const std::vector<uint64_t>& cuts, const ByteRange& bytes) {
    const auto first = std::ranges::upper_bound(cuts, bytes.offset_bytes) - cuts.begin();
    const auto end = std::ranges::lower_bound(cuts, bytes.end_bytes()) - cuts.begin() + 1;
    return {0, 1, static_cast<uint32_t>(first), static_cast<uint32_t>(end - first), aspect::kColor};
}

// Reports each buffer with too many pieces. Nothing more is reported about such a buffer.
void check_piece_counts(const Declared& declared, BoundPasses& bound, Reporter& reporter) {
    const uint64_t limit = declared.input.limits.buffer_pieces;
    for (ResourceId id(0); id < bound.cuts_bytes.size(); ++id) {
        const uint64_t pieces = bound.cuts_bytes[id].size() + 1;
        if (pieces <= limit) continue;
        const ResourceDecl& buffer = declared.shapes.resources[id];
        Diagnostic& d =
            reporter.error(buffer.loc, "W125",
                           "the ranges of buffer " + quote(buffer.name) + " divide it into " +
                               std::to_string(pieces) + " pieces; the limit is " + std::to_string(limit));
        add_help(d, "name fewer different ranges of the buffer, " + raise_limit_text("graph.bufferPieces"));
        bound.suspects.shapes[id] = bound.suspects.writers[id] = 1;
        bound.cuts_bytes[id].clear();
    }
}

}  // namespace

void divide_buffers(const Declared& declared, BoundPasses& bound, Reporter& reporter) {
    const Shapes& shapes = declared.shapes;
    bound.cuts_bytes.assign(shapes.resources.size(), {});
    collect_cuts(shapes, bound.passes, bound.cuts_bytes);
    check_piece_counts(declared, bound, reporter);
    for (ResourceId id(0); id < bound.cuts_bytes.size(); ++id)
        bound.cuts_bytes[id] = bound.cuts_bytes[newest_of(shapes, id)];
    for (BoundPass& pass : bound.passes)
        for (UseDecl& use : pass.uses) {
            const ResourceDecl& buffer = shapes.resources[use.resource];
            if (buffer.kind != ResourceKind::buffer) continue;
            use.range = pieces_of(bound.cuts_bytes[use.resource], used_bytes(buffer, use));
        }
}

}  // namespace weft
