// Purpose: limits on the contents of files, so that a hostile file cannot exhaust memory or time. The struct
// Limits has all limits; `--limits FILE` changes them by name. Code that reads files gets its part of Limits
// as an argument, and refuses input over a limit before it spends work or memory on it. Units: in the names;
// counts have none. Errors: X560 the limit file is not an object, names a limit that does not exist, or has a
// value that is not a whole number from 1 to LimitRow::most.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "weft/file_reader.h"
#include "weft/result.h"

namespace weft {

struct GraphLimits {
    uint64_t json_bytes = 8ull << 20;
    uint64_t json_depth = 64;
    uint64_t json_values = 1ull << 18;
    uint64_t string_bytes = 4096;
    uint64_t name_bytes = 128;
    uint64_t include_files = 64;
    uint64_t tiers = 16;
    uint64_t constants = 4096;
    uint64_t expression_parts = 1ull << 18;
    uint64_t repeat_indices = 8;
    uint64_t debug_views = 256;
    uint64_t test_runs = 1024;
    uint64_t test_frames = 16'384;
    uint64_t test_bytes = 512ull << 20;
    uint64_t passes = 4096;
    uint64_t pass_ports = 256;
    uint64_t ports = 1ull << 18;
    uint64_t steps = 1ull << 24;
    uint64_t resources = 16'384;
    uint64_t image_side_px = 16'384;
    uint64_t mips = 15;
    uint64_t layers = 2048;
    uint64_t buffer_pieces = 2048;
    uint64_t transient_bytes = 4ull << 30;
};

struct ShaderLimits {
    uint64_t file_bytes = 1ull << 20;
    uint64_t text_bytes = 16ull << 20;
    uint64_t files = 1000;
    uint64_t includes = 1000;
    uint64_t include_depth = 32;
    uint64_t worker_bytes = 1ull << 30;
    uint64_t stage_ms = 4000;
    uint64_t graph_ms = 60'000;
    uint64_t spirv_bytes = 4ull << 20;
    uint64_t inlined_bytes = 32ull << 20;
    uint64_t shared_bytes = 64ull << 10;
    uint64_t private_bytes = 64ull << 10;
    uint64_t push_constant_bytes = 4096;
    uint64_t interface_bytes = 2048;
};

struct SceneLimits {
    uint64_t json_bytes = 64ull << 20;
    uint64_t json_values = 1'000'000;
    uint64_t json_depth = 64;
    uint64_t resource_bytes = 512ull << 20;
    uint64_t array_items = 262'144;
    uint64_t materials = 4096;
    uint64_t node_depth = 512;
    uint64_t instances = 262'144;
    uint64_t vertices = 4'000'000;
    uint64_t triangles = 8'000'000;
    uint64_t image_side_px = 16'384;
    // Memory for a scene. With this default, the whole program, including the memory of the graphics driver,
    // stays below 1 GiB.
    uint64_t memory_bytes = 640ull << 20;
};

// Limits for the picture files that `weft compare` reads.
struct PictureLimits {
    uint64_t file_bytes = 512ull << 20;
    uint64_t side_px = 16'384;
    uint64_t memory_bytes = 768ull << 20;
};

struct Limits {
    GraphLimits graph;
    ShaderLimits shader;
    SceneLimits scene;
    PictureLimits picture;
};

struct LimitRow {
    // Name in messages, in limit files and in docs/SECURITY.md, for example "graph.passes".
    const char* name;
    const char* unit;    // Unit: "bytes", "px" or "ms"; empty if the limit is a count.
    const char* guards;  // The quantity that is limited, in words, such as "mips of an image".
    // The largest value that may be set. Larger values would be unsafe: for example, a greater depth could
    // overflow the stack, and a greater size could overflow a 64-bit sum.
    uint64_t most;
    // Returns the limit of this row in `limits`.
    uint64_t& (*of)(Limits& limits);
};
[[nodiscard]] std::span<const LimitRow> limit_table();

// Reads a JSON object that sets limits by name, such as { "graph.passes": 8192 }. All other limits keep their
// default.
[[nodiscard]] Result<Limits> read_limits(const std::string& path, const FileReader& reader);

// Returns the end of a help text about a limit, such as "or raise graph.passes with --limits".
[[nodiscard]] std::string raise_limit_text(const std::string& name);

}  // namespace weft
