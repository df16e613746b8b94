// Purpose: converts an image range to copy regions between the image and linear memory. In linear memory, one
// mip level follows another, with all layers of a level together and texels tightly packed. Colour ranges
// have no gaps. A depth or stencil region starts at a multiple of four bytes, as Vulkan requires; pack()
// removes these gaps after reading. Units: bytes, pixels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vulkan/device/functions.h"
#include "weft/declaration.h"

namespace weft::vk {

struct ImageRegions {
    std::vector<VkBufferImageCopy> copies;
    // Size of each copy region in bytes.
    std::vector<uint64_t> sizes_bytes;
    // Size of all regions in staging memory in bytes, including the gaps between them.
    uint64_t staging_bytes = 0;
    // Size of all regions in bytes, without the gaps.
    uint64_t packed_bytes = 0;
};

// Returns one copy region for each mip level and aspect of `range`. The buffer offsets of the regions start
// at `base_bytes`, which must be a multiple of 16, the size of the largest texels in bytes.
[[nodiscard]] ImageRegions image_regions(const ResourceDecl& decl, const SubresourceRange& range,
                                         uint64_t base_bytes);
// Returns the texels of all regions without gaps. The buffer offsets of the regions are offsets into
// `staging`.
[[nodiscard]] std::vector<std::byte> pack(const ImageRegions& regions, std::span<const std::byte> staging);

}  // namespace weft::vk
