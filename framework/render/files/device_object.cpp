#include "render/files/device_object.h"

namespace weft::render {

Result<DeviceObject> create_object(vk::Device& device, const ResourceDecl& decl,
                                   VkBufferUsageFlags buffer_usage) {
    DeviceObject object;
    if (decl.kind == ResourceKind::buffer) {
        Result<vk::Buffer> buffer =
            vk::Buffer::create(device, decl.size_bytes, buffer_usage, vk::Buffer::Memory::device, decl.name);
        if (!buffer) return buffer.take_errors();
        object.buffer = std::move(*buffer);
    } else {
        Result<vk::Image> image = vk::Image::create(device, decl);
        if (!image) return image.take_errors();
        object.image = std::move(*image);
    }
    return object;
}

}  // namespace weft::render
