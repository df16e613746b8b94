// Purpose: image views for all uses of images, with the range, aspect and dimension that the shader's binding
// or the attachment needs. Equal views are created once. Errors: V411.
#pragma once

#include <map>
#include <tuple>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

class ViewCache {
 public:
    ViewCache(Device& device, const FramePlan& plan, const ResourceTable& resources)
        : device_(&device), plan_(&plan), resources_(&resources) {}

    // The view for a shader's `binding` in this frame.
    [[nodiscard]] Result<VkImageView> shader_view(const UseDecl& use, const ShaderBinding& binding,
                                                  uint64_t frame);
    // The view for an attachment: one mip; several layers give an array view.
    [[nodiscard]] Result<VkImageView> attachment_view(const UseDecl& use, uint64_t frame);

 private:
    using Key = std::tuple<ResourceId, SubresourceRange, VkImageViewType>;
    // `copy`: the resource whose memory holds the content in this frame.
    [[nodiscard]] Result<VkImageView> get(ResourceId copy, const SubresourceRange& range,
                                          VkImageViewType type);

    Device* device_;
    const FramePlan* plan_;
    const ResourceTable* resources_;
    std::map<Key, ImageViewHandle> views_;
};

[[nodiscard]] VkImageViewType view_type(ImageDim dim, bool arrayed);
// The aspect of a sampled view of a depth-stencil image: such a view must have exactly one aspect.
[[nodiscard]] AspectMask shader_aspects(AspectMask aspects, NumericClass numeric);

}  // namespace weft::vk
