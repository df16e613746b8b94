// Purpose: the vertex attributes of a glTF primitive as streams of a Mesh, for the vertices that its
// triangles use. Errors: S104 an accessor past its bytes. Warnings: S152 what is not finite or zero and was
// replaced, S154 colours that were clamped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/accessor_reader.h"
#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

namespace weft::scene::gltf {

// Farther out, differences of positions and areas overflow float.
inline constexpr float kMaxCoordinateM = 1e12f;

// Each reader returns one element for every vertex of `used`. `pointer` is the accessor's place in the file.
class VertexStreams {
 public:
    VertexStreams(const Document& document, Report& report) : document_(document), report_(report) {}

    // nullopt for kNone, and after an error.
    [[nodiscard]] std::optional<AccessorReader> open(uint32_t accessor, const std::string& pointer) const;

    // Empty when absent.
    [[nodiscard]] std::vector<glm::vec2> uvs(uint32_t accessor, const std::vector<uint32_t>& used,
                                             const std::string& pointer) const;
    // In [0, 1]; empty when absent or white throughout.
    [[nodiscard]] std::vector<glm::vec4> colors(uint32_t accessor, const std::vector<uint32_t>& used,
                                                const std::string& pointer) const;
    // Of `mesh`, which has positions and indices; those that are no directions come from its triangles.
    void read_normals(uint32_t accessor, const std::vector<uint32_t>& used, const std::string& pointer,
                      Mesh& mesh) const;
    // False when the file's tangents cannot be used and must be generated. Needs normals.
    [[nodiscard]] bool read_tangents(uint32_t accessor, const std::vector<uint32_t>& used,
                                     const std::string& pointer, Mesh& mesh) const;

 private:
    void warn_mended(const std::string& pointer, size_t count, const char* what) const;

    const Document& document_;
    Report& report_;
};

}  // namespace weft::scene::gltf
