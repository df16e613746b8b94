// Purpose: converts an image range to copy regions between the image and linear memory: mips one after
// another, all layers of a mip together, texels tightly packed. Colour ranges have no gaps. A depth or
// stencil region starts at a multiple of four bytes, as Vulkan requires, so its data is packed after reading.
// Units: bytes, pixels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vulkan/device/functions.h"
#include "weft/declaration.h"

namespace weft::vk {

struct ImageRegions {
    std::vector<VkBufferImageCopy> copies;
    std::vector<uint64_t> sizes_bytes;  // index: copy region
    uint64_t staging_bytes = 0;         // size with gaps
    uint64_t packed_bytes = 0;          // size without gaps
};

// Offsets start at `base_bytes`, which must be a multiple of 16.
[[nodiscard]] ImageRegions image_regions(const ResourceDecl& decl, const SubresourceRange& range,
                                         uint64_t base_bytes);
// Returns the texels without gaps. The regions' offsets refer to `staging`.
[[nodiscard]] std::vector<std::byte> pack(const ImageRegions& regions, std::span<const std::byte> staging);

}  // namespace weft::vk
