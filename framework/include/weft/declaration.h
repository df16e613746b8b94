// Purpose: what the passes of a frame declare, with every name, size, format and version resolved. Made by
// resolve(), consumed by the later stages, and the only thing besides the plan that the checker reads.
// Units: extents in pixels, sizes in bytes. Ids are indices into ResolvedGraph's vectors.
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

// A box of mips × layers × aspects. Buffers are one subresource: mip 0, layer 0, kColor.
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

// The usage that one kind of access needs.
[[nodiscard]] UsageMask usage_of(Access a);

enum class ResourceLifetime : uint8_t {
    transient,   // lives within a frame; may share memory with others
    persistent,  // keeps its memory and content from frame to frame (history, keep)
    imported,    // owned by somebody else; entry and exit states are declared
};

// The states in which an imported resource is handed over and wanted back. `entry` is what may have happened
// to it before the frame: writes in it are still pending, reads must be over before the frame writes. `exit`
// is what comes after: the frame's writes are made visible to it.
struct ImportState {
    AccessState entry;  // layout undefined: the content is of no interest
    AccessState exit;
    uint32_t family = 0;      // index into DeviceProfile::queue_families
    bool concurrent = false;  // made for all families; else only passes on `family`'s queues may use it
    bool operator==(const ImportState&) const = default;
};

// What a persistent resource holds once its size has changed: its first-frame value again, its old content
// stretched to the new size, or nothing until its writer has run again.
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
    // both
    UsageMask usage = 0;  // the union over all passes, live or not
    // A persistent resource is a ring of history + 1 roles, each a ResourceDecl of its own: "color" is this
    // frame's, "color[-1]" what it held one frame ago. From frame to frame the memory moves on: role a of
    // frame f lives in the copy that role (f - a) mod (history + 1) had in frame 0. A ring of one keeps its
    // content.
    uint32_t history = 0;     // copies kept of earlier frames
    ResourceId ring = kNoId;  // the role of age 0; kNoId when not persistent
    uint32_t age = 0;
    std::array<float, 4> first_frame{0, 0, 0, 0};  // what every copy holds before anybody wrote it
    OnResize on_resize = OnResize::clear;
    bool pre_exposed = false;
    std::optional<ImportState> import;
    std::optional<std::array<float, 4>> clear;  // what a first raster write clears to
    SourceLoc loc;

    [[nodiscard]] SubresourceRange whole() const;
};

// Bytes of all texels of all mips and layers, without padding; a buffer's size.
[[nodiscard]] uint64_t content_bytes(const ResourceDecl& resource);
[[nodiscard]] Extent3D mip_extent(const Extent3D& extent, uint32_t mip);

// Which pass wrote what a read sees. producer == kNoId: the content from before the frame (import, history).
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

// One port of a pass bound to one range of one resource.
struct UseDecl {
    std::string port;
    ResourceId resource = kNoId;
    SubresourceRange range;
    Access access = Access::none;
    AccessState state;       // access_state(access, stages, is_image); what barriers must establish
    uint32_t history = 0;    // 0: this frame; n: the final version n frames ago
    bool is_output = false;  // from "out" or "depth"
    std::vector<VersionSource> sources;  // for accesses that read
    uint32_t binding = kNoId;            // in set 1; kNoId for attachments, copies and C++ passes
    SamplerDecl sampler;
    SourceLoc loc;
};

enum class EdgeKind : uint8_t { raw, war, waw, after };

// `to` must run after `from`. One for each reason, so that every barrier can be explained.
struct EdgeDecl {
    PassId from = kNoId;
    PassId to = kNoId;
    EdgeKind kind = EdgeKind::raw;
    ResourceId resource = kNoId;  // kNoId for `after`
    SourceLoc loc;
};

// `readback` copies one range into host memory; an observed resource becomes such a pass.
enum class PassKind : uint8_t { compute, fullscreen, raster, clear, copy, readback, custom };

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

