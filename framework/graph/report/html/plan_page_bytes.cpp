#include "graph/report/html/plan_page_bytes.h"

#include <algorithm>
#include <cmath>

#include "graph/diagnostics/quantity_text.h"
#include "graph/report/html/plan_page_sizes.h"

namespace weft {
namespace {

constexpr int32_t kHeight_px = 320, kMostHeight_px = 640;
constexpr int32_t kLeastHeight_px = 96;
constexpr int32_t kLeastBlock_px = 6;
// Minimum distance between two ticks of the axis. The last tick is an exception.
constexpr int32_t kLeastTick_px = 24;

// Returns the height of a heap's drawing: at least kHeight_px, and large enough that the smallest block is
// kLeastBlock_px high. If this needs more than kMostHeight_px, returns kHeight_px; then place_blocks()
// enlarges the small blocks.
int32_t scale_height_px(const MemoryPlan& memory, uint32_t heap) {
    const uint64_t heap_bytes = memory.heaps[heap].size_bytes;
    uint64_t least_bytes = heap_bytes;
    for (const Placement& p : memory.placements)
        if (p.heap == heap && p.size_bytes > 0) least_bytes = std::min(least_bytes, p.size_bytes);
    if (least_bytes == 0) return kHeight_px;
    const double wanted_px =
        std::ceil(static_cast<double>(heap_bytes) / static_cast<double>(least_bytes) * kLeastBlock_px);
    return wanted_px <= kMostHeight_px ? std::max(kHeight_px, static_cast<int32_t>(wanted_px)) : kHeight_px;
}

std::string tick_text(uint64_t byte, uint64_t step_bytes) {
    if (step_bytes >= 1u << 20) return std::to_string(byte >> 20) + " MiB";
    if (step_bytes >= 1u << 10) return std::to_string(byte >> 10) + " KiB";
    return std::to_string(byte) + " B";
}

bool alive_together(const FramePlan& plan, const BlockPlace& a, const BlockPlace& b) {
    const LifetimeSpan &x = plan.lifetimes.spans[a.placement->resource],
                       &y = plan.lifetimes.spans[b.placement->resource];
    return x.first <= y.last && y.first <= x.last;
}

// Moves enlarged blocks apart, so that blocks alive at the same time do not overlap if the heap has enough
// room. First each block moves down, below the blocks with a smaller offset. Then blocks beyond the end of
// the heap move up again, and so do the blocks above them. `blocks` holds only enlarged blocks, sorted by
// offset.
void separate(const FramePlan& plan, const ByteScale& scale, std::vector<BlockPlace>& blocks) {
    for (size_t i = 0; i < blocks.size(); ++i)
        for (size_t above = 0; above < i; ++above)
            if (alive_together(plan, blocks[i], blocks[above]))
                blocks[i].top_px = std::max(blocks[i].top_px, blocks[above].top_px + kLeastBlock_px);
    for (size_t i = blocks.size(); i-- > 0;) {
        blocks[i].top_px = std::min(blocks[i].top_px, scale.height_px - kLeastBlock_px);
        for (size_t below = i + 1; below < blocks.size(); ++below)
            if (alive_together(plan, blocks[i], blocks[below]))
                blocks[i].top_px = std::min(blocks[i].top_px, blocks[below].top_px - kLeastBlock_px);
        blocks[i].top_px = std::max(blocks[i].top_px, 0);
    }
}

}  // namespace

int32_t ByteScale::at(uint64_t byte) const {
    return static_cast<int32_t>(
        std::lround(static_cast<double>(byte) / static_cast<double>(bytes) * height_px));
}

std::vector<ByteScale> make_byte_scales(const MemoryPlan& memory, const std::vector<uint32_t>& heaps) {
    uint64_t most_bytes = 1;
    int32_t most_px = kHeight_px;
    for (const uint32_t heap : heaps)
        if (memory.heaps[heap].size_bytes > most_bytes) {
            most_bytes = memory.heaps[heap].size_bytes;
            most_px = scale_height_px(memory, heap);
        }
    const ByteScale largest{most_bytes, most_px};
    std::vector<ByteScale> scales;
    for (const uint32_t heap : heaps) {
        const uint64_t bytes = std::max<uint64_t>(1, memory.heaps[heap].size_bytes);
        scales.push_back({bytes, std::max(kLeastHeight_px, largest.at(bytes))});
    }
    return scales;
}

std::vector<ByteTick> byte_ticks(const ByteScale& scale) {
    uint64_t step_bytes = 1;
    while (scale.at(step_bytes) < kLeastTick_px && step_bytes < scale.bytes) step_bytes *= 2;
    std::vector<ByteTick> ticks;
    for (uint64_t byte = 0; scale.at(byte) <= scale.height_px - kLabel_px; byte += step_bytes)
        ticks.push_back({scale.at(byte), byte == 0 ? "0" : tick_text(byte, step_bytes)});
    ticks.push_back({scale.height_px, bytes_text(scale.bytes)});
    return ticks;
}

std::vector<BlockPlace> place_blocks(const FramePlan& plan, uint32_t heap, const ByteScale& scale) {
    std::vector<BlockPlace> blocks, enlarged;
    for (const Placement& p : plan.memory.placements) {
        const LifetimeSpan& span = plan.lifetimes.spans[p.resource];
        if (p.heap != heap || span.first > span.last) continue;
        const int32_t top_px = scale.at(p.offset_bytes),
                      height_px = scale.at(p.offset_bytes + p.size_bytes) - top_px;
        if (height_px < kLeastBlock_px)
            enlarged.push_back({&p, top_px, kLeastBlock_px, true});
        else
            blocks.push_back({&p, top_px, height_px, false});
    }
    std::stable_sort(enlarged.begin(), enlarged.end(), [](const BlockPlace& a, const BlockPlace& b) {
        return a.placement->offset_bytes < b.placement->offset_bytes;
    });
    separate(plan, scale, enlarged);
    blocks.insert(blocks.end(), enlarged.begin(), enlarged.end());
    return blocks;
}

}  // namespace weft
