#include "scene/model/mesh_attributes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace weft::scene {
namespace {

// Returns `v` with length 1, or `fallback` if `v` has no direction. The vector is first divided by its
// largest component, so that the squares of tiny and huge components stay within the range of float.
glm::vec3 normalized_or(const glm::vec3& v, const glm::vec3& fallback) {
    const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return fallback;
    const glm::vec3 scaled = v / largest;
    if (!std::isfinite(scaled.x + scaled.y + scaled.z)) return fallback;
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

// Returns a unit vector perpendicular to the unit vector `n`: the cross product of `n` and a coordinate axis,
// scaled to length 1. The axis is the one along which `n` has its smallest component, regardless of the sign.
glm::vec3 any_orthogonal(const glm::vec3& n) {
    const glm::vec3 a = glm::abs(n);
    const glm::vec3 axis = a.x <= a.y && a.x <= a.z ? glm::vec3(1, 0, 0)
                           : a.y <= a.z             ? glm::vec3(0, 1, 0)
                                                    : glm::vec3(0, 0, 1);
    return normalized_or(glm::cross(n, axis), glm::vec3(1, 0, 0));
}

// The directions of the uv coordinates on one triangle. All three corners of the triangle use them.
struct UvFrame {
    glm::vec3 tangent{0};   // Direction of increasing u on the triangle; zero when the uvs are degenerate.
    bool mirrored = false;  // True if v increases along cross(normal, tangent), see split_mirrored().
};

UvFrame uv_frame(const Mesh& mesh, const std::vector<glm::vec2>& uvs, const uint32_t* corner) {
    const glm::dvec3 p0(mesh.positions[corner[0]]);
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[corner[1]]) - p0;
    const glm::dvec3 e2 = glm::dvec3(mesh.positions[corner[2]]) - p0;
    const glm::dvec2 uv0(uvs[corner[0]]);
    const glm::dvec2 d1 = glm::dvec2(uvs[corner[1]]) - uv0;
    const glm::dvec2 d2 = glm::dvec2(uvs[corner[2]]) - uv0;
    const double area = d1.x * d2.y - d1.y * d2.x;
    if (area == 0 || !std::isfinite(area)) return {};
    const glm::dvec3 along_u = (e1 * d2.y - e2 * d1.y) * (area > 0 ? 1.0 : -1.0);
    const double length = glm::length(along_u);
    if (!(length > 0) || !std::isfinite(length)) return {};
    return {glm::vec3(along_u / length), area > 0};
}

float corner_angle(const Mesh& mesh, const uint32_t* corner, int k) {
    const glm::vec3 p = mesh.positions[corner[k]];
    const glm::vec3 a = normalized_or(mesh.positions[corner[(k + 1) % 3]] - p, glm::vec3(0));
    const glm::vec3 b = normalized_or(mesh.positions[corner[(k + 2) % 3]] - p, glm::vec3(0));
    return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
}

// Appends a copy of `stream[from]` to the stream. Does nothing if the stream is empty.
template <class T>
void append_copy(std::vector<T>& stream, size_t from) {
    if (stream.empty()) return;
    // `copy` is not a reference to an element, because push_back may reallocate the vector.
    const T copy = stream[from];
    stream.push_back(copy);
}

// Appends a copy of the vertex to all streams of the mesh except the tangents, and returns the index of the
// copy. generate_tangents() fills the tangents only after the vertices are split.
uint32_t duplicate_vertex(Mesh& mesh, uint32_t vertex) {
    append_copy(mesh.positions, vertex);
    append_copy(mesh.normals, vertex);
    append_copy(mesh.uvs, vertex);
    append_copy(mesh.colors, vertex);
    append_copy(mesh.second_uvs, vertex);
    return static_cast<uint32_t>(mesh.positions.size() - 1);
}

// Splits vertices so that each vertex belongs only to triangles of one uv orientation. Returns one value per
// vertex: true if the uvs of its triangles are mirrored. In glTF's sense, uvs are mirrored if v increases
// along cross(normal, tangent).
std::vector<uint8_t> split_mirrored(Mesh& mesh, const std::vector<UvFrame>& frames) {
    enum : uint8_t { unseen, upright, mirrored };
    std::vector<uint8_t> side(mesh.positions.size(), unseen);
    std::vector<uint32_t> twin(mesh.positions.size(), kNone);
    for (size_t t = 0; t < frames.size(); ++t) {
        if (frames[t].tangent == glm::vec3(0)) continue;
        const uint8_t wanted = frames[t].mirrored ? mirrored : upright;
        for (size_t k = 0; k < 3; ++k) {
            uint32_t& vertex = mesh.indices[3 * t + k];
            if (side[vertex] == unseen) side[vertex] = wanted;
            if (side[vertex] == wanted) continue;
            if (twin[vertex] == kNone) {
                const uint32_t added = duplicate_vertex(mesh, vertex);
                twin[vertex] = added;
                twin.push_back(kNone);
                side.push_back(wanted);
            }
            vertex = twin[vertex];
        }
    }
    for (uint8_t& s : side) s = s == mirrored;
    return side;
}

// Returns the element of `stream` at each index. The result is empty when the stream is empty.
template <class T>
std::vector<T> picked(const std::vector<T>& stream, const std::vector<uint32_t>& indices) {
    std::vector<T> out;
    if (stream.empty()) return out;
    out.reserve(indices.size());
    for (const uint32_t index : indices) out.push_back(stream[index]);
    return out;
}

}  // namespace

