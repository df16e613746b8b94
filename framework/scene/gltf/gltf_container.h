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
    std::optional<std::span<const uint8_t>> binary;  // present in a .glb with a BIN chunk
};

// The result refers to the bytes of `file`. nullopt after an error was reported.
[[nodiscard]] std::optional<Container> open_container(std::span<const uint8_t> file, Report& report);

// Number of values in the JSON; nullopt after an error was reported. Brackets and commas inside strings are
// not counted.
[[nodiscard]] std::optional<uint64_t> count_values(std::string_view json, const SceneLimits& limits,
                                                   Report& report);

struct TextPosition {
    uint32_t line = 1;
    uint32_t column = 1;
};
[[nodiscard]] TextPosition position_of(std::string_view text, size_t byte);

}  // namespace weft::scene::gltf
