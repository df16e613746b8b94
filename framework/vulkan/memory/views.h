// Purpose: an image view for every use of an image: its range and aspect, in the dimension that the shader's
// binding or the attachment wants. Equal views are made once.
// Errors: V411.
#pragma once

#include <map>
#include <tuple>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

class ViewCache {
 public:
    ViewCache(Device& device, const FramePlan& plan, const ResourceTable& resources)
        : device_(&device), plan_(&plan), resources_(&resources) {}

    // As a shader sees it through `binding` in this frame.
    [[nodiscard]] Result<VkImageView> shader_view(const UseDecl& use, const ShaderBinding& binding,
                                                  uint64_t frame);
    // As an attachment: one mip; more layers than one make it an array.
    [[nodiscard]] Result<VkImageView> attachment_view(const UseDecl& use, uint64_t frame);

 private:
    using Key = std::tuple<ResourceId, SubresourceRange, VkImageViewType>;
    // `copy`: where the memory was placed.
    [[nodiscard]] Result<VkImageView> get(ResourceId copy, const SubresourceRange& range,
                                          VkImageViewType type);

    Device* device_;
    const FramePlan* plan_;
    const ResourceTable* resources_;
    std::map<Key, ImageViewHandle> views_;
};

[[nodiscard]] VkImageViewType view_type(ImageDim dim, bool arrayed);
// What a sampled view of a depth-stencil image shows: a view for sampling has one aspect only.
[[nodiscard]] AspectMask shader_aspects(AspectMask aspects, NumericClass numeric);

}  // namespace weft::vk
