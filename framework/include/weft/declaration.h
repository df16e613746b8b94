// Purpose: the declarations of a frame's passes and resources, with every name, size, format and version
// resolved. resolve() makes them; later stages read them; the checker reads only them and the plan. Units:
// extents in pixels, sizes in bytes. Ids are indices into ResolvedGraph's vectors.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/access.h"
#include "weft/device_profile.h"
#include "weft/format.h"
#include "weft/shader_interface.h"
#include "weft/source.h"

namespace weft {

using ResourceId = uint32_t;
using PassId = uint32_t;
inline constexpr uint32_t kNoId = UINT32_MAX;

struct Extent3D {
    uint32_t width = 1;
    uint32_t height = 1;
    uint32_t depth = 1;
    bool operator==(const Extent3D&) const = default;
};

enum class ResourceKind : uint8_t { image, buffer };
enum class ImageKind : uint8_t { d2, d2_array, cube, cube_array, d3 };

// A box of mips × layers × aspects. A buffer is one subresource: mip 0, layer 0, kColor.
struct SubresourceRange {
    uint32_t mip = 0;
    uint32_t mips = 1;
    uint32_t layer = 0;
    uint32_t layers = 1;
    AspectMask aspects = aspect::kColor;
    bool operator==(const SubresourceRange&) const = default;
    auto operator<=>(const SubresourceRange&) const = default;
};
[[nodiscard]] bool overlaps(const SubresourceRange& a, const SubresourceRange& b);
[[nodiscard]] bool contains(const SubresourceRange& outer, const SubresourceRange& inner);
[[nodiscard]] std::string range_text(const SubresourceRange& range);

using UsageMask = uint32_t;
namespace usage {
inline constexpr UsageMask kSampled = 1u << 0;
inline constexpr UsageMask kStorage = 1u << 1;
inline constexpr UsageMask kColorAttachment = 1u << 2;
inline constexpr UsageMask kDepthAttachment = 1u << 3;
inline constexpr UsageMask kTransferSrc = 1u << 4;
inline constexpr UsageMask kTransferDst = 1u << 5;
inline constexpr UsageMask kUniform = 1u << 6;
inline constexpr UsageMask kVertex = 1u << 7;
inline constexpr UsageMask kIndex = 1u << 8;
inline constexpr UsageMask kIndirect = 1u << 9;
}  // namespace usage

// The usage flag for one kind of access.
[[nodiscard]] UsageMask usage_of(Access a);

enum class ResourceLifetime : uint8_t {
    transient,   // lives within a frame; may share memory with others
    persistent,  // keeps its memory and content from frame to frame (history, keep)
    imported,    // owned by the program; entry and exit states are declared
};

// The states of an imported resource before and after the frame. `entry` describes accesses before the frame:
// its writes are still pending, and its reads must complete before the frame writes. `exit` describes
// accesses after the frame: the frame's writes are made visible to them.
struct ImportState {
    AccessState entry;  // layout `undefined`: the content is discarded
    AccessState exit;
    uint32_t family = 0;      // index into DeviceProfile::queue_families
    bool concurrent = false;  // created for all queue families; otherwise only passes on queues of `family`
                              // may use it
    bool operator==(const ImportState&) const = default;
};

// Content of a persistent resource after its size has changed: its first-frame value, its old content scaled
// to the new size, or undefined until its writer has run again.
enum class OnResize : uint8_t { clear, resample, refill };

struct ResourceDecl {
    std::string name;
    ResourceKind kind = ResourceKind::image;
    ResourceLifetime lifetime = ResourceLifetime::transient;
    // images
    ImageKind image_kind = ImageKind::d2;
    Format format = Format::undefined;
    Extent3D extent;
    uint32_t mips = 1;
    uint32_t layers = 1;
    uint32_t samples = 1;
    AspectMask aspects = aspect::kColor;
    // buffers
    uint64_t size_bytes = 0;
    uint32_t stride_bytes = 0;
    // for both kinds
    UsageMask usage = 0;  // union over all passes, including culled ones
    // A persistent resource is a ring of history + 1 ResourceDecls: "color" is this frame's content,
    // "color[-1]" that of one frame ago. Each frame advances the ring by one copy: age a in frame f uses the
    // copy that age (f - a) mod (history + 1) had in frame 0. A ring of one resource keeps its content.
    uint32_t history = 0;     // number of earlier frames to keep
    ResourceId ring = kNoId;  // the resource of age 0 in this ring; kNoId if not persistent
    uint32_t age = 0;
    std::array<float, 4> first_frame{0, 0, 0, 0};  // initial content of every copy
    OnResize on_resize = OnResize::clear;
    bool pre_exposed = false;
    std::optional<ImportState> import;
    std::optional<std::array<float, 4>> clear;  // clear value for the first raster write
    SourceLoc loc;

