// Purpose: small scenes made of rectangles, for comparisons of probes with closed forms and with references.
#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/probes/open_box.h"
#include "weft/scene/scene.h"

namespace weft::test {

// Albedos that the eight bits of the baked square root represent exactly.
inline constexpr float exact_albedo(int root) {
    return static_cast<float>(root * root) / (255.0f * 255.0f);
}
inline constexpr float kAlbedo02 = exact_albedo(114), kAlbedo03 = exact_albedo(140),
                       kAlbedo05 = exact_albedo(180), kAlbedo08 = exact_albedo(228);

inline scene::Material matt(const glm::vec3& albedo, const glm::vec3& emission = glm::vec3(0)) {
    scene::Material material;
    material.base_color = glm::vec4(albedo, 1);
    material.metallic = 0;
    material.specular = 0;
    material.emissive = emission;
    return material;
}

// The mesh 0 of these scenes: a square from (-1, -1, 0) to (1, 1, 0) that faces +z.
inline scene::Mesh square_mesh() {
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.bounds = {{-1, -1, 0}, {1, 1, 0}};
    return mesh;
}

// Adds a rectangle. `right` and `up` are half its sides; it faces right × up.
inline void add_quad(scene::Scene& scene, const glm::vec3& middle, const glm::vec3& right,
                     const glm::vec3& up, uint32_t material = 0) {
    glm::mat4 transform(1);
    transform[0] = glm::vec4(right, 0);
    transform[1] = glm::vec4(up, 0);
    transform[2] = glm::vec4(glm::normalize(glm::cross(right, up)), 0);
    transform[3] = glm::vec4(middle, 1);
    scene.instances.push_back({"rectangle", 0, material, transform});
}

// Adds a wall of a box, seen from inside: the side of `axis` with the smallest (-1) or largest (1)
// coordinate.
inline void add_wall(scene::Scene& scene, const glm::vec3& least, const glm::vec3& most, int axis, int side,
                     uint32_t material = 0) {
    const glm::vec3 half = (most - least) * 0.5f;
    glm::vec3 middle = (least + most) * 0.5f, right(0), up(0);
    middle[axis] = side > 0 ? most[axis] : least[axis];
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;  // e(a) × e(b) = e(axis)
    right[side > 0 ? b : a] = half[side > 0 ? b : a];
    up[side > 0 ? a : b] = half[side > 0 ? a : b];
    add_quad(scene, middle, right, up, material);
}

inline scene::Scene closed_room(const glm::vec3& least, const glm::vec3& most,
                                const scene::Material& material) {
    scene::Scene scene;
    scene.meshes = {square_mesh()};
    scene.materials = {material};
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) add_wall(scene, least, most, axis, side);
    scene.bounds = {least, most};
    return scene;
}

inline scene::Light sun_of(const glm::dvec3& to_sun, float lux) {
    scene::Light light;
    light.type = scene::LightType::directional;
    light.direction = -glm::vec3(to_sun);
    light.intensity = lux;
    return light;
}

inline scene::Scene open_box(float albedo) {
    scene::Scene scene = closed_room(glm::vec3(kBoxLeast), glm::vec3(kBoxMost), matt(glm::vec3(albedo)));
    scene.instances.pop_back();  // The wall z = +5.
    scene.lights = {sun_of(kBoxToSun, static_cast<float>(kBoxSun))};
    return scene;
}

// Returns one probe at a place.
inline scene::Probes probe_at(const glm::vec3& place) {
    scene::Probes probes;
    probes.volume.origin = place;
    probes.volume.probes = {scene::Probe{}};
    return probes;
}

}  // namespace weft::test
