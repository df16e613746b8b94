// Purpose: creates the image views for shader bindings and attachments. Range, aspect and dimension of a view
// are those that the binding or the attachment needs. Equal views are created only once. Errors: V411 (a view
// could not be created).
#pragma once

#include <map>
#include <tuple>

#include "vulkan/memory/resource_table.h"

namespace weft::vk {

class ViewCache {
 public:
    ViewCache(Device& device, const FramePlan& plan, const ResourceTable& resources)
        : device_(&device), plan_(&plan), resources_(&resources) {}

    // Returns the image view that element `element` of a shader's `binding` needs in frame `frame`.
    [[nodiscard]] Result<VkImageView> shader_view(const UseDecl& use, uint32_t element,
                                                  const ShaderBinding& binding, uint64_t frame);
    // Returns the image view for an attachment. The view has one mip level; with several layers it is an
    // array view.
    [[nodiscard]] Result<VkImageView> attachment_view(const UseDecl& use, uint64_t frame);
    // Returns a view of the whole range of a use, for passes in C++. Returns null for buffers, and for images
    // that the pass only copies, blits or clears.
    [[nodiscard]] Result<VkImageView> port_view(const UseDecl& use, uint64_t frame);

 private:
    using Key = std::tuple<ResourceId, SubresourceRange, VkImageViewType>;
    // `copy` is a result of Rings::copy(): the resource whose memory the view shows. For a resource with
    // history, it changes from frame to frame.
    [[nodiscard]] Result<VkImageView> get(ResourceId copy, const SubresourceRange& range,
                                          VkImageViewType type);

    Device* device_;
    const FramePlan* plan_;
    const ResourceTable* resources_;
    std::map<Key, ImageViewHandle> views_;
};

[[nodiscard]] VkImageViewType view_type(ImageDim dim, bool arrayed);
// Returns the aspect of a shader's view of an image. A view of a depth-stencil image must have exactly one
// aspect: stencil if the shader reads unsigned integers, else depth.
[[nodiscard]] AspectMask shader_aspects(AspectMask aspects, NumericClass numeric);

}  // namespace weft::vk
