// Purpose: an image range as copy regions between the image and linear memory: one mip after another, all
// layers of a mip together, texels tightly packed. Colour ranges have no gaps; a depth or stencil region
// starts at the next multiple of four bytes, as Vulkan asks, so its data is packed when it is read. Units:
// bytes, pixels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "weft/declaration.h"
#include "weft/vulkan/functions.h"

namespace weft::vk {

struct ImageRegions {
    std::vector<VkBufferImageCopy> copies;
    std::vector<uint64_t> sizes_bytes;  // by copy
    uint64_t staging_bytes = 0;         // with gaps
    uint64_t packed_bytes = 0;          // without
};

// Offsets count from `base_bytes`, which is a multiple of 16.
[[nodiscard]] ImageRegions image_regions(const ResourceDecl& decl, const SubresourceRange& range,
                                         uint64_t base_bytes);
// The texels without gaps. `staging` is the memory that the regions' offsets count in.
[[nodiscard]] std::vector<std::byte> pack(const ImageRegions& regions, std::span<const std::byte> staging);

}  // namespace weft::vk
