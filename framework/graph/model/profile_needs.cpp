// Computes size, alignment and memory types of each resource, except imports, from a device profile. So a
// graph can be compiled without the device.
#include <algorithm>

#include "graph/model/round_up.h"
#include "weft/compile.h"

namespace weft {
namespace {

uint64_t image_bytes(const ResourceDecl& image, const DeviceProfile& profile) {
    const uint64_t texel_bytes = uint64_t{format_info(image.format).bytes_per_texel} * image.samples;
    uint64_t bytes = 0;
    for (uint32_t mip = 0; mip < image.mips; ++mip) {
        const Extent3D extent = mip_extent(image.extent, mip);
        bytes += round_up(extent.width * texel_bytes, profile.image_row_alignment_bytes) * extent.height *
                 extent.depth;
    }
    return bytes * image.layers + profile.image_extra_bytes;
}

MemoryContentMask content_of(const ResourceDecl& resource) {
    if (resource.kind == ResourceKind::buffer) return memory_content::kBuffers;
    return (resource.aspects & aspect::kColor) != 0 ? memory_content::kColorImages
                                                    : memory_content::kDepthImages;
}

// Returns true if the resource is transient and only used as an attachment. The content of such an image can
// stay in on-chip memory, so lazily allocated memory is possible.
bool attachment_only(const ResourceDecl& resource) {
    constexpr UsageMask kAttachment = usage::kColorAttachment | usage::kDepthAttachment;
    return resource.kind == ResourceKind::image && resource.lifetime == ResourceLifetime::transient &&
           resource.usage != 0 && (resource.usage & ~kAttachment) == 0;
}

// Returns a bit mask of the memory types that the resource may use. If the profile lists no types, all bits
// are set. Attachment-only images get the lazily allocated types if any of them fits. All other resources get
// the device-local types that fit. If none fits, they get all fitting types that are not lazily allocated.
uint32_t type_bits(const ResourceDecl& resource, const DeviceProfile& profile) {
    if (profile.memory_types.empty()) return UINT32_MAX;
    uint32_t lazy = 0, local = 0, any = 0;
    for (uint32_t i = 0; i < profile.memory_types.size(); ++i) {
        const MemoryTypeProfile& type = profile.memory_types[i];
        if ((type.holds & content_of(resource)) == 0) continue;
        if (type.lazily_allocated) {
            lazy |= 1u << i;
            continue;
        }
        any |= 1u << i;
        if (type.device_local) local |= 1u << i;
    }
    if (lazy != 0 && attachment_only(resource)) return lazy;
    return local != 0 ? local : any;
}

}  // namespace

MemoryNeeds profile_needs(const ResolvedGraph& graph, const DeviceProfile& profile) {
    MemoryNeeds needs(graph.resources.size());
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDecl& resource = graph.resources[id];
        if (resource.lifetime == ResourceLifetime::imported) continue;
        const bool image = resource.kind == ResourceKind::image;
        needs[id] = {image ? image_bytes(resource, profile) : resource.size_bytes,
                     image ? profile.image_alignment_bytes : profile.buffer_alignment_bytes,
                     type_bits(resource, profile)};
    }
    return needs;
}

}  // namespace weft
