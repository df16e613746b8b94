// Purpose: a graph as its author wrote it: names interned as strings, expressions compiled, nothing resolved
// yet. Every part keeps the place it was written.
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
// indices; `res.x`-like selections and mips(res) are operations. Evaluated by evaluate() in
// framework/graph/expression.h.
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
    make_size,  // two numbers to a size: "size": [w, h]
};

struct ExprNode {
    ExprOp op = ExprOp::number;
    double number = 0;
    std::string name;  // for `name` and `mips_of`
    SourceLoc loc;     // of the token, inside the string it was written in
};

struct Expr {
    std::vector<ExprNode> postfix;  // empty: absent
    std::string text;
    SourceLoc loc;

    [[nodiscard]] bool empty() const { return postfix.empty(); }
};

// One number for each channel.
struct ColorDesc {
    std::array<Expr, 4> channels;
};

// name@pass[-N].mip(a..b).layer(a..b).depth
struct RefDesc {
    std::string name;
    std::string pass;  // empty: unpinned
    uint32_t history = 0;
    std::optional<Expr> mip_first, mip_last;  // last absent: a single mip
    std::optional<Expr> layer_first, layer_last;
    AspectMask aspects = 0;  // 0: all
    std::string text;
    SourceLoc loc;
};

struct PortDesc {
    std::string port;
    RefDesc ref;
    std::optional<RefDesc> otherwise;  // "else": read where `if` leaves nobody who writes `ref`
    bool optional = false;             // may be left out: the shader has HAS_<port>
    std::optional<SamplerDecl> sampler;
    SourceLoc loc;  // of the port's name
};

struct ParamDesc {
    std::string name;
    double default_value = 0;
    bool is_bool = false;
    std::optional<std::array<double, 2>> range;
    std::vector<double> allowed;  // "enum"
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

// What lives on from frame to frame without a copy of its own: nothing, the resource while its plan lives, or
// the resource across plans (tiers, reloads) as well.
enum class KeepMode : uint8_t { none, frames, shared };

struct ResourceDesc {
    std::string name;
    bool is_buffer = false;
    std::vector<std::string> formats;  // "a|b": first supported wins
    Expr size;                         // one or two components; absent: "render" if defined, else "output"
    ImageKind image_kind = ImageKind::d2;
    Expr mips;  // absent: 1
    bool full_mips = false;
    Expr layers;  // absent: 1; of cube arrays the cubes, of 3D images the depth
    Expr samples;         // absent: 1
    std::string element;  // buffers: "u32", "vec4", or a struct of the import catalogue
    Expr count;
    bool pre_exposed = false;
    std::optional<ColorDesc> clear;
    Expr history;  // copies kept of earlier frames; absent: 0
    KeepMode keep = KeepMode::none;
    std::optional<ColorDesc> first_frame;  // of resources with history or keep; absent: 0
    OnResize on_resize = OnResize::clear;
    SourceLoc loc;
};

struct ParamValueDesc {
    std::string name;
    std::vector<Expr> components;  // one for a scalar
    SourceLoc loc;
};

// "i": "a..b by s": one pass for each value of the index.
struct RepeatDesc {
    std::string index;
    Expr first, last;
    Expr step;            // absent: 1
    SourceLoc loc;        // of the index's name
    SourceLoc range_loc;  // of the range
};

// A multisampled colour output, and where its averages go when the pass ends.
struct ResolveDesc {
    PortDesc target;
    std::string output;  // the port
    SourceLoc output_loc;
};

// A number of the fixed-function state that is an expression: what it may be, and where it goes.
struct StateNumberDesc {
    Expr value;
    double least = 0, most = 0;
    bool whole = false;
    std::function<void(RasterState&, double)> set;
};

// Where a state asks for what some devices lack.
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
    Expr vertices, instances;  // or: so many vertices without a list; instances absent: 1
    std::string view;  // "camera", or of a numbered one the name: "sun" of "sun(i)"
    Expr view_number;  // absent: the view has none
    SourceLoc view_loc;
    std::vector<ParamValueDesc> params;
    std::vector<ParamValueDesc> constants;  // specialisation constants of the shader, by name
    Expr condition;                         // "if"; absent: always
    std::vector<RepeatDesc> repeat;         // outermost first
    Expr per_frame;  // its rounds take turns, so many a frame; absent: all in each
    SourceLoc per_frame_loc;
    std::optional<PortDesc> indirect;  // where the workgroups are counted, or what is drawn of `draws`
    std::vector<Expr> groups;          // workgroups, one or three (or one of two components)
    std::vector<Expr> threads;         // invocations
    RasterState state;
    std::vector<StateNumberDesc> state_numbers;
    StateLocs state_locs;
    std::map<std::string, BlendState> blend;                  // by output port; "" = all
    std::map<std::string, ColorDesc> clear_ports;             // by output port
    std::optional<ColorDesc> clear;
    bool covers = false;
    bool partial = false;  // writes only a part: sees the preceding version
    std::vector<std::string> after;
    std::vector<SourceLoc> after_locs;
    Expr flops;
    SourceLoc loc;
    uint32_t order_key = 0;  // graphs made in memory
};

// A way to look at a resource.
struct DebugViewDesc {
    std::string name;
    RefDesc show;
    std::string decode;                // one of debug_decoders(); empty: what its format suggests
    std::string shader;                // the author's own, in place of a decoder
    std::optional<std::array<Expr, 2>> range;  // what is shown as black and as white
    SourceLoc loc;
};

// What a graph's own test expects of a frame: a number at most, or values within bounds.
struct ExpectationDesc {
    std::string what;  // "validation", "finite", "range", …
    std::string ref;   // of the resource; empty: of the frame
    double least = 0, most = 0;
    SourceLoc loc;
};

struct GraphTestDesc {
    std::vector<std::string> tiers;  // each is run; "" is the file as it is
    std::vector<std::string> swap;   // or: the tiers that one run goes through
    uint32_t every = 8;              // frames between two swaps
    std::string scene;               // empty: builtin:spheres
    Extent3D size{320, 180, 1};
    uint32_t frames = 0;  // 0: the graph's
    std::map<std::string, double> params;
    std::vector<ExpectationDesc> expect;
    SourceLoc loc;
};

// A quality tier: what it changes has been merged into the graph that it was loaded with.
struct TierDesc {
    std::string name;
    SourceLoc loc;
};

inline constexpr uint32_t kMaxFrames = 1'000'000;

struct GraphDesc {
    std::string name;
    std::string tier;             // the one merged in; empty: the file as it is
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
    uint32_t jitter = 0;  // after how many frames the camera's sub-pixel offsets begin again; 0: there are none
    SourceMap sources;
};

}  // namespace weft
