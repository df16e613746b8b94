#include "scene/gltf/vertex_streams.h"

#include <algorithm>
#include <cmath>

#include "scene/model/mesh_attributes.h"

namespace weft::scene::gltf {

namespace {

std::optional<AccessorReader> open(const StreamSource& from, uint32_t accessor, const std::string& name) {
    return open_accessor(from.document, accessor, from.attributes + "/" + name, from.report);
}

void warn_mended(const StreamSource& from, const std::string& name, size_t count, const char* what) {
    if (count == 0) return;
    from.report.warn(
        "S152", from.attributes + "/" + name,
        from.mesh + ": " + std::to_string(count) + " " + what + " are zero or not finite and were replaced",
        "compute the " + std::string(what) + " again before exporting");
}

}  // namespace

std::optional<AccessorReader> open_accessor(const Document& document, uint32_t accessor,
                                            const std::string& pointer, Report& report) {
    if (accessor == kNone) return std::nullopt;
    std::optional<AccessorReader> reader = AccessorReader::open(document, accessor);
    if (!reader) {
        report.error("S104", pointer,
                     "accessor " + std::to_string(accessor) +
                         " extends beyond its buffer view, or its sparse indices are not ascending and below "
                         "\"count\"",
                     "export the scene again");
    }
    return reader;
}

std::vector<glm::vec2> read_uvs(const StreamSource& from, uint32_t accessor, const std::string& name) {
    std::vector<glm::vec2> uvs;
    const std::optional<AccessorReader> reader = open(from, accessor, name);
    if (!reader) return uvs;
    size_t mended = 0;
    uvs.reserve(from.used.size());
    for (const uint32_t vertex : from.used) {
        glm::vec2 uv = reader->vector<glm::vec2>(vertex);
        if (!(std::abs(uv.x) <= kMaxCoordinateM && std::abs(uv.y) <= kMaxCoordinateM)) {
            uv = glm::vec2(0);
            ++mended;
        }
        uvs.push_back(uv);
    }
    warn_mended(from, name, mended, "texture coordinates");
    return uvs;
}

std::vector<glm::vec4> read_colors(const StreamSource& from, uint32_t accessor) {
    std::vector<glm::vec4> colors;
    const std::optional<AccessorReader> reader = open(from, accessor, "COLOR_0");
    if (!reader) return colors;
    const bool has_alpha = from.document.accessors[accessor].components == 4;
    size_t mended = 0;
    size_t clamped = 0;
    colors.reserve(from.used.size());
    for (const uint32_t vertex : from.used) {
        const glm::vec4 read =
            has_alpha ? reader->vector<glm::vec4>(vertex) : glm::vec4(reader->vector<glm::vec3>(vertex), 1);
        if (!std::isfinite(read.x + read.y + read.z + read.w)) {
            ++mended;
            colors.emplace_back(1);
            continue;
        }
        colors.push_back(glm::clamp(read, glm::vec4(0), glm::vec4(1)));
        clamped += colors.back() == read ? 0 : 1;
    }
    warn_mended(from, "COLOR_0", mended, "vertex colours");
    if (clamped > 0) {
        from.report.warn("S154", from.attributes + "/COLOR_0",
                         from.mesh + ": " + std::to_string(clamped) +
                             " vertex colours are outside the range 0 to 1 and were clamped",
                         "set \"normalized\" for integers; for more brightness, use brighter lights");
    }
    if (std::ranges::all_of(colors, [](const glm::vec4& c) { return c == glm::vec4(1); })) return {};
    return colors;
}

void read_normals(const StreamSource& from, uint32_t accessor, Mesh& mesh) {
    const std::optional<AccessorReader> reader = open(from, accessor, "NORMAL");
    generate_normals(mesh);
    if (!reader) return;
    size_t mended = 0;
    for (size_t i = 0; i < from.used.size(); ++i) {
        const glm::vec3 normal = reader->vector<glm::vec3>(from.used[i]);
        const float length = glm::length(normal);
        if (std::isfinite(length) && length > 1e-6f) {
            mesh.normals[i] = normal / length;
        } else {
            ++mended;
        }
    }
    warn_mended(from, "NORMAL", mended, "normals");
}

bool read_tangents(const StreamSource& from, uint32_t accessor, Mesh& mesh) {
    const std::optional<AccessorReader> reader = open(from, accessor, "TANGENT");
    if (!reader) return false;
    size_t mended = 0;
    mesh.tangents.reserve(from.used.size());
    for (size_t i = 0; i < from.used.size(); ++i) {
        glm::vec4 tangent = reader->vector<glm::vec4>(from.used[i]);
        const float length = glm::length(glm::vec3(tangent));
        if (!std::isfinite(length) || length < 1e-6f || !std::isfinite(tangent.w)) {
            tangent = {0, 0, 0, 1};
            ++mended;
        }
        mesh.tangents.emplace_back(orthonormal_tangent(mesh.normals[i], glm::vec3(tangent)),
                                   tangent.w < 0 ? -1.0f : 1.0f);
    }
    warn_mended(from, "TANGENT", mended, "tangents");
    return true;
}

}  // namespace weft::scene::gltf
