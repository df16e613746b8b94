// Purpose: a scene's textures and materials in GPU memory, with one descriptor set (set 2) per material.
// Draw lists do not use descriptor indexing, because lavapipe does not support it, and binding one set per
// material costs only microseconds. Graphs can import the textures as a table (material_textures.h).
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "render/descriptor_sets.h"
#include "shared/material.glsl"
#include "vulkan/memory/uploader.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

class GpuMaterials {
 public:
    // `owned` is either null or `&scene`. If it is not null, each texture of the scene is freed after it is
    // copied to the GPU. `has_table`: graphs can import the textures as the table "materialTextures".
    [[nodiscard]] static Result<GpuMaterials> create(vk::Device& device, const scene::Scene& scene,
                                                     scene::Scene* owned, vk::Uploader& uploader,
                                                     bool has_table);

    [[nodiscard]] VkDescriptorSetLayout layout() const { return sets_.layout.get(); }
    [[nodiscard]] VkDescriptorSet set(uint32_t material) const { return sets_.sets[material]; }
    // Returns the views of the import "materialTextures"; empty without a table.
    [[nodiscard]] const std::vector<VkImageView>& table() const { return table_; }

 private:
    using SamplerKey = std::tuple<scene::Filter, scene::Filter, bool, scene::Wrap, scene::Wrap>;

    Status upload_textures(vk::Device& device, const scene::Scene& scene, scene::Scene* owned,
                           vk::Uploader& uploader);
    Status upload_constants(vk::Device& device, const std::vector<shared::Material>& constants,
                            vk::Uploader& uploader);
    void write_set(vk::Device& device, const scene::Material& material, uint32_t index);
    VkSampler sampler(vk::Device& device, const scene::TextureSlot& slot);
    VkDescriptorImageInfo image(vk::Device& device, const scene::TextureSlot& slot,
                                const vk::Image& fallback);

    // One descriptor set for each material.
    DescriptorSets sets_;
    std::vector<vk::Image> textures_;
    vk::Image white_;
    vk::Image flat_normal_;
    std::vector<VkImageView> table_;
    vk::Buffer constants_;
    uint64_t constants_stride_bytes_ = 0;
    std::map<SamplerKey, vk::SamplerHandle> samplers_;
};

}  // namespace weft::render
