// Purpose: a scene's textures and materials in GPU memory, with one descriptor set (set 2) per material:
// lavapipe has no descriptor indexing, and one set per material costs only microseconds.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "render/descriptor_sets.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

class GpuMaterials {
 public:
    // `owned` is `scene` or null: as of GpuScene.
    [[nodiscard]] static Result<GpuMaterials> create(vk::Device& device, const scene::Scene& scene,
                                                     scene::Scene* owned);

    [[nodiscard]] VkDescriptorSetLayout layout() const { return sets_.layout.get(); }
    [[nodiscard]] VkDescriptorSet set(uint32_t material) const { return sets_.sets[material]; }

 private:
    using SamplerKey = std::tuple<scene::Filter, scene::Filter, bool, scene::Wrap, scene::Wrap>;

    Status upload_textures(vk::Device& device, const scene::Scene& scene, scene::Scene* owned);
    Status upload_constants(vk::Device& device, const scene::Scene& scene);
    void write_set(vk::Device& device, const scene::Material& material, uint32_t index);
    VkSampler sampler(vk::Device& device, const scene::TextureSlot& slot);
    VkDescriptorImageInfo image(vk::Device& device, const scene::TextureSlot& slot,
                                const vk::Image& fallback);

    DescriptorSets sets_;  // one per material
    std::vector<vk::Image> textures_;
    vk::Image white_;
    vk::Image flat_normal_;
    vk::Buffer constants_;
    uint64_t constants_stride_bytes_ = 0;
    std::map<SamplerKey, vk::SamplerHandle> samplers_;
};

}  // namespace weft::render
