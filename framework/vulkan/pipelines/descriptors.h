// Purpose: the descriptor sets of the passes' ports (set 1). What a pass binds never changes while a plan
// lives, but for the copies of resources with history, which take turns. So every set is written once: one
// for each turn and frame slot; those of the slots differ only in the memory of their Params.
// Errors: V411, V413.
#pragma once

#include <array>

#include "vulkan/memory/views.h"
#include "vulkan/pipelines/params.h"
#include "vulkan/pipelines/pass_layout.h"
#include "vulkan/pipelines/samplers.h"
#include "vulkan/pipelines/stand_ins.h"

namespace weft::vk {

using SlotSets = std::array<VkDescriptorSet, kFramesInFlight>;

// What descriptors are made of; all of it lives as long as the sets.
struct DescriptorSources {
    const FramePlan& plan;
    FrameResources resources;
    const ParamsMemory& params;
    ViewCache& views;
    SamplerCache& samplers;
    StandIns& stand_ins;
};

// How many sets of one pass the pool must hold.
struct SetDemand {
    const ShaderInterface* interface = nullptr;
    uint32_t turns = 1;  // the sets of all slots count as one turn
};
[[nodiscard]] Result<DescriptorPoolHandle> make_descriptor_pool(Device& device,
                                                                const std::vector<SetDemand>& demands);

// The sets of one turn: those of the frame that `sources` is about.
[[nodiscard]] Result<SlotSets> make_port_sets(Device& device, VkDescriptorPool pool,
                                              DescriptorSources sources, uint32_t position,
                                              const ShaderInterface& interface, const PassLayout& layout);

}  // namespace weft::vk
