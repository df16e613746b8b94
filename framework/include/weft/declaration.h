// Purpose: defines the resolved graph: the resources and passes of a frame, in which every name, size, format
// and version is known. resolve() makes it, and all later stages of the compiler read it. The checker
// (framework/check/) reads only this data and the plan. Units: extents in pixels, sizes in bytes. A
// ResourceId is an index into ResolvedGraph::resources, a PassId an index into ResolvedGraph::passes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weft/access.h"
#include "weft/device_profile.h"
#include "weft/format.h"
#include "weft/graph_param.h"
#include "weft/id.h"
#include "weft/live_value.h"
#include "weft/raster_state.h"
#include "weft/resource_declaration.h"
#include "weft/resource_usage.h"
#include "weft/sampler.h"
#include "weft/shader_interface.h"
#include "weft/source.h"
#include "weft/subresource.h"
#include "weft/switches.h"
#include "weft/view_list.h"

namespace weft {

using PassId = Id<struct PassTable>;

// Where a read gets its content from: the pass `producer` wrote the content that the read sees in `range`.
// kNoId: the content is from before the frame (an import, or history).
struct VersionSource {
    SubresourceRange range;
    PassId producer = kNoId;
    bool operator==(const VersionSource&) const = default;
};

// Binds a port of a pass to a part of a resource, and tells how the pass accesses this part.
struct UseDecl {
    std::string port;
    ResourceId resource = kNoId;
    SubresourceRange range;
    // The bytes that the pass uses, if the port names elements of a buffer. Absent: the whole resource or,
    // for an image, `range`.
    std::optional<ByteRange> bytes;
    EachPart each = EachPart::none;
    Access access = Access::none;
    // Stages, access bits and layout that the barriers must establish before the pass: access_state() of
    // `access`.
    AccessState state;
    // n: the content at the end of the n-th previous frame, as in "color[-n]". 0: the content of this frame.
    uint32_t history = 0;
    bool is_output = false;  // True if the port is declared in "out" or "depth" of the pass.
    // The writers of the content that the pass reads. Empty if the access does not read.
    std::vector<VersionSource> sources;
    // Binding number in descriptor set 1. kNoId if the port is no binding of a shader. Examples: attachments,
    // ports of copies, ports of passes in C++.
    uint32_t binding = kNoId;
    SamplerDecl sampler;
    // Only for passes with `rest`, which run only if something that they read has changed. False: a change of
    // the content of this port does not make the pass run.
    bool wakes = true;
    // The pass uses the port's resource only in these combinations of the switches (which switches are on).
    // In all other combinations, another use of the same port takes its place, or the port has no resource.
    CombinationSet used_in = kEveryCombination;
    // Only for writes of a pass with a switch. In frames in which the pass does not run, the readers of this
    // write see these versions instead.
    std::vector<VersionSource> passes_on;
    // Only for resources that a group writes. A group is a set of passes that runs in rounds; each round is
    // one copy of all its passes. True for a pass of a group that reads what other rounds write, and for a
    // readback of a resource of a group. Such a pass sees the content at the time when it runs, and this
    // content depends on the rounds that have run before. But if a pass of its own round has written the
    // content, it sees that content.
    bool latest = false;
    SourceLoc loc;
};
// Returns the bytes of a buffer that a use names: UseDecl::bytes, or the whole buffer.
[[nodiscard]] ByteRange used_bytes(const ResourceDecl& buffer, const UseDecl& use);

// Returns how many elements of the shader's array the range fills: its mips or layers; 1 if the port is not
// an array.
[[nodiscard]] uint32_t element_count(const UseDecl& use);
// Returns the part of the range that is element `element`. If `element` is greater than the index of the last
// element, returns the last element.
[[nodiscard]] SubresourceRange element_range(const UseDecl& use, uint32_t element);

enum class EdgeKind : uint8_t { raw, war, waw, after };

// `to` must run after `from`. Two passes have a separate edge for each reason, so that every barrier can be
// explained.
struct EdgeDecl {
    PassId from = kNoId;
    PassId to = kNoId;
    EdgeKind kind = EdgeKind::raw;
    // The resource that causes the edge; kNoId if the cause is the key `after` in the graph.
    ResourceId resource = kNoId;
    SourceLoc loc;
};

// `blit` copies with scaling. `readback` copies a part of a resource to host memory. If a program observes a
// resource (`--resource`), resolve() adds a readback pass.
enum class PassKind : uint8_t { compute, fullscreen, raster, clear, copy, readback, custom, blit };

struct AttachmentDecl {
    uint32_t use = kNoId;   // The attachment's use: an index into PassDecl::uses.
    uint32_t location = 0;  // Location of the fragment shader's output. Not used for depth attachments.
    // For a multisampled attachment: index into PassDecl::uses of the image that gets the resolved samples at
    // the end of the pass. kNoId: nothing is resolved.
    uint32_t resolve_use = kNoId;
    BlendState blend;
    std::array<float, 4> clear{0, 0, 0, 0};
    // True: the pass writes every texel, so that the attachment need not be cleared first.
    bool covers = false;
};

// A value that changes from frame to frame.
// `valid` belongs to a resource with history (ParamWrite::resource): 1 if a frame has written its content, 0
// if the content is still the initial value.
// `unit_valid` and `unit_bits` belong to a port (ParamWrite::use) whose resource is written by units: sets of
// passes that run only in some frames (PassDecl::rest_unit). `unit_valid`: 1 if all of these units have run
// since the resource was made or cleared. `unit_bits`: the same, with one bit for each layer of the port.
// The values from `live` on follow the scales of live sizes, which the program may change in each frame.
// `live`: each component is a value of the list ResolvedGraph::live_values (ParamWrite::live).
// `area_size`, `area_uv` and `area_uv_most` belong to a port (ParamWrite::use) whose image has a live size.
// Passes use only a part of this image, the area. `area_size`: the size of the area in pixels. `area_uv`: the
// size of the area divided by the size of the image. `area_uv_most`: the largest texture coordinate at which
// a linear filter reads only the area.
enum class Builtin : uint8_t {
    none,
    frame_index,
    time_s,
    delta_time_s,
    pre_exposure,
    prev_pre_exposure,
    valid,
    unit_valid,
    unit_bits,
    live,
    area_size,
    area_uv,
    area_uv_most,
};

// The value of one member of the shader's block `Params`: a constant in `value`, or a Builtin of the frame.
struct ParamWrite {
    std::string member;
    uint32_t offset_bytes = 0;
    ScalarType scalar = ScalarType::f32;
    uint8_t components = 1;
    Builtin builtin = Builtin::none;
    ResourceId resource = kNoId;  // Only for Builtin::valid: the resource with history.
    // Only for unit_valid, unit_bits, area_size, area_uv and area_uv_most: the index of the port's use in
    // PassDecl::uses.
    uint32_t use = kNoId;
    std::array<double, 4> value{0, 0, 0, 0};
    // Only for Builtin::live: the source of each component, as an index into ResolvedGraph::live_values.
    std::vector<uint32_t> live;
};

struct SpecValue {
    uint32_t id = 0;
    ScalarType type = ScalarType::boolean;
    uint32_t bits = 0;
};

// The specialisation constants and the Params block of a pass in some combinations of the switches.
struct PassVariant {
    CombinationSet combinations = kEveryCombination;
    std::vector<SpecValue> spec_values;
    std::vector<ParamWrite> params;
};

struct NamedValue {
    std::string name;
    double value = 0;
};

// How one pass draws several views, each to its own layer of the attachments. none: the pass draws one view.
// multiview: one draw draws all views; the vertex stage runs once for each view. layer_output: the draws are
// recorded once for each view, and the vertex stage selects the layer.
enum class ViewLowering : uint8_t { none, multiview, layer_output };

struct PassDecl {
    std::string name;
    std::string type;  // "compute", "raster" and so on, or the name of a pass type in C++.
    PassKind kind = PassKind::compute;
    // The queue that the author prefers. The compiler may choose a more capable queue.
    QueueKind queue = QueueKind::graphics;
    std::vector<UseDecl> uses;  // The inputs sorted by port name, then the outputs sorted by port name.
    bool side_effect = false;   // True: the pass has an effect outside the graph, so that it is never culled.
    std::string shader;  // The name of the shader in the graph: the key of its program in ShaderCatalog.
    std::vector<SpecValue> spec_values;
    std::vector<ParamWrite> params;
    uint32_t params_bytes = 0;
    bool params_push = false;
    std::vector<NamedValue> custom_params;    // Parameters by name; only for passes in C++.
    std::array<uint32_t, 3> groups{0, 0, 0};  // Numbers of workgroups; only for compute passes.
    // For indirect dispatches: index into `uses` of the buffer whose first three words are the numbers of
    // workgroups. kNoId: `groups` has these numbers.
    uint32_t indirect_use = kNoId;
    // The members from `colors` to `instances` describe a pass that draws: raster or fullscreen.
    std::vector<AttachmentDecl> colors;  // Colour attachments, sorted by their output location in the shader.
    std::optional<AttachmentDecl> depth;
    Extent3D render_extent;
    RasterState state;
    // Names of imported draw lists. The pass draws all objects in these lists.
    std::vector<std::string> draw_lists;
    // For indirect draws: the index, in `uses`, of the buffer that contains one draw command for each draw.
    // kNoId: the draws are direct.
    uint32_t draw_commands_use = kNoId;
    // The index, in `uses`, of the buffer whose first word is the number of draws. kNoId: all commands are
    // drawn.
    uint32_t draw_count_use = kNoId;
    // For indirect draws without a draw list, or with their number of draws in a buffer: how many draw
    // commands the buffer of `draw_commands_use` contains.
    uint32_t most_draws = 0;
    // For a raster pass without draw lists: number of vertices. The shader computes their positions from
    // gl_VertexIndex.
    uint32_t vertices = 0;
    // For a raster pass without draw lists: how many instances of its vertices are drawn.
    uint32_t instances = 0;
    // The view from which the pass looks at the scene: "camera", or a view of a list, such as "sun(1)".
    std::string view = "camera";
    // Only if the view comes from a buffer and the shader reads the view: the index, in `uses`, of the port
    // that reads the constants of the view. kNoId: the draw source provides these constants.
    uint32_t view_use = kNoId;
    // For a pass that draws several views: the names of all these views, which are successive views of one
    // list. The first of them is `view`. View i is drawn to layer i of the range of each attachment. If the
    // list is empty, the pass draws only `view`.
    std::vector<std::string> views;
    ViewLowering lowering = ViewLowering::none;
    // The reason why Weft has chosen this lowering, for a pass with "views" and "into": "layers" in the
    // graph. Else empty.
    std::string lowering_reason;
    // True: the draw source may leave out direct draws that are outside of the frustum of the view. With
    // multiview: outside of the frustums of all views.
    bool culls_draws = false;
    std::array<float, 4> clear{0, 0, 0, 0};  // Clear value; only for passes of kind `clear`.
    double flops = 0;  // Number of floating-point operations, as declared in the graph's key `cost`.
    // For the passes that a repeat with `perFrame` makes. These passes are divided into `frame_slices`
    // slices, and this pass belongs to slice `frame_slice`. Frame f runs slice f mod frame_slices; frame 0
    // runs all slices. In a frame in which the pass does not run, its earlier results are kept. If
    // frame_slices is 0, the pass runs in every frame.
    uint32_t frame_slice = 0;
    uint32_t frame_slices = 0;
    // For a pass with `rest` or in a group: the number of its unit, less than ResolvedGraph::rest_unit_count.
    // In each frame, either all passes of a unit run, or none of them. kNoId: the pass runs in every frame.
    uint32_t rest_unit = kNoId;
    // For a pass with `switch`: the index of the switch in ResolvedGraph::switches. kNoId: the pass has none.
    uint32_t switch_id = kNoId;
    // The combinations of the switches in which the pass runs. The barriers of the pass are recorded in every
    // frame, even if the pass does not run.
    CombinationSet runs_in = kEveryCombination;
    // For a pass whose inputs depend on switches: its variants. All combinations of the switches that give
    // the pass the same inputs have the same variant, and each combination has one variant. Empty:
    // `spec_values` and `params` are used in all combinations. Otherwise these two members are the values of
    // the first variant.
    std::vector<PassVariant> variants;
    // True for a pass that Weft adds to a resource with `history` and `keep`: it copies the content of the
    // last frame to the copy of this frame, before all other passes that use this copy.
    bool carries = false;
    // The area that the pass draws to or writes in each frame, if its images have a live size: a size that is
    // multiplied by a scale, which the program may change in each frame. `render_extent` and `groups` are the
    // values for the scale 1. The executor replaces the numbers of workgroups by `live_groups` (empty, or one
    // for each dimension), and the numbers of viewport and scissor by `live_sides`.
    LiveArea area;
    std::vector<LiveCount> live_groups;
    std::vector<LiveSide> live_sides;
    // The author's order of passes that do not depend on each other: by this key, then by name. Passes of a
    // graph file have the key 0; a program that makes a graph in memory can set other keys.
    uint32_t order_key = 0;
    SourceLoc loc;

