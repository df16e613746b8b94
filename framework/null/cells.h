// Purpose: numbers the cells of a resource. A cell is one mip of one layer of one aspect of an image, or one
// piece of a buffer. Cells are ordered by aspect, then layer, then mip.
#pragma once

#include <bit>
#include <cstdint>

#include "null/null_executor.h"
#include "weft/declaration.h"

namespace weft::null {

inline uint32_t aspect_count(AspectMask aspects) {
    return static_cast<uint32_t>(std::popcount(static_cast<unsigned>(aspects)));
}

inline uint32_t cell_count(const ResourceDecl& resource) {
    if (resource.kind == ResourceKind::buffer) return resource.whole().layers;
    return aspect_count(resource.aspects) * resource.layers * resource.mips;
}

// Calls visit(index, subresource) for every cell of `range`. `index` counts all cells of the resource, also
// those outside `range`.
template <class F>
void for_each_cell(const ResourceDecl& resource, const SubresourceRange& range, F visit) {
    if (resource.kind == ResourceKind::buffer) {
        for (uint32_t piece = range.layer; piece < range.layer + range.layers; ++piece)
            visit(piece, SubresourceRange{0, 1, piece, 1, aspect::kColor});
        return;
    }
    uint32_t plane = 0;
    for (unsigned bit = 1; bit <= resource.aspects; bit <<= 1) {
        if (!(resource.aspects & bit)) continue;
        const uint32_t base = plane++ * resource.layers;
        if (!(range.aspects & bit)) continue;
        for (uint32_t layer = range.layer; layer < range.layer + range.layers; ++layer)
            for (uint32_t mip = range.mip; mip < range.mip + range.mips; ++mip)
                visit((base + layer) * resource.mips + mip,
                      SubresourceRange{mip, 1, layer, 1, static_cast<AspectMask>(bit)});
    }
}

// Calls visit() for every cell that a use touches. For a buffer, the function finds the cells from the bytes
// that the use names, and ignores UseDecl::range. But the barriers of the plan cover this range. So if the
// range does not fit the bytes, the run gives wrong values, which show the fault.
template <class F>
void for_each_cell(const ResourceDecl& resource, const UseDecl& use, F visit) {
    if (resource.kind == ResourceKind::image) return for_each_cell(resource, use.range, visit);
    const ByteRange used = used_bytes(resource, use);
    for_each_cell(resource, resource.whole(), [&](uint32_t index, const SubresourceRange& piece) {
        const ByteRange bytes = piece_bytes(resource, piece);
        if (bytes.offset_bytes < used.end_bytes() && used.offset_bytes < bytes.end_bytes())
            visit(index, piece);
    });
}

template <class F>
void for_each_cell(const ResourceDecl& resource, F visit) {
    for_each_cell(resource, resource.whole(), visit);
}

// Returns the pass that wrote the content that `use` sees in one cell. Returns kNoId if the content is from
// before the frame.
inline PassId source_of(const UseDecl& use, const SubresourceRange& cell) {
    for (const VersionSource& source : use.sources)
        if (overlaps(source.range, cell)) return source.producer;
    return kNoId;
}

// Returns true if the pass depends on the previous content of the range. This includes a copy or clear that
// overwrites only a part of the range: the access type only writes, but the rest must keep its content.
inline bool sees_content(const UseDecl& use) {
    return reads(use.access) || (writes(use.access) && !use.sources.empty());
}

// Returns false for transients: their content is undefined at the start of a frame, so no pass may rely on
// it.
inline bool defined_before_frame(const ResourceDecl& resource) {
    return resource.lifetime != ResourceLifetime::transient;
}

// Returns the switches that are on in this frame.
[[nodiscard]] inline Combination switches_in(const SwitchChoice& switches, uint32_t frame) {
    return frame < switches.size() ? switches[frame] : kAllSwitchesOn;
}

// Returns true if the passes of the rest unit do not run in this frame. kNoId stands for a pass without a
// unit.
[[nodiscard]] inline bool rests(const RestChoice& resting, uint32_t unit, uint32_t frame) {
    return unit != kNoId && frame < resting.size() && unit < resting[frame].size() &&
           resting[frame][unit] != 0;
}

}  // namespace weft::null
