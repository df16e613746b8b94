#include "render/gpu_light_functions.h"

#include "render/frame_data.h"
#include "scene/pictures/light_pictures.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/vk_result.h"

namespace weft::render {
namespace {

Result<vk::Image> picture_array(vk::Device& device, const scene::LightPictures& pictures) {
    static const std::vector<std::vector<uint8_t>> kWhite{{255, 255, 255, 255}};
    const std::vector<std::vector<uint8_t>>& mips = pictures.layers == 0 ? kWhite : pictures.mips;
    const uint32_t side_px = pictures.layers == 0 ? 1 : scene::kLightPictureSize_px;
    ResourceDecl decl;
    decl.name = "light pictures";
    decl.image_kind = ImageKind::d2_array;
    decl.format = Format::rgba8_srgb;
    decl.extent = {side_px, side_px, 1};
    decl.mips = static_cast<uint32_t>(mips.size());
    decl.layers = std::max(1u, pictures.layers);
    decl.usage = usage::kSampled | usage::kTransferDst;
    Result<vk::Image> image = vk::Image::create(device, decl);
    if (!image) return image;
    std::vector<std::span<const std::byte>> levels;
    for (const std::vector<uint8_t>& mip : mips) levels.push_back(std::as_bytes(std::span(mip)));
    if (Status copied = vk::upload_image(device, *image, levels); !copied) return copied.take_errors();
    return image;
}

Result<vk::SamplerHandle> picture_sampler(vk::Device& device) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = VK_FILTER_LINEAR;
    info.minFilter = VK_FILTER_LINEAR;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler sampler = VK_NULL_HANDLE;
    const VkResult made = device.fn().vkCreateSampler(device.handle(), &info, nullptr, &sampler);
    if (made != VK_SUCCESS) return vk::vk_error(made, "creating the sampler of the pictures for lights");
    return vk::SamplerHandle(device, sampler);
}

Result<vk::Buffer> function_buffer(vk::Device& device, const scene::Scene& scene,
                                   const scene::LightPictures& pictures) {
    std::vector<shared::LightFunction> functions;
    for (size_t i = 0; i < scene.light_functions.size(); ++i) {
        functions.push_back(gpu_light_function(scene.light_functions[i]));
        if (pictures.layer_of[i] != scene::kNone) functions.back().picture = pictures.layer_of[i] + 1;
    }
    // Vulkan has no empty buffers, so a scene without functions gets one unused element.
    if (functions.empty()) functions.emplace_back();
    const std::span<const std::byte> bytes = std::as_bytes(std::span(functions));
    Result<vk::Buffer> buffer = vk::Buffer::create(
        device, bytes.size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        vk::Buffer::Memory::device, "light functions");
    if (!buffer) return buffer;
    if (Status copied = vk::upload_buffer(device, *buffer, bytes); !copied) return copied.take_errors();
    return buffer;
}

}  // namespace

Result<GpuLightFunctions> GpuLightFunctions::create(vk::Device& device, const scene::Scene& scene) {
    const scene::LightPictures pictures = scene::light_pictures(scene);
    Result<vk::Buffer> functions = function_buffer(device, scene, pictures);
    if (!functions) return functions.take_errors();
    Result<vk::Image> image = picture_array(device, pictures);
    if (!image) return image.take_errors();
    Result<vk::SamplerHandle> sampler = picture_sampler(device);
    if (!sampler) return sampler.take_errors();
    GpuLightFunctions made;
    made.functions_ = std::move(*functions);
    made.pictures_ = std::move(*image);
    made.sampler_ = std::move(*sampler);
    return made;
}

VkDescriptorImageInfo GpuLightFunctions::pictures() const {
    return {sampler_.get(), pictures_.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

}  // namespace weft::render