    // Returns all views that the pass draws: `views`, or only `view`.
    [[nodiscard]] std::span<const std::string> drawn_views() const {
        return views.empty() ? std::span(&view, 1) : std::span(views);
    }
    // Returns true for a raster pass that draws vertices without a draw list.
    [[nodiscard]] bool draws_without_list() const {
        return vertices > 0 || (draw_commands_use != kNoId && draw_lists.empty());
    }
};

// Returns true if the pass runs in this frame. Frames are counted from the start of the plan. The barriers of
// the pass are recorded in every frame, even if the pass does not run.
[[nodiscard]] bool runs_in_frame(const PassDecl& pass, uint64_t frame);

// Returns the index of the variant of the pass in this combination; 0 if the pass has no variants.
[[nodiscard]] uint32_t variant_in(const PassDecl& pass, Combination combination);
// Returns the pass as it is in one of its variants: it has the uses, specialisation constants and Params of
// the variant. Uses that the variant does not have keep their index, but have no access and no binding.
[[nodiscard]] PassDecl pass_of_variant(const PassDecl& pass, uint32_t variant);

// A group of passes. It runs in rounds: each round is one copy of all passes of the group, and is a unit
// (PassDecl::rest_unit). Each frame runs some of the rounds, in any order.
struct GroupDecl {
    static constexpr uint32_t kAll = UINT32_MAX;

