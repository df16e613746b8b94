// Purpose: the descriptor sets of the passes' ports (set 1). What a pass binds never changes while a plan
// lives, so every set is written once: one for each frame slot, which differ only in the memory of their
// Params. Errors: V411, V413.
#pragma once

#include <array>

#include "vulkan/params.h"
#include "vulkan/pass_layout.h"
#include "vulkan/samplers.h"
#include "vulkan/stand_ins.h"
#include "vulkan/views.h"

namespace weft::vk {

using SlotSets = std::array<VkDescriptorSet, kFramesInFlight>;

// What descriptors are made of; all of it lives as long as the sets.
struct DescriptorSources {
    const FramePlan& plan;
    const ResourceTable& resources;
    const ParamsMemory& params;
    ViewCache& views;
    SamplerCache& samplers;
    StandIns& stand_ins;
};

// Room for the set 1 of every pass that has one, in every frame slot. `interfaces` are by position; null
// entries have no shader.
[[nodiscard]] Result<DescriptorPoolHandle> make_descriptor_pool(
    Device& device, const std::vector<const ShaderInterface*>& interfaces);

[[nodiscard]] Result<SlotSets> make_port_sets(Device& device, VkDescriptorPool pool,
                                              DescriptorSources sources, uint32_t position,
                                              const ShaderInterface& interface, const PassLayout& layout);

}  // namespace weft::vk
