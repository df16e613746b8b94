// Purpose: a graph as its author wrote it: names are strings, expressions are parsed, nothing is resolved.
// Every part keeps its place in the file.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/source.h"

namespace weft {

// A number or a size (two components) in postfix form. Names are parameters, constants, sizes or repeat
// indices; `.x`, `.y` and mips(res) are operations. evaluate() in framework/graph/parse/expression.h
// evaluates it.
enum class ExprOp : uint8_t {
    number,
    name,
    mips_of,
    select_x,
    select_y,
    add,
    sub,
    mul,
    div,
    mod,
    negate,
    min,
    max,
    ceil,
    floor,
    log2,
    make_size,  // makes a size from two numbers: "size": [w, h]
};

struct ExprNode {
    ExprOp op = ExprOp::number;
    double number = 0;
    std::string name;  // for `name` and `mips_of`
    SourceLoc loc;     // place of the token inside its string
};

struct Expr {
    std::vector<ExprNode> postfix;  // empty: absent
    std::string text;
    SourceLoc loc;

    [[nodiscard]] bool empty() const { return postfix.empty(); }
};

// One number per channel.
struct ColorDesc {
    std::array<Expr, 4> channels;
};

// name@pass[-N].mip(a..b).layer(a..b).depth
struct RefDesc {
    std::string name;
    std::string pass;  // empty: no pin
    uint32_t history = 0;
    std::optional<Expr> mip_first, mip_last;  // mip_last absent: a single mip
    std::optional<Expr> layer_first, layer_last;
    AspectMask aspects = 0;  // 0: all aspects
    std::string text;
    SourceLoc loc;
};

struct PortDesc {
    std::string port;
    RefDesc ref;
    std::optional<RefDesc> otherwise;  // "else": read instead of `ref` if the `if` conditions remove all its
                                       // writers
    bool optional = false;             // may be left unconnected: the shader has HAS_<port>
    std::optional<SamplerDecl> sampler;
    SourceLoc loc;  // place of the port's name
};

struct ParamDesc {
    std::string name;
    double default_value = 0;
    bool is_bool = false;
    std::optional<std::array<double, 2>> range;
    std::vector<double> allowed;  // for kind "enum"
    double step = 0;
    std::string unit;
    std::string ui;
    SourceLoc loc;
};

struct ImportDesc {
    std::string name;
    std::string kind;
    SourceLoc loc;
};

// Which content a resource keeps between frames, without extra copies: none, its content while the plan
// exists, or also across plans (tiers, reloads).
enum class KeepMode : uint8_t { none, frames, shared };

struct ResourceDesc {
    std::string name;
    bool is_buffer = false;
    std::vector<std::string> formats;  // "a|b": the first supported format is used
    Expr size;                         // one or two components; absent: "render" if defined, else "output"
    ImageKind image_kind = ImageKind::d2;
    Expr mips;  // absent: 1
    bool full_mips = false;
    Expr layers;          // absent: 1; number of cubes of a cube array, depth of a 3D image
    Expr samples;         // absent: 1
    std::string element;  // buffers: "u32", "vec4", or a struct of the import catalogue
    Expr count;
    bool pre_exposed = false;
    std::optional<ColorDesc> clear;
    Expr history;  // number of earlier frames to keep; absent: 0
    KeepMode keep = KeepMode::none;
    std::optional<ColorDesc> first_frame;  // for resources with history or keep; absent: 0
    OnResize on_resize = OnResize::clear;
    SourceLoc loc;
};

struct ParamValueDesc {
    std::string name;
    std::vector<Expr> components;  // one component for a scalar
    SourceLoc loc;
};

// "i": "a..b by s": makes one pass for each value of the index.
struct RepeatDesc {
    std::string index;
    Expr first, last;
    Expr step;            // absent: 1
    SourceLoc loc;        // place of the index's name
    SourceLoc range_loc;  // place of the range
};

// A multisampled colour output, and the resource for its averages at the end of the pass.
struct ResolveDesc {
    PortDesc target;
    std::string output;  // name of the port
    SourceLoc output_loc;
};

// A number of the fixed-function state given by an expression: its allowed values, and its destination.
struct StateNumberDesc {
    Expr value;
    double least = 0, most = 0;
    bool whole = false;
    std::function<void(RasterState&, double)> set;
};

// Places of state that requires optional device features.
struct StateLocs {
    SourceLoc fill, depth_clamp, depth_bias_clamp;
};

struct PassDesc {
    std::string name;
    std::string type;
    QueueKind queue = QueueKind::graphics;
    std::string shader;
    SourceLoc shader_loc;
    std::vector<PortDesc> in;
    std::vector<PortDesc> out;
    std::optional<PortDesc> depth;
    std::vector<ResolveDesc> resolves;
    std::vector<std::string> draws;
    std::vector<SourceLoc> draw_locs;
    Expr vertices, instances;  // alternative: number of vertices without a list; instances absent: 1
    std::string view;          // "camera", or the name of a numbered view: "sun" of "sun(i)"
    Expr view_number;          // absent: the view is not numbered
    SourceLoc view_loc;
    std::vector<ParamValueDesc> params;
    std::vector<ParamValueDesc> constants;  // specialisation constants of the shader, by name
    Expr condition;                         // "if"; absent: true
    std::vector<RepeatDesc> repeat;         // outermost first
    Expr per_frame;  // "perFrame": number of rounds that run in each frame; absent: all
    SourceLoc per_frame_loc;
    std::optional<PortDesc> indirect;  // the port with the workgroup counts, or with draw commands for
                                       // `draws`
    std::vector<Expr> groups;          // workgroup counts: one or three (or one with two components)
    std::vector<Expr> threads;         // invocation counts
    RasterState state;
    std::vector<StateNumberDesc> state_numbers;
    StateLocs state_locs;
    std::map<std::string, BlendState> blend;       // by output port; "": all outputs
    std::map<std::string, ColorDesc> clear_ports;  // by output port
    std::optional<ColorDesc> clear;
    bool covers = false;
    bool partial = false;  // writes only a part, so previous content stays visible
    std::vector<std::string> after;
    std::vector<SourceLoc> after_locs;
    Expr flops;
    SourceLoc loc;
    uint32_t order_key = 0;  // for graphs made in memory
};

// A debug view of a resource.
struct DebugViewDesc {
    std::string name;
    RefDesc show;
    std::string decode;                        // one of debug_decoders(); empty: depends on the format
    std::string shader;                        // the author's own shader instead of a decoder
    std::optional<std::array<Expr, 2>> range;  // values shown as black and white
    SourceLoc loc;
};

// An expected result in a graph's own test: a maximum, or bounds for values.
struct ExpectationDesc {
    std::string what;  // kind of expectation: "validation", "finite", "range", …
    std::string ref;   // name of the resource; empty: the whole frame
    double least = 0, most = 0;
    SourceLoc loc;
};

struct GraphTestDesc {
    std::vector<std::string> tiers;  // tiers to run; "": without a tier
    std::vector<std::string> swap;   // alternative: tiers to swap between in one run
    uint32_t every = 8;              // number of frames between two swaps
    std::string scene;               // empty: builtin:spheres
    Extent3D size{320, 180, 1};
    uint32_t frames = 0;  // 0: the graph's number of frames
    std::map<std::string, double> params;
    std::vector<ExpectationDesc> expect;
    SourceLoc loc;
};

// A quality tier. Its changes are already merged into the graph that was loaded with this tier.
struct TierDesc {
    std::string name;
    SourceLoc loc;
};

inline constexpr uint32_t kMaxFrames = 1'000'000;

struct GraphDesc {
    std::string name;
    std::string tier;             // name of the merged tier; empty: none
    std::vector<TierDesc> tiers;  // in the order written
    std::map<std::string, Expr> consts;
    std::map<std::string, ParamDesc> params;
    std::map<std::string, Expr> sizes;
    std::map<std::string, ImportDesc> imports;
    std::map<std::string, ResourceDesc> resources;
    std::map<std::string, PassDesc> passes;
    Expr frames;  // absent: 1
    std::map<std::string, DebugViewDesc> debug;
    std::vector<GraphTestDesc> tests;
    uint32_t jitter = 0;  // period of the camera's sub-pixel offsets in frames; 0: no offsets
    SourceMap sources;
};

}  // namespace weft
