// Purpose: the descriptor sets for the ports of passes (set 1). The bindings of a pass never change during
// the lifetime of a plan, except for resources with history. The copies of such a resource rotate. The period
// of a pass is the number of frames after which it uses the same copies again. A pass has one set for each
// frame of its period and each frame slot, and each set is written only once. Sets of different slots differ
// only in the memory of their Params block. Errors: V411 (an image view could not be created), V413 (a pool,
// set or sampler could not be created), those of DummyDescriptors.
#pragma once

#include <array>

#include "vulkan/memory/views.h"
#include "vulkan/pipelines/dummy_descriptors.h"
#include "vulkan/pipelines/params.h"
#include "vulkan/pipelines/pass_layout.h"
#include "vulkan/pipelines/samplers.h"

namespace weft::vk {

using SlotSets = std::array<VkDescriptorSet, kFramesInFlight>;

// The objects that descriptors refer to. All of them must live as long as the descriptor sets.
struct DescriptorSources {
    const FramePlan& plan;
    FrameResources resources;
    const ParamsMemory& params;
    ViewCache& views;
    SamplerCache& samplers;
    DummyDescriptors& dummies;
};

// The descriptor sets that one pass needs from the pool.
struct SetDemand {
    const ShaderInterface* interface = nullptr;
    const PassDecl* pass = nullptr;
    // The period of the pass: the number of frames after which it uses the same copies of its resources
    // again. Each frame of the period needs one set for every frame slot.
    uint32_t ring_phases = 1;
    // The number of variants of the pass. Each needs sets of its own.
    uint32_t variants = 1;
};
[[nodiscard]] Result<DescriptorPoolHandle> make_descriptor_pool(Device& device, const ResolvedGraph& graph,
                                                                const std::vector<SetDemand>& demands);

// Makes descriptor sets for one variant of a pass and one frame of the pass's period. The result has one set
// for each frame slot. `pass` is the pass at index `position` of the execution order, in that variant.
// sources.resources selects the copies of resources with history for that frame.
[[nodiscard]] Result<SlotSets> make_port_sets(Device& device, VkDescriptorPool pool,
                                              DescriptorSources sources, Position position,
                                              const PassDecl& pass, const ShaderInterface& interface,
                                              const PassLayout& layout);

}  // namespace weft::vk
