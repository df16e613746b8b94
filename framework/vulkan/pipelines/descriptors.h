// Purpose: the descriptor sets for the ports of passes (set 1). The bindings of a pass never change during
// the lifetime of a plan, except for resources with history, whose copies rotate. So every set is written
// only once: one set per ring phase and frame slot. The sets of different slots differ only in the
// memory of their Params. Errors: V411, V413.
#pragma once

#include <array>

#include "vulkan/memory/views.h"
#include "vulkan/pipelines/dummy_descriptors.h"
#include "vulkan/pipelines/params.h"
#include "vulkan/pipelines/pass_layout.h"
#include "vulkan/pipelines/samplers.h"

namespace weft::vk {

using SlotSets = std::array<VkDescriptorSet, kFramesInFlight>;

// The objects that descriptors refer to; all must live as long as the sets.
struct DescriptorSources {
    const FramePlan& plan;
    FrameResources resources;
    const ParamsMemory& params;
    ViewCache& views;
    SamplerCache& samplers;
    DummyDescriptors& dummies;
};

// Number of sets that one pass needs from the pool.
struct SetDemand {
    const ShaderInterface* interface = nullptr;
    uint32_t ring_phases = 1;  // one ring phase has a set for each slot
};
[[nodiscard]] Result<DescriptorPoolHandle> make_descriptor_pool(Device& device,
                                                                const std::vector<SetDemand>& demands);

// The sets of the ring phase that `sources` describes.
[[nodiscard]] Result<SlotSets> make_port_sets(Device& device, VkDescriptorPool pool,
                                              DescriptorSources sources, uint32_t position,
                                              const ShaderInterface& interface, const PassLayout& layout);

}  // namespace weft::vk
