#include "vulkan/memory/frame_areas.h"

namespace weft::vk {

FrameAreas::FrameAreas(const FramePlan& plan) {
    for (const ResourceDecl& resource : plan.graph.resources) areas_.push_back(resource.extent);
    written_.assign(areas_.size(), Extent3D{0, 0, 0});
}

void FrameAreas::begin_frame(const ResolvedGraph& graph, const Scales& scales, const Rings& rings,
                             uint64_t frame) {
    if (graph.live_values.empty()) return;
    evaluate_live(graph, scales, values_);
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDecl& image = graph.resources[id];
        if (image.area == kNoId) continue;
        const Extent3D now = live_area(image, values_);
        Extent3D& written = written_[rings.copy(id, frame)];
        if (image.age == 0 || written.width == 0) written = now;
        areas_[id] = written;
    }
}

Extent3D FrameAreas::area_before(const ResolvedGraph& graph, ResourceId role, const Rings& rings,
                                 uint64_t frame) const {
    const Extent3D& written = written_[rings.copy(role, frame)];
    return written.width == 0 ? graph.resources[role].extent : written;
}

}  // namespace weft::vk
