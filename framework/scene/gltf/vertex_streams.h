// Purpose: reads the vertex attributes of a glTF primitive into the streams of a Mesh, for used vertices
// only. Errors: S104 an accessor past its bytes. Warnings: S152 a value that was not finite, or zero, and was
// replaced; S154 colours that were clamped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/accessor_reader.h"
#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"

namespace weft::scene::gltf {

// With larger coordinates, differences of positions and areas overflow float.
inline constexpr float kMaxCoordinateM = 1e12f;

// nullopt if `accessor` is kNone, and after an error at `pointer`.
[[nodiscard]] std::optional<AccessorReader> open_accessor(const Document& document, uint32_t accessor,
                                                          const std::string& pointer, Report& report);

// The context that attribute readers share.
struct StreamSource {
    const Document& document;
    Report& report;
    std::string mesh;                   // for messages: `mesh "Body"`
    std::string attributes;             // JSON pointer of the attributes
    const std::vector<uint32_t>& used;  // indices of the used vertices; each reader returns one element for
                                        // each of them
};

// Empty when absent.
[[nodiscard]] std::vector<glm::vec2> read_uvs(const StreamSource& from, uint32_t accessor,
                                              const std::string& name);
// Values in [0, 1]; empty when absent or when all are white.
[[nodiscard]] std::vector<glm::vec4> read_colors(const StreamSource& from, uint32_t accessor);
// Reads the normals of `mesh`, which already has positions and indices. Invalid normals are computed from its
// triangles.
void read_normals(const StreamSource& from, uint32_t accessor, Mesh& mesh);
// False when the file's tangents cannot be used and must be generated. `mesh` must have normals.
[[nodiscard]] bool read_tangents(const StreamSource& from, uint32_t accessor, Mesh& mesh);

}  // namespace weft::scene::gltf
