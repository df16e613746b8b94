// Purpose: the areas of images with live sizes in the frame that is recorded. An earlier frame may have used
// another area than this frame, so each copy of a resource with history has the area of the frame that wrote
// it. Units: pixels.
#pragma once

#include <vector>

#include "graph/live/live_frame.h"
#include "vulkan/memory/rings.h"

namespace weft::vk {

class FrameAreas {
 public:
    FrameAreas() = default;
    explicit FrameAreas(const FramePlan& plan);

    // Computes the areas of a frame. Call it once for each frame, before its commands are recorded.
    void begin_frame(const ResolvedGraph& graph, const Scales& scales, const Rings& rings, uint64_t frame);
    // Sets the area of the content that a copy in memory has got from the executor that this one replaces.
    void inherit(ResourceId copy, const Extent3D& area) { written_[copy] = area; }

    // Returns the area of the first mip of an image in this frame; for an image without a live size, its
    // extent.
    [[nodiscard]] const Extent3D& area(ResourceId id) const { return areas_[id]; }
    // Returns the area of a mip.
    [[nodiscard]] Extent3D area(ResourceId id, uint32_t mip) const { return mip_extent(areas_[id], mip); }
    // Returns the area of the content that resource `role` has before frame `frame`.
    [[nodiscard]] Extent3D area_before(const ResolvedGraph& graph, ResourceId role, const Rings& rings,
                                       uint64_t frame) const;
    [[nodiscard]] const std::vector<LiveNumber>& values() const { return values_; }
    [[nodiscard]] const std::vector<Extent3D>& all() const { return areas_; }

 private:
    std::vector<LiveNumber> values_;
    std::vector<Extent3D> areas_;  // Index: ResourceId.
    // The area of the frame that wrote each copy in memory; a width of 0: no frame has written the copy.
    // Index: the ResourceId that names the copy, see Rings::copy().
    std::vector<Extent3D> written_;
};

}  // namespace weft::vk