// Everything the fixed-function pipeline offers (P. Cozzi, "The Graphics Pipeline"), as data.
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
    uint32_t location = 0;         // colour attachments
    uint32_t resolve_use = kNoId;  // of a multisampled one: the use that gets its averages when the pass ends
    BlendState blend;
    std::array<float, 4> clear{0, 0, 0, 0};
    bool covers = false;  // every texel is written: no clear needed
};

// Per-frame values that only the executor's caller knows.
// `valid`: 1 once the content that ParamWrite::resource, a role of a ring, stands for has been written, else
// 0.
enum class Builtin : uint8_t {
    none,
    frame_index,
    time_s,
    delta_time_s,
    pre_exposure,
    prev_pre_exposure,
    valid,
};

// One member of a pass's `Params` block: a literal, or a per-frame builtin.
struct ParamWrite {
    std::string member;
    uint32_t offset_bytes = 0;
    ScalarType scalar = ScalarType::f32;
    uint8_t components = 1;
    Builtin builtin = Builtin::none;
    ResourceId resource = kNoId;  // of Builtin::valid
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

// What it costs to give a graph's parameter another value.
enum class ParamCost : uint8_t {
    nothing,   // nobody uses it
    live,      // a value in the shaders' Params
    pipeline,  // a specialisation constant: pipelines are made anew
    graph,     // sizes, ranges, conditions: the graph is compiled anew
};

struct GraphParam {
    std::string name;
    double value = 0;
    ParamCost cost = ParamCost::nothing;
};

struct PassDecl {
    std::string name;
    std::string type;  // "compute", "raster", … or a C++ pass's name; a "blit" is a copy that scales
    PassKind kind = PassKind::compute;
    QueueKind queue = QueueKind::graphics;  // a hint
    std::vector<UseDecl> uses;              // inputs first, then outputs, each in name order
    bool side_effect = false;               // never culled
    std::string shader;                     // key into ShaderCatalog
    std::vector<SpecValue> spec_values;
    std::vector<ParamWrite> params;
    uint32_t params_bytes = 0;
    bool params_push = false;
    std::vector<NamedValue> custom_params;    // C++ passes: by name
    std::array<uint32_t, 3> groups{0, 0, 0};  // compute
    uint32_t indirect_use = kNoId;  // compute: the use that holds `groups` as three words at its start
    // raster and fullscreen
    std::vector<AttachmentDecl> colors;  // by location
    std::optional<AttachmentDecl> depth;
    Extent3D render_extent;
    RasterState state;
    std::vector<std::string> draw_lists;  // import names
    uint32_t draw_commands_use = kNoId;   // raster: the use that holds a draw command for each draw
    uint32_t vertices = 0;   // raster, in place of lists: so many, which the shader places by their index
    uint32_t instances = 0;  // … each so many times
    std::string view = "camera";
    std::array<float, 4> clear{0, 0, 0, 0};  // `clear` passes
    double flops = 0;                        // declared cost
    // One of a repeat that is spread over frames (`perFrame`): frame f runs turn f mod turns, frame 0 runs all.
    // What it writes is kept, so that the other frames find it. 0 turns: it runs in every frame.
    uint32_t turn = 0;
    uint32_t turns = 0;
    uint32_t order_key = 0;                  // program order of graphs made in memory; names break ties
    SourceLoc loc;
};

// Whether the pass does anything in a frame, counted from the first one of its plan. Its barriers always hold.
[[nodiscard]] bool runs_in_frame(const PassDecl& pass, uint64_t frame);

struct ResolvedGraph {
    std::string name;
    Extent3D output_extent;
    std::vector<ResourceDecl> resources;  // sorted by name
    std::vector<PassDecl> passes;         // sorted by name
    std::vector<EdgeDecl> edges;          // sorted by (to, from, kind, resource)
    ResourceId output = kNoId;            // the import of kind "output"
    std::vector<GraphParam> params;       // of the graph
    uint32_t frames = 1;                  // how many a run renders unless it is told; not hashed
    SourceMap sources;                    // for messages; not hashed
};

[[nodiscard]] const ResourceDecl* find_resource(const ResolvedGraph& graph, std::string_view name);
[[nodiscard]] const PassDecl* find_pass(const ResolvedGraph& graph, std::string_view name);

}  // namespace weft