    [[nodiscard]] SubresourceRange whole() const;
};

// Bytes of all texels of all mips and layers, without padding; for a buffer its size.
[[nodiscard]] uint64_t content_bytes(const ResourceDecl& resource);
[[nodiscard]] Extent3D mip_extent(const Extent3D& extent, uint32_t mip);

// The pass that wrote the content seen by a read. producer == kNoId: content from before the frame (import,
// history).
struct VersionSource {
    SubresourceRange range;
    PassId producer = kNoId;
    bool operator==(const VersionSource&) const = default;
};

enum class SamplerFilter : uint8_t { nearest, linear };
enum class SamplerWrap : uint8_t { clamp, repeat, mirror, border };
struct SamplerDecl {
    SamplerFilter filter = SamplerFilter::linear;
    SamplerFilter mip_filter = SamplerFilter::linear;
    SamplerWrap wrap = SamplerWrap::clamp;
    bool compare_greater_equal = false;  // for sampler2DShadow
    bool operator==(const SamplerDecl&) const = default;
};

// The binding of a pass's port to a range of a resource.
struct UseDecl {
    std::string port;
    ResourceId resource = kNoId;
    SubresourceRange range;
    Access access = Access::none;
    AccessState state;       // access_state(access, stages, is_image); the state that barriers must establish
    uint32_t history = 0;    // 0: this frame's content; n: the final content of n frames ago
    bool is_output = false;  // declared in "out" or "depth"
    std::vector<VersionSource> sources;  // for reading accesses
    uint32_t binding = kNoId;            // in set 1; kNoId for attachments, copies and C++ passes
    SamplerDecl sampler;
    SourceLoc loc;
};

enum class EdgeKind : uint8_t { raw, war, waw, after };

// `to` must run after `from`. There is one edge for each reason, so that every barrier can be explained.
struct EdgeDecl {
    PassId from = kNoId;
    PassId to = kNoId;
    EdgeKind kind = EdgeKind::raw;
    ResourceId resource = kNoId;  // kNoId for edges from `after`
    SourceLoc loc;
};

// `blit` is a copy with scaling. `readback` copies a range to host memory; observing a resource adds such a pass.
enum class PassKind : uint8_t { compute, fullscreen, raster, clear, copy, readback, custom, blit };

enum class CompareOp : uint8_t { never, less, equal, less_equal, greater, not_equal, greater_equal, always };
enum class CullMode : uint8_t { none, front, back, material };
enum class FrontFace : uint8_t { counter_clockwise, clockwise };
enum class Topology : uint8_t { triangles, triangle_strip, lines, line_strip, points };
enum class FillMode : uint8_t { fill, line, point };
enum class BlendFactor : uint8_t {
    zero,
    one,
    src_color,
    one_minus_src_color,
    dst_color,
    one_minus_dst_color,
    src_alpha,
    one_minus_src_alpha,
    dst_alpha,
    one_minus_dst_alpha,
};
enum class BlendOp : uint8_t { add, subtract, reverse_subtract, min, max };
enum class StencilOp : uint8_t {
    keep,
    zero,
    replace,
    increment_clamp,
    decrement_clamp,
    invert,
    increment_wrap,
    decrement_wrap,
};

struct BlendState {
    bool enabled = false;
    BlendFactor src_color = BlendFactor::one, dst_color = BlendFactor::zero;
    BlendOp color_op = BlendOp::add;
    BlendFactor src_alpha = BlendFactor::one, dst_alpha = BlendFactor::zero;
    BlendOp alpha_op = BlendOp::add;
    uint8_t write_mask = 0xF;  // r 1, g 2, b 4, a 8
    bool operator==(const BlendState&) const = default;
};

struct StencilFaceState {
    CompareOp compare = CompareOp::always;
    StencilOp fail = StencilOp::keep, depth_fail = StencilOp::keep, pass = StencilOp::keep;
    uint8_t read_mask = 0xFF, write_mask = 0xFF, reference = 0;
    bool operator==(const StencilFaceState&) const = default;
};

struct RectPx {
    int32_t x = 0, y = 0;
    uint32_t width = 0, height = 0;
    bool operator==(const RectPx&) const = default;
};

// The state of the fixed-function pipeline as data (P. Cozzi, "The Graphics Pipeline").
struct RasterState {
    Topology topology = Topology::triangles;
    FillMode fill = FillMode::fill;
    CullMode cull = CullMode::none;
    FrontFace front_face = FrontFace::counter_clockwise;
    bool depth_test = false;
    bool depth_write = false;
    CompareOp depth_compare = CompareOp::greater;
    bool depth_clamp = false;
    float depth_bias_constant = 0, depth_bias_slope = 0, depth_bias_clamp = 0;
    bool stencil_test = false;
    StencilFaceState stencil_front, stencil_back;
    bool alpha_to_coverage = false;
    std::optional<RectPx> scissor;  // default: the whole attachment
    std::optional<RectPx> viewport;
    bool operator==(const RasterState&) const = default;
};

struct AttachmentDecl {
    uint32_t use = kNoId;          // index into PassDecl::uses
    uint32_t location = 0;         // for colour attachments
    uint32_t resolve_use = kNoId;  // for a multisampled attachment: the use that gets its averages at the end
                                   // of the pass
    BlendState blend;
    std::array<float, 4> clear{0, 0, 0, 0};
    bool covers = false;  // the pass writes every texel, so no clear is needed
};

// Per-frame values from the executor's caller. `valid`: 1 if the content of ParamWrite::resource, a resource
// of a ring, has been written, else 0.
enum class Builtin : uint8_t {
    none,
    frame_index,
    time_s,
    delta_time_s,
    pre_exposure,
    prev_pre_exposure,
    valid,
};

// The value of one member of a pass's `Params` block: a literal, or a per-frame builtin.
struct ParamWrite {
    std::string member;
    uint32_t offset_bytes = 0;
    ScalarType scalar = ScalarType::f32;
    uint8_t components = 1;
    Builtin builtin = Builtin::none;
    ResourceId resource = kNoId;  // for Builtin::valid
    std::array<double, 4> value{0, 0, 0, 0};
};

struct SpecValue {
    uint32_t id = 0;
    ScalarType type = ScalarType::boolean;
    uint32_t bits = 0;
};

struct NamedValue {
    std::string name;
    double value = 0;
};

// The work needed after a change of a graph parameter.
enum class ParamCost : uint8_t {
    nothing,   // no pass uses it
    live,      // a value in the shaders' Params
    pipeline,  // a specialisation constant: pipelines are created again
    graph,     // sizes, ranges, conditions: the graph is compiled again
};

struct GraphParam {
    std::string name;
    double value = 0;
    ParamCost cost = ParamCost::nothing;
};

struct PassDecl {
    std::string name;
    std::string type;  // "compute", "raster", … or the name of a C++ pass
    PassKind kind = PassKind::compute;
    QueueKind queue = QueueKind::graphics;  // a hint only
    std::vector<UseDecl> uses;              // inputs, then outputs, both sorted by name
    bool side_effect = false;               // true: never culled
    std::string shader;                     // key into ShaderCatalog
    std::vector<SpecValue> spec_values;
    std::vector<ParamWrite> params;
    uint32_t params_bytes = 0;
    bool params_push = false;
    std::vector<NamedValue> custom_params;    // for C++ passes: parameters by name
    std::array<uint32_t, 3> groups{0, 0, 0};  // for compute passes
    uint32_t indirect_use = kNoId;  // for compute passes: the use whose first three words are `groups`
    // for raster and fullscreen passes
    std::vector<AttachmentDecl> colors;  // sorted by location
    std::optional<AttachmentDecl> depth;
    Extent3D render_extent;
    RasterState state;
    std::vector<std::string> draw_lists;  // names of imports
    uint32_t draw_commands_use = kNoId;   // for raster passes: the use with a draw command for each draw
    uint32_t vertices = 0;   // for raster passes without draw lists: number of vertices, which the shader
                             // computes from their index
    uint32_t instances = 0;  // number of instances of these vertices
    std::string view = "camera";
    std::array<float, 4> clear{0, 0, 0, 0};  // for clear passes
    double flops = 0;                        // declared arithmetic cost
    // One pass of a repeat with `perFrame`, which is cut into slices: frame f runs slice f mod frame_slices,
    // frame 0 runs all slices. Its results are kept for the frames in between. 0 slices: it runs in every frame.
    uint32_t frame_slice = 0;
    uint32_t frame_slices = 0;
    uint32_t order_key = 0;  // program order of graphs made in memory; ties are ordered by
                             // name
    SourceLoc loc;
};

// True if the pass runs in a frame; frames are counted from the start of the plan. Its barriers are recorded
// in every frame.
[[nodiscard]] bool runs_in_frame(const PassDecl& pass, uint64_t frame);

struct ResolvedGraph {
    std::string name;
    Extent3D output_extent;
    std::vector<ResourceDecl> resources;  // sorted by name
    std::vector<PassDecl> passes;         // sorted by name
    std::vector<EdgeDecl> edges;          // sorted by (to, from, kind, resource)
    ResourceId output = kNoId;            // the import of kind "output"
    std::vector<GraphParam> params;       // parameters of the graph
    uint32_t frames = 1;                  // default number of frames of a run; not hashed
    SourceMap sources;                    // for messages; not hashed
};

[[nodiscard]] const ResourceDecl* find_resource(const ResolvedGraph& graph, std::string_view name);
[[nodiscard]] const PassDecl* find_pass(const ResolvedGraph& graph, std::string_view name);

}  // namespace weft