    std::string name;
    // Round r has the unit number first_unit + r.
    uint32_t first_unit = 0;
    uint32_t rounds = 0;
    uint32_t per_frame = kAll;  // Number of rounds that may run in each frame.
    uint32_t warm_up = kAll;    // Replaces per_frame while some rounds have never run, if it is larger.
    // True: a round runs only if something that affects its result has changed.
    bool rests = false;
    uint32_t settle = 0;  // How often a round runs again after a change.
    // Name of the import with the list of rounds that run in a frame. Empty: the rounds run in the order of
    // their numbers, `per_frame` of them in each frame.
    std::string turns;
    SourceLoc loc;

    [[nodiscard]] bool has_unit(uint32_t unit) const {
        return unit >= first_unit && unit - first_unit < rounds;
    }
    // Returns true if a frame may be unable to run all rounds.
    [[nodiscard]] bool is_limited() const { return per_frame < rounds || warm_up < rounds || !turns.empty(); }
};

struct ResolvedGraph {
    std::string name;
    Extent3D output_extent;
    std::vector<ResourceDecl> resources;  // Resources, sorted by name.
    std::vector<PassDecl> passes;         // Passes, sorted by name.
    std::vector<EdgeDecl> edges;  // Dependencies between passes, sorted by (to, from, kind, resource).
    // The import of kind "output", to which the picture is written; kNoId if the graph has no output.
    ResourceId output = kNoId;
    std::vector<GraphParam> params;  // The graph's parameters with their values.
    // The values that depend on live scales (scales of sizes, which the program may change in each frame).
    // Each value depends only on values before it.
    std::vector<LiveValue> live_values;
    uint32_t rest_unit_count = 0;      // Number of units; see PassDecl::rest_unit.
    std::vector<GroupDecl> groups;     // Sorted by name. The units of groups come after all other units.
    std::vector<SwitchDecl> switches;  // Sorted by the name of the parameter.
    // The lists of views that passes use, sorted by name. A list may show the views of another list in a
    // mirror. Then the other list is included, too.
    std::vector<ViewListDecl> views;
    uint32_t frames = 1;  // Default number of frames of a run. The plan's hash does not include it.
    SourceMap sources;    // File names and texts for messages. The plan's hash does not include them.
};

// Returns the combination of the switches (which of them are on) that follows from the values of the
// parameters.
[[nodiscard]] Combination switches_of(const ResolvedGraph& graph);
// Returns the group that has this unit. Returns null if the unit belongs to no group, or if `unit` is kNoId.
[[nodiscard]] const GroupDecl* find_group(const ResolvedGraph& graph, uint32_t unit);
// Both functions return kNoId if the graph has no resource or pass of this name.
[[nodiscard]] ResourceId find_resource(const ResolvedGraph& graph, std::string_view name);
[[nodiscard]] PassId find_pass(const ResolvedGraph& graph, std::string_view name);

}  // namespace weft
