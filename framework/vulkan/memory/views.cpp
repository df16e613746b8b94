#include "vulkan/memory/views.h"

#include "vulkan/device/executor_errors.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {

VkImageViewType view_type(ImageDim dim, bool arrayed) {
    switch (dim) {
        case ImageDim::d1:
            return arrayed ? VK_IMAGE_VIEW_TYPE_1D_ARRAY : VK_IMAGE_VIEW_TYPE_1D;
        case ImageDim::d2:
            return arrayed ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
        case ImageDim::d3:
            return VK_IMAGE_VIEW_TYPE_3D;
        case ImageDim::cube:
            return arrayed ? VK_IMAGE_VIEW_TYPE_CUBE_ARRAY : VK_IMAGE_VIEW_TYPE_CUBE;
    }
    return VK_IMAGE_VIEW_TYPE_2D;
}

AspectMask shader_aspects(AspectMask aspects, NumericClass numeric) {
    if (aspects & aspect::kColor) return aspect::kColor;
    const bool wants_stencil = numeric == NumericClass::uint && (aspects & aspect::kStencil);
    if (wants_stencil || !(aspects & aspect::kDepth)) return aspect::kStencil;
    return aspect::kDepth;
}

Result<VkImageView> ViewCache::shader_view(const UseDecl& use, uint32_t element, const ShaderBinding& binding,
                                           uint64_t frame) {
    SubresourceRange range = element_range(use, element);
    range.aspects = shader_aspects(range.aspects, binding.numeric);
    return get(resources_->rings.copy(use.resource, frame), range, view_type(binding.dim, binding.arrayed));
}

Result<VkImageView> ViewCache::attachment_view(const UseDecl& use, uint64_t frame) {
    // An attachment view must have all aspects of its format, even if the pass uses only one of them.
    SubresourceRange range = use.range;
    range.aspects = plan_->graph.resources[use.resource].aspects;
    return get(resources_->rings.copy(use.resource, frame), range, view_type(ImageDim::d2, range.layers > 1));
}

Result<VkImageView> ViewCache::port_view(const UseDecl& use, uint64_t frame) {
    constexpr UsageMask attachment = usage::kColorAttachment | usage::kDepthAttachment;
    const ResourceDecl& decl = plan_->graph.resources[use.resource];
    const UsageMask used = usage_of(use.access);
    if (decl.kind == ResourceKind::buffer) return VkImageView{VK_NULL_HANDLE};
    if ((used & attachment) != 0) return attachment_view(use, frame);
    if ((used & (usage::kSampled | usage::kStorage)) == 0) return VkImageView{VK_NULL_HANDLE};
    SubresourceRange range = use.range;
    range.aspects = shader_aspects(range.aspects, NumericClass::float_like);
    const bool arrayed = range.layers > 1;
    const bool whole = range.layers == decl.layers && (used & usage::kStorage) == 0;
    const bool cube = decl.image_kind == ImageKind::cube || decl.image_kind == ImageKind::cube_array;
    VkImageViewType type = view_type(ImageDim::d2, arrayed);
    if (decl.image_kind == ImageKind::d3) type = VK_IMAGE_VIEW_TYPE_3D;
    if (cube && whole) type = view_type_to_vk(decl.image_kind);
    return get(resources_->rings.copy(use.resource, frame), range, type);
}

Result<VkImageView> ViewCache::get(ResourceId copy, const SubresourceRange& range, VkImageViewType type) {
    const Key key{copy, range, type};
    if (const auto it = views_.find(key); it != views_.end()) return it->second.get();
    const ResourceDecl& decl = plan_->graph.resources[copy];
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = resources_->images[copy];
    info.viewType = type;
    info.format = to_vk(decl.format);
    info.subresourceRange = to_vk(range);
    VkImageView view = VK_NULL_HANDLE;
    const VkResult result = device_->fn().vkCreateImageView(device_->handle(), &info, nullptr, &view);
    const std::string name = decl.name + " " + range_text(decl, range);
    if (result != VK_SUCCESS) return failed_call("V411", "creating a view of image \"" + name + "\"", result);
    device_->name(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<uint64_t>(view), name);
    views_.emplace(key, ImageViewHandle(*device_, view));
    return view;
}

}  // namespace weft::vk
