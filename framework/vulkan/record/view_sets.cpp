#include "vulkan/record/view_sets.h"

#include "vulkan/device/executor_errors.h"

namespace weft::vk {

Result<PassViewSets> PassViewSets::create(const FramePlan& plan, const ResourceTable& resources,
                                          const DrawSource* draws) {
    PassViewSets made;
    std::vector<ViewPlace> places;
    const PassDecl* reader = nullptr;
    const std::vector<PassId>& order = plan.schedule.order;
    for (Position position(0); position < order.size(); ++position) {
        const PassDecl& pass = plan.graph.passes[order[position]];
        if (pass.view_use == kNoId) continue;
        reader = &pass;
        const UseDecl& use = pass.uses[pass.view_use];
        const uint64_t offset_bytes = used_bytes(plan.graph.resources[use.resource], use).offset_bytes;
        made.passes_.resize(order.size());
        PassSets& sets = made.passes_[position];
        sets = {places.size(), static_cast<uint32_t>(resources.rings.period(pass))};
        for (uint32_t frame = 0; frame < sets.period; ++frame)
            for (uint32_t slot = 0; slot < kFramesInFlight; ++slot)
                places.push_back({slot, FrameResources(resources, frame).in_slot(slot).buffer(use.resource),
                                  offset_bytes});
    }
    if (reader == nullptr) return made;
    if (draws != nullptr) {
        Result<std::unique_ptr<ViewSets>> sets = draws->make_view_sets(places);
        if (!sets) return sets.take_errors();
        made.sets_ = std::move(*sets);
    }
    if (made.sets_ == nullptr)
        return pass_error(plan, *reader, "V415",
                          "the pass reads its view from a buffer, which the DrawSource of the program does "
                          "not support");
    return made;
}

VkDescriptorSet PassViewSets::set(Position position, uint64_t frame, uint32_t slot) const {
    const PassSets& pass = passes_[position];
    return sets_->set(pass.first + frame % pass.period * kFramesInFlight + slot);
}

}  // namespace weft::vk
