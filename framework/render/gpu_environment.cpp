#include "render/gpu_environment.h"

#include <algorithm>

#include "vulkan/device/functions.h"
#include "vulkan/device/vk_result.h"

namespace weft::render {
namespace {

VkSamplerCreateInfo sampler_info() {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = VK_FILTER_LINEAR;
    info.minFilter = VK_FILTER_LINEAR;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    info.addressModeU = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE;
    return info;
}

Result<vk::Image> upload_picture(vk::Device& device, const char* name, uint32_t width_px, uint32_t height_px,
                                 const std::vector<std::vector<uint32_t>>& picture_mips) {
    static const std::vector<std::vector<uint32_t>> kBlack{{0}};
    const std::vector<std::vector<uint32_t>>& mips = picture_mips.empty() ? kBlack : picture_mips;
    ResourceDecl decl;
    decl.name = name;
    decl.format = Format::rgb9e5;
    decl.extent = {std::max(1u, width_px), std::max(1u, height_px), 1};
    decl.mips = static_cast<uint32_t>(mips.size());
    decl.usage = usage::kSampled | usage::kTransferDst;
    Result<vk::Image> image = vk::Image::create(device, decl);
    if (!image) return image.take_errors();
    std::vector<std::span<const std::byte>> levels;
    for (const std::vector<uint32_t>& mip : mips) levels.push_back(std::as_bytes(std::span(mip)));
    if (Status copied = vk::upload_image(device, *image, levels); !copied) return copied.take_errors();
    return image;
}

}  // namespace

Result<GpuEnvironment> GpuEnvironment::create(vk::Device& device, const scene::Environment& environment) {
    Result<vk::Image> image =
        upload_picture(device, "environment", environment.width_px, environment.height_px, environment.mips);
    if (!image) return image.take_errors();
    const scene::LightPicture& light = environment.light;
    Result<vk::Image> light_image =
        upload_picture(device, "environment_light", light.width_px, light.height_px, light.mips);
    if (!light_image) return light_image.take_errors();
    const VkSamplerCreateInfo info = sampler_info();
    VkSampler sampler = VK_NULL_HANDLE;
    if (const VkResult made = device.fn().vkCreateSampler(device.handle(), &info, nullptr, &sampler);
        made != VK_SUCCESS)
        return vk::vk_error(made, "creating the sampler of the environment");
    GpuEnvironment result;
    result.image_ = std::move(*image);
    result.light_image_ = std::move(*light_image);
    result.sampler_ = vk::SamplerHandle(device, sampler);
    return result;
}

VkDescriptorImageInfo GpuEnvironment::descriptor() const {
    return {sampler_.get(), image_.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

VkDescriptorImageInfo GpuEnvironment::light_descriptor() const {
    return {sampler_.get(), light_image_.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

}  // namespace weft::render
