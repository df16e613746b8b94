#include "scene/probes/triangle_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::scene {
namespace {

struct SurfaceKind {
    bool blocks = true;
    bool has_inside = true;
};

// The mip of an alpha mask in which holes are searched has at most this many texels along a side.
constexpr uint32_t kMaskSide = 64;

// Returns the smallest alpha of the texture, 0 to 1. The function reads a small mip, because the mips of a
// mask keep the share of visible texels.
float least_alpha(const Scene& scene, uint32_t index) {
    if (index == kNone) return 1;
    const Texture& texture = scene.textures[index];
    uint32_t mip = 0;
    while (mip + 1 < texture.mips.size() &&
           std::max(texture.width_px >> mip, texture.height_px >> mip) > kMaskSide)
        ++mip;
    uint8_t least = 255;
    const std::vector<uint8_t>& rgba = texture.mips[mip];
    for (size_t i = 3; i < rgba.size(); i += 4) least = std::min(least, rgba[i]);
    return static_cast<float>(least) / 255;
}

std::vector<SurfaceKind> kinds_of_materials(const Scene& scene) {
    std::vector<SurfaceKind> kinds;
    for (const Material& material : scene.materials) {
        SurfaceKind kind;
        if (material.alpha_mode == AlphaMode::blend) {
            kind.blocks = false;
        } else if (material.alpha_mode == AlphaMode::mask) {
            const float alpha =
                material.base_color.a * least_alpha(scene, material.base_color_texture.texture);
            kind.blocks = alpha >= material.alpha_cutoff;
        }
        kind.has_inside = kind.blocks && !material.double_sided;
        kinds.push_back(kind);
    }
    return kinds;
}

bool less(const glm::vec3& a, const glm::vec3& b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

bool is_usable(const glm::vec3& p) {
    return std::abs(p.x) <= kFarthest_m && std::abs(p.y) <= kFarthest_m && std::abs(p.z) <= kFarthest_m;
}

// Returns a point of the instance in world space. The sum turns −0 into 0.
glm::vec3 world_point(const glm::mat4& transform, const glm::vec3& position) {
    return glm::vec3(transform * glm::vec4(position, 1)) + glm::vec3(0);
}

bool has_translucent_vertices(const Mesh& mesh) {
    return std::ranges::any_of(mesh.colors, [](const glm::vec4& color) { return color.a < 1; });
}

void append_instance(const Scene& scene, const Instance& instance, SurfaceKind kind,
                     std::vector<SolidTriangle>& out) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (scene.materials[instance.material].alpha_mode == AlphaMode::mask && has_translucent_vertices(mesh))
        kind = {false, false};
    const float determinant = glm::determinant(glm::mat3(instance.transform));
    if (determinant == 0) kind.has_inside = false;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        SolidTriangle triangle;
        for (size_t k = 0; k < 3; ++k)
            triangle.corners[k] = world_point(instance.transform, mesh.positions[mesh.indices[i + k]]);
        std::array<glm::vec3, 3>& c = triangle.corners;
        if (!is_usable(c[0]) || !is_usable(c[1]) || !is_usable(c[2])) continue;
        if (determinant < 0) std::swap(c[1], c[2]);
        put_smallest_corner_first(triangle);
        triangle.blocks = kind.blocks;
        triangle.has_inside = kind.has_inside;
        out.push_back(triangle);
    }
}

}  // namespace

void put_smallest_corner_first(SolidTriangle& triangle) {
    std::ranges::rotate(triangle.corners, std::ranges::min_element(triangle.corners, less));
}

uint64_t count_triangles(const Scene& scene) {
    uint64_t count = 0;
    for (const Instance& instance : scene.instances)
        if (instance.node == kNone) count += scene.meshes[instance.mesh].indices.size() / 3;
    return count;
}

std::vector<SolidTriangle> collect_triangles(const Scene& scene, const LoadOptions& options) {
    const std::vector<SurfaceKind> kinds = kinds_of_materials(scene);
    std::vector<SolidTriangle> triangles;
    triangles.reserve(count_triangles(scene));
    StageProgress progress(options, "instances", scene.instances.size());
    for (const Instance& instance : scene.instances) {
        if (instance.node == kNone) append_instance(scene, instance, kinds[instance.material], triangles);
        progress.step();
    }
    return triangles;
}

}  // namespace weft::scene
