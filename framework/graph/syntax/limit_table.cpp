#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "weft/limits.h"
#include "weft/syntax/json_doc.h"

namespace weft {
namespace {

constexpr uint64_t kMostBytes = 1ull << 40;
constexpr uint64_t kMostItems = 1ull << 24;
// Largest nesting depth that a user may allow: recursive readers would overflow the stack at a greater depth.
constexpr uint64_t kMostDepth = 512;
constexpr uint64_t kMostSide_px = 1ull << 16;
constexpr uint64_t kMostTime_ms = 3'600'000;

constexpr std::array kTable{
    LimitRow{"graph.jsonBytes", "bytes", "size of a graph file", 1ull << 28,
             [](Limits& l) -> uint64_t& { return l.graph.json_bytes; }},
    LimitRow{"graph.jsonDepth", "", "depth of nested objects and arrays in a graph file", kMostDepth,
             [](Limits& l) -> uint64_t& { return l.graph.json_depth; }},
    LimitRow{
        "graph.jsonValues", "",
        "number of JSON values in the graph file and its included files together, multiplied by the number "
        "of tiers plus 1",
        kMostItems, [](Limits& l) -> uint64_t& { return l.graph.json_values; }},
    LimitRow{"graph.stringBytes", "bytes", "length of a string or key in a graph file", 1ull << 20,
             [](Limits& l) -> uint64_t& { return l.graph.string_bytes; }},
    LimitRow{"graph.nameBytes", "bytes", "length of a name, for example of a pass or resource", 1ull << 12,
             [](Limits& l) -> uint64_t& { return l.graph.name_bytes; }},
    LimitRow{
        "graph.includeFiles", "",
        "number of files that a graph includes; a file counts once for the graph, and once for each module "
        "that it belongs to",
        1ull << 10, [](Limits& l) -> uint64_t& { return l.graph.include_files; }},
    LimitRow{"graph.tiers", "", "number of tiers", 1ull << 10,
             [](Limits& l) -> uint64_t& { return l.graph.tiers; }},
    LimitRow{"graph.constants", "", "number of parameters, constants and sizes together", 1ull << 20,
             [](Limits& l) -> uint64_t& { return l.graph.constants; }},
    LimitRow{"graph.expressionParts", "",
             "number of numbers, names and operators in all expressions together", kMostItems,
             [](Limits& l) -> uint64_t& { return l.graph.expression_parts; }},
    LimitRow{"graph.repeatIndices", "", "number of indices of a `repeat`", 64,
             [](Limits& l) -> uint64_t& { return l.graph.repeat_indices; }},
    LimitRow{"graph.debugViews", "", "number of debug views", 1ull << 16,
             [](Limits& l) -> uint64_t& { return l.graph.debug_views; }},
    LimitRow{"graph.testRuns", "",
             "number of runs of the tests that a graph file contains; a test with several tiers has one run "
             "per tier",
             1ull << 20, [](Limits& l) -> uint64_t& { return l.graph.test_runs; }},
    LimitRow{"graph.testFrames", "",
             "number of frames that all runs of the tests in a graph file render together", 1ull << 32,
             [](Limits& l) -> uint64_t& { return l.graph.test_frames; }},
    LimitRow{"graph.testBytes", "bytes",
             "memory of one run of a test in a graph file: its picture, the resources of the frame, and data "
             "read back",
             kMostBytes, [](Limits& l) -> uint64_t& { return l.graph.test_bytes; }},
    LimitRow{"graph.passes", "", "number of passes, after each `repeat` is expanded", 1ull << 20,
             [](Limits& l) -> uint64_t& { return l.graph.passes; }},
    LimitRow{"graph.passPorts", "", "number of ports of a pass", 1ull << 16,
             [](Limits& l) -> uint64_t& { return l.graph.pass_ports; }},
    LimitRow{"graph.ports", "", "number of ports of all expanded passes together", kMostItems,
             [](Limits& l) -> uint64_t& { return l.graph.ports; }},
    LimitRow{"graph.steps", "",
             "number of steps to resolve a graph with all its tiers: expressions, subresource ranges, orders "
             "of passes",
             1ull << 40, [](Limits& l) -> uint64_t& { return l.graph.steps; }},
    LimitRow{"graph.resources", "", "number of resources; each copy of a history counts", 1ull << 20,
             [](Limits& l) -> uint64_t& { return l.graph.resources; }},
    LimitRow{"graph.imageSidePx", "px", "width, height and depth of an image; the device may allow less",
             kMostSide_px, [](Limits& l) -> uint64_t& { return l.graph.image_side_px; }},
    LimitRow{"graph.mips", "", "number of mips of an image", 17,
             [](Limits& l) -> uint64_t& { return l.graph.mips; }},
    LimitRow{"graph.layers", "",
             "number of layers of an image, and of textures of a table; the device may allow less",
             kMostSide_px, [](Limits& l) -> uint64_t& { return l.graph.layers; }},
    LimitRow{"graph.bufferPieces", "", "number of pieces into which the ranges of a buffer divide it",
             kMostSide_px, [](Limits& l) -> uint64_t& { return l.graph.buffer_pieces; }},
    LimitRow{"graph.transientBytes", "bytes",
             "size of one resource, and of all memory for the resources of the frame", kMostBytes,
             [](Limits& l) -> uint64_t& { return l.graph.transient_bytes; }},
    LimitRow{"graph.fileBytes", "bytes",
             "size of all files that resources read, together; a picture counts with 16 bytes per pixel",
             kMostBytes, [](Limits& l) -> uint64_t& { return l.graph.file_bytes; }},
    LimitRow{"shader.fileBytes", "bytes", "size of a shader file", 1ull << 28,
             [](Limits& l) -> uint64_t& { return l.shader.file_bytes; }},
    LimitRow{"shader.textBytes", "bytes", "size of all files of a shader together", 1ull << 30,
             [](Limits& l) -> uint64_t& { return l.shader.text_bytes; }},
    LimitRow{"shader.files", "", "number of files of a shader", kMostItems,
             [](Limits& l) -> uint64_t& { return l.shader.files; }},
    LimitRow{"shader.includes", "", "number of `#include` lines that the compiler follows in one stage",
             kMostItems, [](Limits& l) -> uint64_t& { return l.shader.includes; }},
    LimitRow{"shader.includeDepth", "", "depth of nested `#include` lines", kMostDepth,
             [](Limits& l) -> uint64_t& { return l.shader.include_depth; }},
    LimitRow{"shader.workerBytes", "bytes", "address space of the process that compiles shaders", kMostBytes,
             [](Limits& l) -> uint64_t& { return l.shader.worker_bytes; }},
    LimitRow{"shader.stageMs", "ms", "processor time to compile one stage", kMostTime_ms,
             [](Limits& l) -> uint64_t& { return l.shader.stage_ms; }},
    LimitRow{"shader.graphMs", "ms", "processor time to compile all stages of a graph", kMostTime_ms,
             [](Limits& l) -> uint64_t& { return l.shader.graph_ms; }},
    LimitRow{"shader.spirvBytes", "bytes", "SPIR-V of a compiled stage", 1ull << 28,
             [](Limits& l) -> uint64_t& { return l.shader.spirv_bytes; }},
    LimitRow{"shader.inlinedBytes", "bytes", "SPIR-V of a compiled stage in which all calls are inlined",
             1ull << 32, [](Limits& l) -> uint64_t& { return l.shader.inlined_bytes; }},
    LimitRow{"shader.sharedBytes", "bytes",
             "size of all `shared` variables of a compute stage; the device may allow less", 1ull << 30,
             [](Limits& l) -> uint64_t& { return l.shader.shared_bytes; }},
    LimitRow{"shader.privateBytes", "bytes",
             "size of the private variables of one invocation, and of arrays that it copies as a whole; the "
             "variables of a function count at each call",
             1ull << 30, [](Limits& l) -> uint64_t& { return l.shader.private_bytes; }},
    LimitRow{"shader.pushConstantBytes", "bytes", "size of the push constants; the device may allow less",
             1ull << 20, [](Limits& l) -> uint64_t& { return l.shader.push_constant_bytes; }},
    LimitRow{"shader.interfaceBytes", "bytes", "size of all inputs of a stage, and of all its outputs",
             1ull << 20, [](Limits& l) -> uint64_t& { return l.shader.interface_bytes; }},
    LimitRow{"scene.jsonBytes", "bytes", "size of the JSON in a glTF file", 1ull << 32,
             [](Limits& l) -> uint64_t& { return l.scene.json_bytes; }},
    LimitRow{"scene.jsonValues", "", "number of JSON values in a glTF file", 1ull << 28,
             [](Limits& l) -> uint64_t& { return l.scene.json_values; }},
    LimitRow{"scene.jsonDepth", "", "depth of nested objects and arrays in the JSON of a glTF file",
             kMostDepth, [](Limits& l) -> uint64_t& { return l.scene.json_depth; }},
    LimitRow{"scene.resourceBytes", "bytes", "size of all buffers and encoded images of a scene together",
             kMostBytes, [](Limits& l) -> uint64_t& { return l.scene.resource_bytes; }},
    LimitRow{"scene.arrayItems", "",
             "number of items of each array in a scene: nodes, accessors, buffer views, meshes", 1ull << 28,
             [](Limits& l) -> uint64_t& { return l.scene.array_items; }},
    LimitRow{"scene.materials", "", "number of materials of a scene, and also of textures and of images",
             kMostItems, [](Limits& l) -> uint64_t& { return l.scene.materials; }},
    LimitRow{"scene.nodeDepth", "", "depth of nested nodes of a scene", kMostItems,
             [](Limits& l) -> uint64_t& { return l.scene.node_depth; }},
    LimitRow{
        "scene.instances", "",
        "number of meshes in the scene; a mesh counts once for each node that uses it, and once for each "
        "instance of `EXT_mesh_gpu_instancing`",
        1ull << 28, [](Limits& l) -> uint64_t& { return l.scene.instances; }},
    LimitRow{"scene.vertices", "", "number of vertices of all meshes, and of values of all sparse accessors",
             1ull << 31, [](Limits& l) -> uint64_t& { return l.scene.vertices; }},
    LimitRow{"scene.triangles", "", "number of triangles of all meshes", 1ull << 31,
             [](Limits& l) -> uint64_t& { return l.scene.triangles; }},
    LimitRow{"scene.imageSidePx", "px", "width and height of a texture", kMostSide_px,
             [](Limits& l) -> uint64_t& { return l.scene.image_side_px; }},
    LimitRow{"scene.memoryBytes", "bytes",
             "all memory for a scene: files, meshes, textures with mips, loading, the copy on the GPU",
             kMostBytes, [](Limits& l) -> uint64_t& { return l.scene.memory_bytes; }},
    LimitRow{"picture.fileBytes", "bytes", "size of a picture file that `weft compare` reads", kMostBytes,
             [](Limits& l) -> uint64_t& { return l.picture.file_bytes; }},
    LimitRow{"picture.sidePx", "px", "width and height of a picture that `weft compare` reads", kMostSide_px,
             [](Limits& l) -> uint64_t& { return l.picture.side_px; }},
    LimitRow{"picture.memoryBytes", "bytes", "all memory that `weft compare` needs", kMostBytes,
             [](Limits& l) -> uint64_t& { return l.picture.memory_bytes; }},
};

const LimitRow* find_row(const std::string& name) {
    const auto* row = std::ranges::find(kTable, std::string_view(name), &LimitRow::name);
    return row == kTable.end() ? nullptr : row;
}

Diagnostic fault(const JsonDoc& document, SourceLoc loc, const std::string& pointer, std::string message) {
    Diagnostic d = document.sources.error(loc, "X560", std::move(message));
    d.pointer = pointer;
    return d;
}

Diagnostic unknown_name(const JsonDoc& document, const JsonMember& member) {
    Diagnostic d =
        fault(document, member.key_loc, "/" + member.key, "no limit has the name \"" + member.key + "\"");
    std::vector<std::string> names;
    std::string list;
    for (const LimitRow& row : kTable) {
        names.emplace_back(row.name);
        list += (list.empty() ? "" : ", ") + names.back();
    }
    if (const std::string near = did_you_mean_text(member.key, names); !near.empty()) d.help.push_back(near);
    d.help.push_back("the limits are " + list);
    return d;
}

void read_limit(const JsonDoc& document, const JsonMember& member, Limits& limits, Diagnostics& errors) {
    const LimitRow* row = find_row(member.key);
    if (row == nullptr) {
        errors.push_back(unknown_name(document, member));
        return;
    }
    const JsonNode& value = member.value;
    const bool whole = value.kind == JsonKind::number && value.number == std::floor(value.number);
    if (whole && value.number >= 1 && value.number <= static_cast<double>(row->most)) {
        row->of(limits) = static_cast<uint64_t>(value.number);
        return;
    }
    const std::string found =
        value.kind == JsonKind::number ? value.string : std::string(json_kind_name(value.kind));
    const std::string unit = *row->unit == 0 ? "" : std::string(" ") + row->unit;
    errors.push_back(fault(document, value.loc, "/" + member.key,
                           "limit \"" + member.key + "\" is " + found + ", wanted a whole number of 1 to " +
                               std::to_string(row->most) + unit));
    errors.back().help.push_back("the default is " + std::to_string(row->of(limits)) + unit);
}

}  // namespace

std::span<const LimitRow> limit_table() {
    return kTable;
}

Result<Limits> read_limits(const std::string& path, const FileReader& reader) {
    Result<JsonDoc> document = read_json(path, reader);
    if (!document) return document.take_errors();
    if (document->root.kind != JsonKind::object) {
        Diagnostic d = fault(*document, document->root.loc, "",
                             std::string("found ") + json_kind_name(document->root.kind) +
                                 ", wanted an object with names and values of limits");
        d.help.emplace_back("write for example { \"graph.passes\": 8192 }");
        return d;
    }
    Limits limits;
    Diagnostics errors;
    for (const JsonMember& member : document->root.members) read_limit(*document, member, limits, errors);
    if (!errors.empty()) return errors;
    return limits;
}

std::string raise_limit_text(const std::string& name) {
    return "or raise " + name + " with --limits";
}

}  // namespace weft
