// Purpose: reads the vertex attributes of a glTF primitive into the streams of a Mesh, only for the vertices
// that triangles use. Errors: S104 an accessor past the end of its bytes. Warnings: S152 a value that was
// replaced because it was zero, too large or not finite; S154 colours that were clamped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/accessor_reader.h"
#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"

namespace weft::scene::gltf {

// Largest usable coordinate of a position in metres; also the limit for texture coordinates. Within this
// limit, the areas of triangles fit into a float.
inline constexpr float kMaxCoordinateM = 1e12f;

// Opens an accessor for reading. Returns nullopt if `accessor` is kNone, or after an error for the JSON value
// at `pointer` was reported.
[[nodiscard]] std::optional<AccessorReader> open_accessor(const Document& document, uint32_t accessor,
                                                          const std::string& pointer, Report& report);

// Common parameters of the functions that read a vertex attribute.
struct StreamSource {
    const Document& document;
    Report& report;
    std::string mesh;        // Name of the mesh for messages, for example `mesh "Body"`.
    std::string attributes;  // JSON pointer of the primitive's `attributes`.
    // Indices of the used vertices in the file. The functions below read one element for each of these
    // vertices.
    const std::vector<uint32_t>& used;
};

// Returns texture coordinates, or an empty vector when the attribute is absent or cannot be read. `name` is
// the name of the attribute, for example TEXCOORD_0.
[[nodiscard]] std::vector<glm::vec2> read_uvs(const StreamSource& from, uint32_t accessor,
                                              const std::string& name);
// Returns colours with values in [0, 1]. The vector is empty when the attribute is absent or when all colours
// are white.
[[nodiscard]] std::vector<glm::vec4> read_colors(const StreamSource& from, uint32_t accessor);
// Reads the normals of `mesh`, which already has positions and indices. Normals that are not valid are
// replaced by normals that are computed from the triangles.
void read_normals(const StreamSource& from, uint32_t accessor, Mesh& mesh);
// Reads the tangents of `mesh`, which must already have normals. Returns false when the tangents of the file
// cannot be used and must be generated.
[[nodiscard]] bool read_tangents(const StreamSource& from, uint32_t accessor, Mesh& mesh);

}  // namespace weft::scene::gltf
