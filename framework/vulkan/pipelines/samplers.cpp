#include "vulkan/pipelines/samplers.h"

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {

Result<VkSampler> SamplerCache::get(const SamplerDecl& decl, bool integer_border) {
    const Key key{decl.filter, decl.mip_filter, decl.wrap, decl.compare_greater_equal, integer_border};
    if (const auto it = samplers_.find(key); it != samplers_.end()) return it->second.get();
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = to_vk(decl.filter);
    info.mipmapMode = mip_filter_to_vk(decl.mip_filter);
    info.addressModeU = info.addressModeV = info.addressModeW = to_vk(decl.wrap);
    info.maxLod = VK_LOD_CLAMP_NONE;
    info.compareEnable = decl.compare_greater_equal ? VK_TRUE : VK_FALSE;
    info.compareOp = decl.compare_greater_equal ? VK_COMPARE_OP_GREATER_OR_EQUAL : VK_COMPARE_OP_NEVER;
    info.borderColor =
        integer_border ? VK_BORDER_COLOR_INT_TRANSPARENT_BLACK : VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;
    VkSampler sampler = VK_NULL_HANDLE;
    const VkResult result = device_->fn().vkCreateSampler(device_->handle(), &info, nullptr, &sampler);
    if (result != VK_SUCCESS) return failed_call("V413", "creating a sampler", result);
    samplers_.emplace(key, SamplerHandle(*device_, sampler));
    return sampler;
}

}  // namespace weft::vk
