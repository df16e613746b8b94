// Purpose: how a pass touches a resource, in terms precise enough to derive every barrier: stages, access
// bits, image layout. The names follow Vulkan's synchronization2; to_vk.cpp holds the only mapping to its
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
inline constexpr StageMask kAll = (1u << kCount) - 1;  // of whatever queue records it
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
inline constexpr AspectMask kNone = 0;  // buffers
inline constexpr AspectMask kColor = 1;
inline constexpr AspectMask kDepth = 2;
inline constexpr AspectMask kStencil = 4;
}  // namespace aspect

enum class Layout : uint8_t {
    undefined,
    general,
    color_attachment,
    depth_attachment,  // depth and stencil, read and write
    depth_read_only,   // attachment and sampled at once
    shader_read_only,
    transfer_src,
    transfer_dst,
    present,
};

// What one use of a resource means. `stages` of the shader accesses depend on the pass; see access_state().
enum class Access : uint8_t {
    none,
    indirect_read,
    index_read,
    vertex_read,
    uniform_read,
    sampled_read,
    storage_read,
    storage_write,       // covers the range: nothing of the old content is seen
    storage_read_write,  // in place
    color_write,         // cleared, or wholly covered
    color_read_write,    // blended, masked or loaded
    depth_write,         // first write: cleared, then tested and written
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

// Stages, access bits and layout together: one side of a barrier.
struct AccessState {
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    Layout layout = Layout::undefined;

    bool operator==(const AccessState&) const = default;
};

// What `a` needs when used by the given shader stages (ignored by fixed-function accesses).
// Buffers (no aspects) have layout `undefined`. Sampled depth is `depth_read_only`, so that it may be
// attachment and input at once; sampled colour is `shader_read_only`; storage images are `general`.
[[nodiscard]] AccessState access_state(Access a, ShaderStageMask shader_stages, AspectMask aspects);
[[nodiscard]] bool reads(Access a);  // sees what was there before
[[nodiscard]] bool writes(Access a);

// For dumps and messages: "compute_shader|fragment_shader", "storage_write", "shader_read_only".
[[nodiscard]] std::string stages_text(StageMask mask);
[[nodiscard]] std::string access_text(AccessMask mask);
[[nodiscard]] std::string layout_text(Layout layout);
[[nodiscard]] std::string access_name(Access a);

}  // namespace weft
