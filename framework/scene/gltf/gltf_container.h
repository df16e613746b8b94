// Purpose: finds the JSON text and the binary chunk of a .gltf or .glb without copying them, and rejects JSON
// whose size, depth or number of values exceeds the limits. Source: "glTF 2.0 Specification", chapter 4, "GLB
// File Format Specification".
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "scene/loading/gltf_report.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

struct Container {
    std::string_view json;
    // Bytes of the binary chunk; present only in a .glb file that has a BIN chunk.
    std::optional<std::span<const uint8_t>> binary;
};

// Finds the parts of a glTF file. The result refers to the bytes of `file`, so `file` must outlive the
// result. Returns nullopt after an error was reported.
[[nodiscard]] std::optional<Container> open_container(std::span<const uint8_t> file, Report& report);

// Estimates the number of values in the JSON: counts commas and opening brackets ([ and {) outside strings.
// Returns nullopt after a limit was exceeded and reported.
[[nodiscard]] std::optional<uint64_t> count_values(std::string_view json, const SceneLimits& limits,
                                                   Report& report);

struct TextPosition {
    uint32_t line = 1;
    uint32_t column = 1;
};
// Returns the line and column of a byte offset in the text. Both start at 1; columns count bytes.
[[nodiscard]] TextPosition position_of(std::string_view text, size_t byte);

}  // namespace weft::scene::gltf
