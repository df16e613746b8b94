// Purpose: describes how a pass accesses a resource: pipeline stages, access bits and image layout, enough to
// derive every barrier. The names follow Vulkan's synchronization2. Only vulkan/device/to_vk.cpp converts
// them to Vulkan's values.
#pragma once

#include <cstdint>
#include <string>

#include "weft/shader_interface.h"

namespace weft {

using StageMask = uint32_t;
namespace stage {
inline constexpr StageMask kNone = 0;
inline constexpr StageMask kDrawIndirect = 1u << 0;
inline constexpr StageMask kVertexInput = 1u << 1;
inline constexpr StageMask kVertexShader = 1u << 2;
inline constexpr StageMask kEarlyFragmentTests = 1u << 3;
inline constexpr StageMask kFragmentShader = 1u << 4;
inline constexpr StageMask kLateFragmentTests = 1u << 5;
inline constexpr StageMask kColorOutput = 1u << 6;
inline constexpr StageMask kComputeShader = 1u << 7;
inline constexpr StageMask kCopy = 1u << 8;
inline constexpr StageMask kBlit = 1u << 9;
inline constexpr StageMask kResolve = 1u << 10;
inline constexpr StageMask kClear = 1u << 11;
inline constexpr StageMask kHost = 1u << 12;
inline constexpr int kCount = 13;
// The value kAll means all stages that the recording queue supports.
inline constexpr StageMask kAll = (1u << kCount) - 1;
}  // namespace stage

using AccessMask = uint32_t;
namespace access {
inline constexpr AccessMask kNone = 0;
inline constexpr AccessMask kIndirectRead = 1u << 0;
inline constexpr AccessMask kIndexRead = 1u << 1;
inline constexpr AccessMask kVertexRead = 1u << 2;
inline constexpr AccessMask kUniformRead = 1u << 3;
inline constexpr AccessMask kSampledRead = 1u << 4;
inline constexpr AccessMask kStorageRead = 1u << 5;
inline constexpr AccessMask kStorageWrite = 1u << 6;
inline constexpr AccessMask kColorRead = 1u << 7;
inline constexpr AccessMask kColorWrite = 1u << 8;
inline constexpr AccessMask kDepthStencilRead = 1u << 9;
inline constexpr AccessMask kDepthStencilWrite = 1u << 10;
inline constexpr AccessMask kTransferRead = 1u << 11;
inline constexpr AccessMask kTransferWrite = 1u << 12;
inline constexpr AccessMask kHostRead = 1u << 13;
inline constexpr AccessMask kHostWrite = 1u << 14;
inline constexpr int kCount = 15;
inline constexpr AccessMask kAll = (1u << kCount) - 1;
inline constexpr AccessMask kAllWrites =
    kStorageWrite | kColorWrite | kDepthStencilWrite | kTransferWrite | kHostWrite;
}  // namespace access

using AspectMask = uint8_t;
namespace aspect {
inline constexpr AspectMask kNone = 0;  // The value that access_state() gets for buffers.
inline constexpr AspectMask kColor = 1;
inline constexpr AspectMask kDepth = 2;
inline constexpr AspectMask kStencil = 4;
}  // namespace aspect

enum class Layout : uint8_t {
    undefined,
    general,
    color_attachment,
    depth_attachment,  // Layout of a depth or stencil attachment that is read and written.
    // Layout of a depth image that is a read-only attachment and a sampled image at the same time.
    depth_read_only,
    shader_read_only,
    transfer_src,
    transfer_dst,
    present,
};

// The way in which a pass uses a resource. access_state() gives the stages, access bits and layout for it;
// the stages of shader accesses depend on the pass.
enum class Access : uint8_t {
    none,
    indirect_read,
    index_read,
    vertex_read,
    uniform_read,
    sampled_read,
    storage_read,
    storage_write,       // A shader writes the whole range, so the pass does not need the previous content.
    storage_read_write,  // A shader reads and writes the range in place.
    color_write,  // The pass draws to the colour attachment after clearing it, or covers it completely.
    // The pass draws to the colour attachment and needs its previous content: it blends, or leaves some
    // channels or texels as they are.
    color_read_write,
    depth_write,       // The pass is the first of the frame to write depth: it clears, then tests and writes.
    depth_read_write,  // The pass loads depth, tests against it and writes it.
    depth_read,        // The pass tests against depth and does not write it.
    copy_read,
    copy_write,
    blit_read,
    blit_write,
    clear_write,
    host_read,
    present,
};

// Describes one side of a barrier: pipeline stages, access bits and image layout.
struct AccessState {
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    Layout layout = Layout::undefined;

    bool operator==(const AccessState&) const = default;
};

// Returns the state that access `a` needs. `shader_stages` are the shader stages that access the resource;
// accesses by fixed-function stages ignore them. A buffer has no aspects and gets the layout `undefined`.
// Sampled colour images use `shader_read_only`. Sampled depth images use `depth_read_only`, so that a depth
// image can be sampled and be a read-only attachment at the same time. Storage images use `general`.
[[nodiscard]] AccessState access_state(Access a, ShaderStageMask shader_stages, AspectMask aspects);
[[nodiscard]] bool reads(Access a);  // Returns true if the access can see previous content of the resource.
[[nodiscard]] bool writes(Access a);

// These functions return texts for dumps and messages. Examples: "fragment_shader|compute_shader",
// "storage_write", "shader_read_only".
[[nodiscard]] std::string stages_text(StageMask mask);
[[nodiscard]] std::string access_text(AccessMask mask);
[[nodiscard]] std::string layout_text(Layout layout);
[[nodiscard]] std::string access_name(Access a);

}  // namespace weft
