// Purpose: declares a resource of a frame, in which every size and format is known. Part of declaration.h.
// Units: extents in pixels, sizes in bytes. A ResourceId is an index into ResolvedGraph::resources.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/access.h"
#include "weft/format.h"
#include "weft/id.h"
#include "weft/live_value.h"
#include "weft/resource_usage.h"
#include "weft/source.h"
#include "weft/subresource.h"

namespace weft {

using ResourceId = Id<struct ResourceTable>;

struct Extent3D {
    uint32_t width = 1;
    uint32_t height = 1;
    uint32_t depth = 1;
    bool operator==(const Extent3D&) const = default;
};

enum class ResourceKind : uint8_t { image, buffer };
enum class ImageKind : uint8_t { d2, d2_array, cube, cube_array, d3 };

enum class ResourceLifetime : uint8_t {
    // The content lives within one frame. The memory may be shared with other transient resources.
    transient,
    // Memory and content are kept from frame to frame. Resources with `history` or `keep` have this lifetime.
    persistent,
    // The program owns the resource and declares its states before and after the frame (ImportState).
    imported,
};

// The states of an imported resource before and after each frame. `entry` describes the accesses of the
// program before the frame: the frame waits for the program's reads before it writes the resource, and makes
// the program's writes visible before it reads the resource. `exit` describes the accesses of the program
// after the frame: the writes of the frame are made visible to them.
struct ImportState {
    AccessState entry;  // For an image, layout `undefined` means that the frame discards the old content.
    AccessState exit;
    // Queue family that owns the resource between frames: an index into DeviceProfile::queue_families.
    uint32_t family = 0;
    // True: the resource was created for concurrent use by all queue families. False: only passes on queues
    // of `family` may use the resource.
    bool concurrent = false;
    bool operator==(const ImportState&) const = default;
};

// The content of a persistent resource after a change of its size. clear: the initial value `first_frame`.
// resample: the old content, scaled to the new size. refill: undefined, until a pass has written the resource
// again.
enum class OnResize : uint8_t { clear, resample, refill };

// A picture file that becomes one texture of a table.
struct TextureFile {
    std::string name;  // As in the graph.
    std::string path;  // The plan's hash does not include it.
    uint32_t width_px = 0, height_px = 0;
    uint32_t mips = 1;
};

struct ResourceDecl {
    std::string name;
    ResourceKind kind = ResourceKind::image;
    ResourceLifetime lifetime = ResourceLifetime::transient;
    // The members from image_kind to aspects describe an image. Buffers do not use them.
    ImageKind image_kind = ImageKind::d2;
    Format format = Format::undefined;
    Extent3D extent;
    uint32_t mips = 1;
    uint32_t layers = 1;
    uint32_t samples = 1;
    AspectMask aspects = aspect::kColor;
    // The members from size_bytes to cuts_bytes describe a buffer. Images do not use them.
    uint64_t size_bytes = 0;
    uint32_t stride_bytes = 0;
    // The offsets that divide the buffer into pieces, in ascending order, without 0 and the size. Each part
    // that a pass uses consists of whole pieces. Empty: the buffer is one piece.
    std::vector<uint64_t> cuts_bytes;
    // Union of the usage flags of all passes that use the resource, including culled passes.
    UsageMask usage = 0;
    // A resource with `history` n is a ring of n + 1 ResourceDecls. In a ring of 3, "color" (age 0) is the
    // content of this frame, "color[-1]" (age 1) the content of the previous frame, and "color[-2]" (age 2)
    // the content of the frame before. The memory rotates, so that nothing is copied: in frame f, age a uses
    // the memory that was placed for age (f - a) mod (n + 1). A resource with `keep` is a ring of one, which
    // keeps its content.
    uint32_t history = 0;  // Number of earlier frames whose content is kept.
    // The resource of age 0 among the copies of this resource (its ring); kNoId if the resource is not
    // persistent.
    ResourceId ring = kNoId;
    uint32_t age = 0;
    // Initial value (r, g, b, a) of every copy in the ring, before the first write.
    std::array<float, 4> first_frame{0, 0, 0, 0};
    OnResize on_resize = OnResize::clear;
    // True: all tiers (quality levels) of the graph use the same memory for the resource. Its `usage` then
    // has the flags of all tiers. Only for resources with `keep` and without `history`.
    bool shared = false;
    bool pre_exposed = false;
    std::optional<ImportState> import;
    // For a persistent resource that the program reads between two frames (GraphRequest::exports): these
    // reads. The frame leaves the resource in this state, and the next frame waits for the reads before it
    // writes the resource. Of the copies of a resource with `history`, only the copy of age 0 (the current
    // frame) has `between`.
    std::optional<AccessState> between;
    // Name of the file with the content, as in the graph; empty: none. Such a resource is imported: Weft
    // itself provides it, and passes only read it.
    std::string file;
    std::string file_path;  // Path of this file. The plan's hash does not include it.
    // Not 0: the resource is a table of this many 2D textures, which shaders index. A table is an imported
    // image that passes only sample. Its textures have sizes and mips of their own. The members that describe
    // an image describe one texel, which stands for all textures. All textures have formats of the same kind
    // (float or normalised, int, uint) as `format`.
    uint32_t textures = 0;
    // The files of the textures. Empty: the program provides the table.
    std::vector<TextureFile> texture_files;
    // Clear value for a raster pass that is the first in a frame to write the image and has no clear value of
    // its own; absent: 0.
    std::optional<std::array<float, 4>> clear;
    // For an image with a live size, of which each frame uses only an area: the size of this area, as an
    // index into ResolvedGraph::live_values. The area of the first mip is this size, rounded down, from 1 to
    // `extent`. kNoId: passes use the whole image.
    uint32_t area = kNoId;
    SourceLoc loc;

    [[nodiscard]] SubresourceRange whole() const;
};

// Returns the text of a part of a resource, such as ".mip(0).layer(1..2)", or ".range(0..63)" for elements 0
// to 63 of a buffer. Empty for a whole buffer that has no cuts_bytes, and for a table of textures.
[[nodiscard]] std::string range_text(const ResourceDecl& resource, const SubresourceRange& range);
// Returns the offset and the size in bytes of the pieces in `range`; see ResourceDecl::cuts_bytes.
[[nodiscard]] ByteRange piece_bytes(const ResourceDecl& buffer, const SubresourceRange& range);
// Returns the number of bytes of all texels in all mips, layers and samples, without padding; for a buffer,
// its size.
[[nodiscard]] uint64_t content_bytes(const ResourceDecl& resource);
[[nodiscard]] Extent3D mip_extent(const Extent3D& extent, uint32_t mip);
// Returns the state of a resource while a clear command writes it.
[[nodiscard]] AccessState clear_state(const ResourceDecl& resource);

}  // namespace weft
