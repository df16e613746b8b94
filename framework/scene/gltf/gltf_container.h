// Purpose: finds the JSON text and the binary chunk of a .gltf or .glb without copying them, and refuses JSON
// whose size, depth or number of values would cost a parser more than the file is worth. Source: "glTF 2.0
// Specification", chapter 4, "GLB File Format Specification".
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

// Views into `file`. nullopt after an error was reported.
[[nodiscard]] std::optional<Container> open_container(std::span<const uint8_t> file, Report& report);

// How many values the JSON holds; nullopt after an error was reported. Brackets and commas inside strings do
// not count.
[[nodiscard]] std::optional<uint64_t> count_values(std::string_view json, const SceneLimits& limits,
                                                   Report& report);

struct TextPosition {
    uint32_t line = 1;
    uint32_t column = 1;
};
[[nodiscard]] TextPosition position_of(std::string_view text, size_t byte);

}  // namespace weft::scene::gltf
