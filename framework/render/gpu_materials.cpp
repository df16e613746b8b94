#include "render/gpu_materials.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "render/imports/material_textures.h"
#include "render/scene_bindings.h"
#include "vulkan/device/functions.h"

namespace weft::render {
namespace {

constexpr uint32_t kTexturesPerMaterial = 6;

ResourceDecl texture_decl(const std::string& name, uint32_t width_px, uint32_t height_px, uint32_t mips,
                          scene::ColorSpace space) {
    ResourceDecl decl;
    decl.name = name;
    decl.format = space == scene::ColorSpace::srgb ? Format::rgba8_srgb : Format::rgba8;
    decl.extent = {width_px, height_px, 1};
    decl.mips = mips;
    decl.usage = usage::kSampled | usage::kTransferDst;
    return decl;
}

Result<vk::Image> uploaded(vk::Device& device, vk::Uploader& uploader, const scene::Texture& texture) {
    Result<vk::Image> image = vk::Image::create(
        device, texture_decl(texture.name, texture.width_px, texture.height_px,
                             static_cast<uint32_t>(texture.mips.size()), texture.color_space));
    if (!image) return image;
    std::vector<std::span<const std::byte>> levels;
    for (const std::vector<uint8_t>& mip : texture.mips) levels.push_back(std::as_bytes(std::span(mip)));
    if (Status copied = uploader.image(*image, levels); !copied) return copied.take_errors();
    return image;
}

Result<vk::Image> single_texel(vk::Device& device, vk::Uploader& uploader, const char* name,
                               std::vector<uint8_t> rgba) {
    return uploaded(device, uploader,
                    scene::Texture{name, 1, 1, scene::ColorSpace::linear, {std::move(rgba)}});
}

VkSamplerAddressMode address_mode(scene::Wrap wrap) {
    switch (wrap) {
        case scene::Wrap::repeat:
            return VK_SAMPLER_ADDRESS_MODE_REPEAT;
        case scene::Wrap::mirrored_repeat:
            return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
        case scene::Wrap::clamp_to_edge:
            return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    }
    return VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

VkFilter filter(scene::Filter f) {
    return f == scene::Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
}

}  // namespace

Result<GpuMaterials> GpuMaterials::create(vk::Device& device, const scene::Scene& scene, scene::Scene* owned,
                                          vk::Uploader& uploader, bool has_table) {
    GpuMaterials materials;
    Result<DescriptorSets> sets = DescriptorSets::create(
        device, layout_bindings(2), static_cast<uint32_t>(scene.materials.size()), "materials");
    if (!sets) return sets.take_errors();
    materials.sets_ = std::move(*sets);
    if (Status s = materials.upload_textures(device, scene, owned, uploader); !s) return s.take_errors();
    const std::vector<shared::Material> constants =
        has_table ? gpu_materials(scene) : gpu_materials_without_table(scene);
    if (Status s = materials.upload_constants(device, constants, uploader); !s) return s.take_errors();
    for (uint32_t i = 0; i < scene.materials.size(); ++i) materials.write_set(device, scene.materials[i], i);
    if (!has_table) return materials;
    materials.table_ = {materials.white_.view(), materials.flat_normal_.view()};
    for (const uint32_t texture : order_textures(scene).textures)
        materials.table_.push_back(materials.textures_[texture].view());
    return materials;
}

Status GpuMaterials::upload_textures(vk::Device& device, const scene::Scene& scene, scene::Scene* owned,
                                     vk::Uploader& uploader) {
    for (size_t i = 0; i < scene.textures.size(); ++i) {
        Result<vk::Image> image = uploaded(device, uploader, scene.textures[i]);
        if (!image) return image.take_errors();
        textures_.push_back(std::move(*image));
        if (owned != nullptr) owned->textures[i].mips = {};
    }
    Result<vk::Image> white = single_texel(device, uploader, "white", {255, 255, 255, 255});
    if (!white) return white.take_errors();
    Result<vk::Image> flat = single_texel(device, uploader, "flat normal", {128, 128, 255, 255});
    if (!flat) return flat.take_errors();
    white_ = std::move(*white);
    flat_normal_ = std::move(*flat);
    return Unit{};
}

Status GpuMaterials::upload_constants(vk::Device& device, const std::vector<shared::Material>& constants,
                                      vk::Uploader& uploader) {
    // The constants of each material start at a multiple of 256 bytes. 256 is the largest
    // minUniformBufferOffsetAlignment that Vulkan allows.
    constants_stride_bytes_ = (sizeof(shared::Material) + 255) / 256 * 256;
    std::vector<std::byte> bytes(std::max<size_t>(1, constants.size()) * constants_stride_bytes_);
    for (size_t i = 0; i < constants.size(); ++i)
        std::memcpy(bytes.data() + i * constants_stride_bytes_, &constants[i], sizeof constants[i]);
    Result<vk::Buffer> buffer = vk::Buffer::create(
        device, bytes.size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        vk::Buffer::Memory::device, "scene materials");
    if (!buffer) return buffer.take_errors();
    constants_ = std::move(*buffer);
    return uploader.buffer(constants_, bytes);
}

void GpuMaterials::write_set(vk::Device& device, const scene::Material& m, uint32_t index) {
    const VkDescriptorBufferInfo buffer{constants_.handle(), index * constants_stride_bytes_,
                                        sizeof(shared::Material)};
    const std::array<VkDescriptorImageInfo, kTexturesPerMaterial> images{
        image(device, m.base_color_texture, white_),   image(device, m.metallic_roughness_texture, white_),
        image(device, m.normal_texture, flat_normal_), image(device, m.occlusion_texture, white_),
        image(device, m.emissive_texture, white_),     image(device, m.anisotropy_texture, white_)};
    write_buffers(device, set(index), 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {&buffer, 1});
    write_images(device, set(index), 1, images);
}

VkDescriptorImageInfo GpuMaterials::image(vk::Device& device, const scene::TextureSlot& slot,
                                          const vk::Image& fallback) {
    const vk::Image& source = slot.texture < textures_.size() ? textures_[slot.texture] : fallback;
    return {sampler(device, slot), source.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

VkSampler GpuMaterials::sampler(vk::Device& device, const scene::TextureSlot& slot) {
    const SamplerKey key{slot.mag, slot.min, slot.mipmapped, slot.wrap_u, slot.wrap_v};
    const auto found = samplers_.find(key);
    if (found != samplers_.end()) return found->second.get();
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = filter(slot.mag);
    info.minFilter = filter(slot.min);
    info.mipmapMode =
        slot.min == scene::Filter::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = address_mode(slot.wrap_u);
    info.addressModeV = address_mode(slot.wrap_v);
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = slot.mipmapped ? VK_LOD_CLAMP_NONE : 0.25f;
    VkSampler handle = VK_NULL_HANDLE;
    if (device.fn().vkCreateSampler(device.handle(), &info, nullptr, &handle) != VK_SUCCESS)
        return VK_NULL_HANDLE;
    return samplers_.emplace(key, vk::SamplerHandle(device, handle)).first->second.get();
}

}  // namespace weft::render
