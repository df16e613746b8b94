#include "graph/plan_page_bytes.h"

#include <algorithm>

namespace weft {
namespace {

constexpr int32_t kHeight_px = 320;
constexpr int32_t kLeast_px = 3, kMostLeast_px = 20;  // of the smallest interval that somebody lies in

bool somebody_lies_in(const MemoryPlan& memory, uint32_t heap, uint64_t first, uint64_t end) {
    return std::any_of(memory.placements.begin(), memory.placements.end(), [&](const Placement& p) {
        return p.heap == heap && p.offset_bytes < end && first < p.offset_bytes + p.size_bytes;
    });
}

}  // namespace

int32_t ByteScale::at(uint64_t byte) const {
    const auto it = std::lower_bound(bytes.begin(), bytes.end(), byte);
    return it == bytes.end() ? height_px() : y_px[static_cast<size_t>(it - bytes.begin())];
}

ByteScale make_byte_scale(const MemoryPlan& memory, uint32_t heap) {
    ByteScale scale;
    scale.bytes = {0, memory.heaps[heap].size_bytes};
    for (const Placement& p : memory.placements)
        if (p.heap == heap)
            scale.bytes.insert(scale.bytes.end(), {p.offset_bytes, p.offset_bytes + p.size_bytes});
    std::sort(scale.bytes.begin(), scale.bytes.end());
    scale.bytes.erase(std::unique(scale.bytes.begin(), scale.bytes.end()), scale.bytes.end());
    const auto intervals = static_cast<int32_t>(std::max<size_t>(1, scale.bytes.size() - 1));
    const int32_t least_px = std::clamp(kHeight_px / intervals, kLeast_px, kMostLeast_px);
    int32_t y_px = 0;
    for (size_t i = 0; i < scale.bytes.size(); ++i) {
        if (i > 0) {
            const double share = static_cast<double>(scale.bytes[i] - scale.bytes[i - 1]) /
                                 static_cast<double>(scale.bytes.back());
            const bool used = somebody_lies_in(memory, heap, scale.bytes[i - 1], scale.bytes[i]);
            const int32_t room_px = used ? least_px : kLeast_px;
            const auto fair_px = static_cast<int32_t>(share * kHeight_px);
            scale.exact = scale.exact && fair_px >= room_px;
            y_px += std::max(fair_px, room_px);
        }
        scale.y_px.push_back(y_px);
    }
    return scale;
}

}  // namespace weft
