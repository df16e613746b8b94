#include "weft/vulkan/native.h"

#include "vulkan/device/to_vk.h"

namespace weft::vk {

NativeDevice native(const Device& device) {
    return {device.instance(), device.physical(), device.handle(), device.queue()};
}

NativeImage native(const Image& image) {
    const ResourceDecl& decl = image.decl();
    NativeImage result{image.handle(), image.view(), to_vk(decl.format), to_vk(decl.extent)};
    if (decl.import) result.layout = to_vk(decl.import->exit.layout);
    return result;
}

}  // namespace weft::vk
