// Purpose: describes a graph as its author wrote it: names are strings, expressions are parsed but not
// evaluated, and nothing is resolved. Every part knows its place in the file, so that messages can name the
// line.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/expression_desc.h"
#include "weft/module_desc.h"
#include "weft/source.h"

namespace weft {

// The key "scale" of a size: in each frame, passes use only a part of the images with this size.
struct SizeScaleDesc {
    std::string param;  // The parameter with the scale, from above 0 to 1.
    SourceLoc loc;
};

// Places of the values of a sampler in the file; line 0: the key is absent.
struct SamplerLocs {
    SourceLoc compare, reduction, anisotropy, lod_bias, max_lod;
};

struct PortDesc {
    std::string port;
    RefDesc ref;
    // The reference in the key "else". The port reads it instead of `ref` if all passes that write `ref` are
    // removed, because their "if" is false or their "repeat" is empty.
    std::optional<RefDesc> otherwise;
    // True: the port may have no resource. The shader's constant HAS_<port> tells whether it has one.
    bool optional = false;
    // False: a change of the content of this port does not make a pass with "rest" run.
    bool wakes = true;
    // Not `none`: the port is an array in the shader, with one element for each mip or layer of `ref`.
    EachPart each = EachPart::none;
    SourceLoc each_loc = {};
    std::optional<SamplerDecl> sampler;
    SamplerLocs sampler_locs = {};
    SourceLoc loc;  // Place of the port's name in the file.
};

struct ParamDesc {
    std::string name;
    double default_value = 0;
    // True if the values of the parameter are `true` and `false`, not numbers.
    bool is_bool = false;
    std::optional<std::array<double, 2>> range;  // Smallest and largest value; absent: no limits.
    std::vector<double> allowed;  // The allowed values, from the key "enum"; empty: all values in `range`.
    double step = 0;              // Step of a slider in a user interface; 0: continuous.
    std::string unit;             // Unit to show after the value, such as "m".
    std::string ui;               // Group and label of the control in a user interface, such as "Fog/Reach".
    SourceLoc loc;
};

struct ImportDesc {
    std::string name;
    std::string kind;
    SourceLoc loc;
};

// A list of views in the section "views". Its views are of one of three kinds: the views of another list or
// the camera (unchanged, or seen in a mirror), the six faces of a cube, or the elements of a buffer.
struct ViewListDesc {
    std::string name;
    std::string of;  // Name of the other list, or "camera"; empty for a cube and for a buffer.
    SourceLoc of_loc;
    // The part of the other list: the number of its first view, and the number of views. Absent: all views.
    // A list whose views are the elements of a buffer always has `count`.
    Expr first, count;
    // The buffer whose elements are the views. It is described like an input port, because the passes that
    // use these views read it.
    std::optional<PortDesc> buffer;
    // The plane of a mirror: the points (x, y, z) with a x + b y + c z + d = 0.
    std::optional<std::array<Expr, 4>> plane;
    // The centre of a cube in metres, in world space, and the distance of the near planes of its faces.
    std::optional<std::array<Expr, 3>> at;
    Expr near_m;
    // The rectangle of each view for passes with "into": "rects": x, y, width and height in pixels. The
    // expressions may contain the number of the view, with the name "view". Absent: the views form a grid.
    std::optional<std::array<Expr, 4>> rect;
    SourceLoc loc;
};

// How many views a pass draws, and where: one view, or all views of a list. layers: each view has a layer of
// the attachments. rects: each view has a rectangle of the attachments.
enum class ViewTarget : uint8_t { one, layers, rects };

// The key "lowering" of a pass whose views are layers: how Weft draws the views. automatic: Weft chooses, as
// if the key were absent. passes: one pass for each view.
enum class LoweringDesc : uint8_t { automatic, multiview, layer_output, passes };

// Name of the index with the number of the view, in passes that draw all views of a list.
inline constexpr const char* kViewIndex = "view";
// Begins the name of the port through which a pass reads its view from a buffer, as in "views:fitted".
inline constexpr std::string_view kViewPort = "views:";

// Tells how long a resource keeps its content. none: for one frame, unless it has `history`. frames and
// shared: from frame to frame, and into a new plan as transition() decides. shared: the new plan uses the
// same memory, if the shape is the same.
enum class KeepMode : uint8_t { none, frames, shared };

// The file with the content of a resource, the key "file".
struct FileDesc {
    std::string name;  // As in the graph file; empty: the resource has no file.
    SourceLoc loc;
    // The members below describe the file that was found. load_graph() sets them.
    std::string path;  // Empty: the file was not searched, or not found.
    uint64_t size_bytes = 0;
    // Size of the picture in the file in pixels; 0: the file contains raw bytes.
    uint32_t width_px = 0, height_px = 0;
};

struct ResourceDesc {
    std::string name;
    bool is_buffer = false;
    FileDesc file;
    // The files of a table of textures; empty: the resource is no table.
    std::vector<FileDesc> textures = {};
    // Alternatives such as "rg16_snorm|rg16f". Weft uses the first format that the device supports for all
    // uses of the image, in every tier.
    std::vector<std::string> formats;
    // One or two components. Absent: the size named "render" if the graph defines it, else the size "output".
    Expr size;
    ImageKind image_kind = ImageKind::d2;
    Expr mips;  // Number of mips; absent: 1.
    // True for "mips": "full": the chain of mips ends with one texel.
    bool full_mips = false;
    Expr layers;   // Number of layers, number of cubes of a cube array, or depth of a 3D image; absent: 1.
    Expr samples;  // Number of samples per pixel; absent: 1.
    // Element type of a buffer: "u32", "vec4", or the name of a struct in the import catalogue.
    std::string element;
    Expr count;
    bool pre_exposed = false;  // True: shaders store values that are multiplied by the exposure.
    std::optional<ColorDesc> clear;
    Expr history;  // Number of earlier frames whose content is kept; absent: 0.
    KeepMode keep = KeepMode::none;
    // Initial content of a resource with `history` or `keep`; absent: 0.
    std::optional<ColorDesc> first_frame;
    OnResize on_resize = OnResize::clear;
    // Name of the group to which the resource belongs; empty: none. The name of such a resource begins with
    // the group: "relight::raw". Only the passes of the group use it.
    std::string group;
    SourceLoc loc;
};

struct ParamValueDesc {
    std::string name;
    std::vector<Expr> components;  // One expression for a scalar, two to four for a vector.
    SourceLoc loc;
};

// The key "repeat": { "i": "a..b by s" }. It makes one pass for each value of the index i: a, a + s, … up to
// b, inclusive. If s is negative, i counts down.
struct RepeatDesc {
    std::string index;
    Expr first, last;
    Expr step;            // Step of the index; absent: 1.
    SourceLoc loc;        // Place of the index's name in the file.
    SourceLoc range_loc;  // Place of the range "a..b by s" in the file.
};

// The key "resolve" of a pass. At the end of the pass, the averages of the samples of the multisampled output
// `output` are written to `target`. For integer formats, sample 0 is written instead of the average.
struct ResolveDesc {
    PortDesc target;
    std::string output;  // Port name of the multisampled output.
    SourceLoc output_loc;
};

// Stores a number in the fixed-function state of a pass.
using StateSetter = void (*)(RasterState&, double);

// A number of the viewport or the scissor rectangle: side 0 to 3 is x, y, width, height.
struct RectSideDesc {
    bool scissor = false;
    uint32_t side = 0;
};

// A number of the fixed-function state that the graph gives as an expression. resolve() evaluates `value`,
// checks that the result is in [least, most] and whole if required, and stores it with `set`.
struct StateNumberDesc {
    Expr value;
    double least = 0, most = 0;
    bool whole = false;
    StateSetter set = nullptr;
    std::optional<RectSideDesc> rect = {};  // Absent: the number belongs to no rectangle.
};

// Some pipeline state is supported only by some devices. These are the places of such state in the file, for
// the messages about missing features.
struct StateLocs {
    SourceLoc fill, depth_clamp, depth_bias_clamp;
};

struct PassDesc {
    // The name of a pass in a group contains the name of the group: "relight::filter".
    std::string name;
    std::string group;  // Name of the group to which the pass belongs; empty: none.
    // True for the pass of a debug view, which Weft adds to show a resource. It may read resources of groups.
    bool observes = false;
    // The module to which the pass belongs, a key of GraphDesc::modules; empty: none.
    std::string module;
    std::string type;
    QueueKind queue = QueueKind::graphics;
    std::string shader;  // Key of ShaderCatalog. place_shaders() may add a folder to the name in the file.
    // If an included file names the shader: the folder of this file, and the name without the folder.
    std::string shader_folder, shader_in_folder;
    SourceLoc shader_loc;
    std::vector<PortDesc> in;
    std::vector<PortDesc> out;
    std::optional<PortDesc> depth;
    std::vector<ResolveDesc> resolves;
    std::vector<std::string> draws;
    std::vector<SourceLoc> draw_locs;
    // Numbers of vertices and instances for a pass that draws without a list; `instances` absent: 1.
    Expr vertices, instances;
    std::string view;  // "camera", or the name of a numbered view without its number: "sun" for "sun(i)".
    Expr view_number;  // The number of a numbered view: i in "sun(i)"; absent: the view has no number.
    SourceLoc view_loc;
    // If the pass has the key "views", it draws all views of a list. Then `view` is the name of the list, and
    // the last index of `repeat` is kViewIndex.
    ViewTarget view_target = ViewTarget::one;
    LoweringDesc lowering = LoweringDesc::automatic;
    SourceLoc lowering_loc;
    std::vector<ParamValueDesc> params;
    std::vector<ParamValueDesc> constants;  // Values of the shader's specialisation constants, by name.
    Expr condition;  // The key "if": the pass is removed if the value is 0; absent: it is never removed.
    // The key "switch": the name of the parameter that turns the pass on and off while frames are rendered;
    // empty: none. `switch_inverted`: the pass runs while the parameter is 0, as with "!name".
    std::string switch_param;
    bool switch_inverted = false;
    SourceLoc switch_loc;
    // The indices of the key "repeat". If there are several, the first is the outermost loop. The repeat of a
    // pass in a group begins with the indices of the group.
    std::vector<RepeatDesc> repeat;
    bool frustum = true;  // False: draws outside of the view's frustum are drawn too.
    // The key "perFrame": number of passes of the repeat that run in each frame; absent or 0: all.
    Expr per_frame;
    SourceLoc per_frame_loc;
    // The key "rest": the pass runs only in frames in which something that affects its result has changed.
    bool rests = false;
    SourceLoc rest_loc;
    // A port that reads a buffer with the numbers of workgroups of an indirect dispatch, or, for a raster
    // pass, with the draw commands of an indirect draw.
    std::optional<PortDesc> indirect;
    // For an indirect draw: a port that reads a buffer with the number of draws; absent: all are drawn.
    std::optional<PortDesc> draw_count;
    // Numbers of workgroups in x, y and z: one to three expressions. If there is only one expression and its
    // value is a size, it gives x and y.
    std::vector<Expr> groups;
    std::vector<Expr> threads;  // Numbers of shader invocations, in the same form as `groups`.
    RasterState state;
    std::vector<StateNumberDesc> state_numbers;
    StateLocs state_locs;
    // Blending, by the name of the output port; the key "" applies to all outputs.
    std::map<std::string, BlendState> blend;
    std::map<std::string, ColorDesc> clear_ports;  // Clear values, by the name of the output port.
    std::optional<ColorDesc> clear;
    bool covers = false;  // True: the pass writes every texel of its outputs, so no clear is needed.
    // True: the pass writes only a part of its outputs. The rest of each output keeps its previous content.
    bool partial = false;
    std::vector<std::string> after;
    std::vector<SourceLoc> after_locs;
    Expr flops;  // The key "cost": number of floating-point operations of the pass.
    SourceLoc loc;
    // Passes without dependencies on each other are ordered by this key, then by name. Graph files do not set
    // it.
    uint32_t order_key = 0;

