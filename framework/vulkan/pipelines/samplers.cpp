#include "vulkan/pipelines/samplers.h"

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {

static_assert(kNoMaxLod == VK_LOD_CLAMP_NONE);

Result<VkSampler> SamplerCache::get(const SamplerDecl& decl, bool integer_border) {
    const Key key{decl.filter,     decl.mip_filter, decl.wrap,    decl.compare, decl.reduction,
                  decl.anisotropy, decl.lod_bias,   decl.min_lod, decl.max_lod, integer_border};
    if (const auto it = samplers_.find(key); it != samplers_.end()) return it->second.get();
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = to_vk(decl.filter);
    info.mipmapMode = mip_filter_to_vk(decl.mip_filter);
    info.addressModeU = info.addressModeV = info.addressModeW = to_vk(decl.wrap);
    info.mipLodBias = decl.lod_bias;
    info.minLod = decl.min_lod;
    info.maxLod = decl.max_lod;
    info.anisotropyEnable = decl.anisotropy > 1 ? VK_TRUE : VK_FALSE;
    info.maxAnisotropy = decl.anisotropy;
    info.compareEnable = decl.compare ? VK_TRUE : VK_FALSE;
    info.compareOp = to_vk(decl.compare.value_or(CompareOp::never));
    info.borderColor =
        integer_border ? VK_BORDER_COLOR_INT_TRANSPARENT_BLACK : VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;
    VkSamplerReductionModeCreateInfo reduction{VK_STRUCTURE_TYPE_SAMPLER_REDUCTION_MODE_CREATE_INFO};
    reduction.reductionMode = to_vk(decl.reduction);
    // A device without the feature samplerFilterMinmax does not allow this structure, so the structure is
    // added only if the reduction is not the ordinary average.
    if (decl.reduction != SamplerReduction::average) info.pNext = &reduction;
    VkSampler sampler = VK_NULL_HANDLE;
    const VkResult result = device_->fn().vkCreateSampler(device_->handle(), &info, nullptr, &sampler);
    if (result != VK_SUCCESS) return failed_call("V413", "creating a sampler", result);
    samplers_.emplace(key, SamplerHandle(*device_, sampler));
    return sampler;
}

}  // namespace weft::vk
