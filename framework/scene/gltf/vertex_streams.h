// Purpose: the vertex attributes of a glTF primitive as streams of a Mesh, for the vertices that its
// triangles use. Errors: S104 an accessor past its bytes. Warnings: S152 what is not finite or zero and was
// replaced, S154 colours that were clamped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/accessor_reader.h"
#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"

namespace weft::scene::gltf {

// Farther out, differences of positions and areas overflow float.
inline constexpr float kMaxCoordinateM = 1e12f;

// nullopt for kNone, and after an error at `pointer`.
[[nodiscard]] std::optional<AccessorReader> open_accessor(const Document& document, uint32_t accessor,
                                                          const std::string& pointer, Report& report);

// What a primitive's attributes are read with.
struct StreamSource {
    const Document& document;
    Report& report;
    std::string mesh;                   // for messages: `mesh "Body"`
    std::string attributes;             // their JSON pointer
    const std::vector<uint32_t>& used;  // the vertices; each reader returns an element for each of them
};

// Empty when absent.
[[nodiscard]] std::vector<glm::vec2> read_uvs(const StreamSource& from, uint32_t accessor,
                                              const std::string& name);
// In [0, 1]; empty when absent or white throughout.
[[nodiscard]] std::vector<glm::vec4> read_colors(const StreamSource& from, uint32_t accessor);
// Of `mesh`, which has positions and indices; those that are no directions come from its triangles.
void read_normals(const StreamSource& from, uint32_t accessor, Mesh& mesh);
// False when the file's tangents cannot be used and must be generated. Needs normals.
[[nodiscard]] bool read_tangents(const StreamSource& from, uint32_t accessor, Mesh& mesh);

}  // namespace weft::scene::gltf
