#include "vulkan/memory/image_regions.h"

#include <algorithm>
#include <array>

#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

// Returns the number of bytes per texel when one aspect is copied. For colour this is the texel size of the
// format.
uint64_t texel_bytes(Format format, AspectMask aspect) {
    if (aspect == aspect::kStencil) return 1;
    if (aspect == aspect::kDepth) return format == Format::d16 ? 2 : 4;
    return format_info(format).bytes_per_texel;
}

uint64_t round_up(uint64_t value, uint64_t multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

}  // namespace

ImageRegions image_regions(const ResourceDecl& decl, const SubresourceRange& range, uint64_t base_bytes) {
    ImageRegions out;
    uint64_t cursor = 0;
    constexpr std::array<AspectMask, 3> kAspects{aspect::kColor, aspect::kDepth, aspect::kStencil};
    for (uint32_t mip = range.mip; mip < range.mip + range.mips; ++mip) {
        const Extent3D extent = mip_extent(decl.extent, mip);
        for (const AspectMask aspect : kAspects) {
            if (!(range.aspects & aspect)) continue;
            const uint64_t texel = texel_bytes(decl.format, aspect);
            cursor = round_up(cursor, aspect == aspect::kColor ? texel : std::max<uint64_t>(texel, 4));
            const uint64_t bytes =
                uint64_t{extent.width} * extent.height * extent.depth * range.layers * texel;
            VkBufferImageCopy copy{};
            copy.bufferOffset = base_bytes + cursor;
            copy.imageSubresource = {aspects_to_vk(aspect), mip, range.layer, range.layers};
            copy.imageExtent = to_vk(extent);
            out.copies.push_back(copy);
            out.sizes_bytes.push_back(bytes);
            out.packed_bytes += bytes;
            cursor += bytes;
        }
    }
    out.staging_bytes = cursor;
    return out;
}

std::vector<std::byte> pack(const ImageRegions& regions, std::span<const std::byte> staging) {
    std::vector<std::byte> packed;
    packed.reserve(regions.packed_bytes);
    for (size_t i = 0; i < regions.copies.size(); ++i) {
        const auto region = staging.subspan(regions.copies[i].bufferOffset, regions.sizes_bytes[i]);
        packed.insert(packed.end(), region.begin(), region.end());
    }
    return packed;
}

}  // namespace weft::vk
