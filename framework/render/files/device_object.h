// Purpose: the image or the buffer of a resource that a plan does not place, with its own memory.
#pragma once

#include "weft/vulkan/memory.h"

namespace weft::render {

// One of the two members is empty.
struct DeviceObject {
    vk::Image image;
    vk::Buffer buffer;
};

// Creates an image or a buffer for this declaration. A buffer gets the usage `buffer_usage`.
[[nodiscard]] Result<DeviceObject> create_object(vk::Device& device, const ResourceDecl& decl,
                                                 VkBufferUsageFlags buffer_usage);

}  // namespace weft::render
