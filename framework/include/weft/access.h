// Purpose: describes how a pass accesses a resource, with enough detail to derive every barrier: stages,
// access bits, image layout. The names follow Vulkan's synchronization2; only to_vk.cpp maps them to its
// values.
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
inline constexpr StageMask kAll = (1u << kCount) - 1;  // all stages that the recording queue supports
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
inline constexpr AspectMask kNone = 0;  // for buffers
inline constexpr AspectMask kColor = 1;
inline constexpr AspectMask kDepth = 2;
inline constexpr AspectMask kStencil = 4;
}  // namespace aspect

enum class Layout : uint8_t {
    undefined,
    general,
    color_attachment,
    depth_attachment,  // depth and stencil, read and write
    depth_read_only,   // attachment and sampled image at the same time
    shader_read_only,
    transfer_src,
    transfer_dst,
    present,
};

// The kind of access of one use of a resource. For shader accesses, `stages` depend on the pass; see
// access_state().
enum class Access : uint8_t {
    none,
    indirect_read,
    index_read,
    vertex_read,
    uniform_read,
    sampled_read,
    storage_read,
    storage_write,       // writes the whole range: previous content is not visible
    storage_read_write,  // in place
    color_write,         // cleared, or completely covered
    color_read_write,    // blended, masked or loaded
    depth_write,         // first write of a frame: cleared, then tested and written
    depth_read_write,    // loaded, tested, written
    depth_read,          // tested only
    copy_read,
    copy_write,
    blit_read,
    blit_write,
    clear_write,
    host_read,
    present,
};

// Stages, access bits and layout: one side of a barrier.
struct AccessState {
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    Layout layout = Layout::undefined;

    bool operator==(const AccessState&) const = default;
};

// The state for access `a` by the given shader stages (ignored by fixed-function accesses). Buffers (no
// aspects) have the layout `undefined`. Sampled depth uses `depth_read_only`, so that it can be attachment
// and input at the same time; sampled colour uses `shader_read_only`; storage images use `general`.
[[nodiscard]] AccessState access_state(Access a, ShaderStageMask shader_stages, AspectMask aspects);
[[nodiscard]] bool reads(Access a);  // true if the access sees previous content
[[nodiscard]] bool writes(Access a);

// For dumps and messages: "compute_shader|fragment_shader", "storage_write", "shader_read_only".
[[nodiscard]] std::string stages_text(StageMask mask);
[[nodiscard]] std::string access_text(AccessMask mask);
[[nodiscard]] std::string layout_text(Layout layout);
[[nodiscard]] std::string access_name(Access a);

}  // namespace weft