void generate_normals(Mesh& mesh) {
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t* corner = &mesh.indices[i];
        const glm::vec3 p0 = mesh.positions[corner[0]];
        // The length of the cross product is twice the triangle's area, so the sum of these vectors is
        // already weighted by area.
        const glm::vec3 area = glm::cross(mesh.positions[corner[1]] - p0, mesh.positions[corner[2]] - p0);
        for (int k = 0; k < 3; ++k) mesh.normals[corner[k]] += area;
    }
    for (glm::vec3& normal : mesh.normals) normal = normalized_or(normal, glm::vec3(0, 1, 0));
}

void make_flat(Mesh& mesh) {
    Mesh flat;
    flat.name = mesh.name;
    flat.positions = picked(mesh.positions, mesh.indices);
    flat.uvs = picked(mesh.uvs, mesh.indices);
    flat.colors = picked(mesh.colors, mesh.indices);
    flat.second_uvs = picked(mesh.second_uvs, mesh.indices);
    flat.indices.resize(mesh.indices.size());
    std::iota(flat.indices.begin(), flat.indices.end(), 0u);
    generate_normals(flat);
    mesh = std::move(flat);
}

glm::vec3 orthonormal_tangent(const glm::vec3& normal, const glm::vec3& tangent) {
    const glm::vec3 unit = normalized_or(tangent, glm::vec3(0));
    const glm::vec3 projected = unit - normal * glm::dot(normal, unit);
    // A projection shorter than 1e-4 is mostly rounding error and has no useful direction, so any
    // perpendicular vector is returned instead.
    if (!(glm::dot(projected, projected) > 1e-8f)) return any_orthogonal(normal);
    return normalized_or(projected, glm::vec3(1, 0, 0));
}

void generate_tangents(Mesh& mesh, uint32_t uv_set) {
    assert(mesh.normals.size() == mesh.positions.size());
    const size_t triangles = mesh.indices.size() / 3;
    const std::vector<glm::vec2>& uvs = uv_set == 1 && !mesh.second_uvs.empty() ? mesh.second_uvs : mesh.uvs;
    if (uvs.empty()) {
        mesh.tangents.clear();
        mesh.tangents.reserve(mesh.normals.size());
        for (const glm::vec3& normal : mesh.normals) mesh.tangents.emplace_back(any_orthogonal(normal), 1.0f);
        return;
    }
    std::vector<UvFrame> frames(triangles);
    for (size_t t = 0; t < triangles; ++t) frames[t] = uv_frame(mesh, uvs, &mesh.indices[3 * t]);
    const std::vector<uint8_t> mirrored = split_mirrored(mesh, frames);
    std::vector<glm::vec3> sum(mesh.positions.size(), glm::vec3(0));
    for (size_t t = 0; t < triangles; ++t) {
        if (frames[t].tangent == glm::vec3(0)) continue;
        const uint32_t* corner = &mesh.indices[3 * t];
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 flat = orthonormal_tangent(mesh.normals[corner[k]], frames[t].tangent);
            sum[corner[k]] += flat * corner_angle(mesh, corner, k);
        }
    }
    mesh.tangents.resize(mesh.positions.size());
    for (size_t v = 0; v < sum.size(); ++v) {
        mesh.tangents[v] = {orthonormal_tangent(mesh.normals[v], sum[v]), mirrored[v] ? -1.0f : 1.0f};
    }
}

void compute_bounds(Mesh& mesh) {
    if (mesh.positions.empty()) {
        mesh.bounds.min = mesh.bounds.max = glm::vec3(0);
        return;
    }
    mesh.bounds.min = mesh.bounds.max = mesh.positions.front();
    for (const glm::vec3& position : mesh.positions) {
        mesh.bounds.min = glm::min(mesh.bounds.min, position);
        mesh.bounds.max = glm::max(mesh.bounds.max, position);
    }
}

}  // namespace weft::scene
