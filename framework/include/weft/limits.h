// Purpose: limits on the contents of files. All limits are in this table: code that reads files gets a part
// of it as an argument, and `--limits FILE` changes limits by name. Input over a limit is refused before work
// or memory is spent. Units: in the names; counts have none. Errors: X560 a limit that does not exist, is not
// a whole number, or lies outside 1 … `most`.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "weft/result.h"
#include "weft/source.h"

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
    uint64_t memory_bytes = 640ull << 20;  // together with the memory of a driver, the program stays below 1
                                           // GiB
};

// Limits for the pictures that `weft compare` reads.
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
    const char* name;    // "graph.passes": the name in messages, files and docs/SECURITY.md
    const char* unit;    // "bytes", "px", "ms"; empty for counts
    const char* guards;  // the things that it limits
    uint64_t most;       // with a higher value, recursion or 64-bit sums might be unsafe
    uint64_t& (*of)(Limits& limits);
};
[[nodiscard]] std::span<const LimitRow> limit_table();

// Reads a JSON object of limits by name: { "graph.passes": 8192 }. Other limits keep their default.
[[nodiscard]] Result<Limits> read_limits(const std::string& path, const FileReader& reader);

// "raise graph.passes with --limits": the end of every message about a limit.
[[nodiscard]] std::string raise_limit_text(const std::string& name);

}  // namespace weft