    // Returns true for a raster pass that draws vertices without a draw list.
    [[nodiscard]] bool draws_without_list() const {
        return type == "raster" && (!vertices.empty() || (indirect && draws.empty()));
    }
};

// A group of passes. Each value of the group's repeat makes a round: one copy of all passes of the group. The
// passes of a round run together, one after the other. The passes and resources of the group are in
// GraphDesc::passes and GraphDesc::resources.
struct GroupDesc {
    std::string name;
    std::vector<RepeatDesc> repeat;  // The indices of the key "repeat"; empty: the group has one round.
    Expr per_frame;                  // Number of rounds that may run in each frame; absent: all.
    SourceLoc per_frame_loc;
    std::string turns;  // The import with the list of the rounds to run; empty: the rounds run in turn.
    SourceLoc turns_loc;
    // Number of rounds per frame while some rounds have not run yet; absent: all.
    Expr warm_up;
    SourceLoc warm_up_loc;
    bool rests = false;  // A round runs only if something that affects its result has changed.
    SourceLoc rest_loc;
    Expr settle;  // How often a round runs again after a change; absent: 0.
    SourceLoc settle_loc;
    SourceLoc loc;
};

// A debug view: it shows the values of a resource as colours.
struct DebugViewDesc {
    std::string name;
    RefDesc show;
    // The method that converts values to colours, one of debug_decoders(); empty: chosen by the format.
    std::string decode;
    std::string shader;  // The author's own shader, used instead of a decoder; empty: a decoder is used.
    // The value that is shown as black and the value that is shown as white.
    std::optional<std::array<Expr, 2>> range;
    SourceLoc loc;
};

// An expected result in a test of the graph: a measured value must lie in [least, most]. The kinds "finite"
// and "kept" have no such limits.
struct ExpectationDesc {
    std::string what;  // Kind of expectation: "validation", "finite", "range" and so on.
    std::string ref;   // Name of the resource that is examined; empty: the whole frame.
    double least = 0, most = 0;
    SourceLoc loc;
};

struct GraphTestDesc {
    // The tiers with which the test runs, one run for each; "" is the graph without a tier.
    std::vector<std::string> tiers;
    // Used instead of `tiers`: the tiers of a single run, which changes from each tier to the next one.
    std::vector<std::string> swap;
    uint32_t every = 8;  // Number of frames between two changes of the tier in `swap`.
    std::string scene;   // The scene to render; empty: builtin:spheres.
    Extent3D size{320, 180, 1};
    uint32_t frames = 0;  // Number of frames of the run; 0: GraphDesc::frames.
    std::map<std::string, double> params;
    std::vector<ExpectationDesc> expect;
    SourceLoc loc;
};

// A quality tier of the graph. GraphDesc already contains the changes of the tier with which it was loaded.
struct TierDesc {
    std::string name;
    SourceLoc loc;
};

inline constexpr uint32_t kMaxFrames = 1'000'000;

struct GraphDesc {
    std::string name;
    std::string tier;             // Name of the tier whose changes are contained in this graph; empty: none.
    std::vector<TierDesc> tiers;  // All tiers, in the order in which the file lists them.
    std::map<std::string, Expr> consts;
    std::map<std::string, ParamDesc> params;
    std::map<std::string, Expr> sizes;
    // The scale of each size with the key "scale" (live size). Key: name of the size.
    std::map<std::string, SizeScaleDesc> size_scales;
    std::map<std::string, ImportDesc> imports;
    std::map<std::string, ViewListDesc> views;
    std::map<std::string, ResourceDesc> resources;
    std::map<std::string, PassDesc> passes;
    std::map<std::string, GroupDesc> groups;
    std::map<std::string, ModuleDesc> modules;  // Key: full name of the module, for example "glass".
    Expr frames;                                // Number of frames of a run; absent: 1.
    std::map<std::string, DebugViewDesc> debug;
    std::vector<GraphTestDesc> tests;
    // The camera moves by fractions of a pixel from frame to frame. The movement repeats after this number of
    // frames; 0: no movement.
    uint32_t jitter = 0;
    SourceMap sources;
};

}  // namespace weft
