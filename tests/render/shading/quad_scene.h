// Purpose: a scene with a square that fills the picture, for comparisons with closed forms. The position of
// every pixel on the square is known, so the expected light can be computed.
#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "weft/declaration.h"
#include "weft/scene/scene.h"

namespace weft::test {

inline constexpr Extent3D kQuadSize{16, 16, 1};

// Returns a scene with a diffuse white square from (-1, -1, 0) to (1, 1, 0) that faces +z, and a camera in
// front of it. uv (0, 0) is the upper left corner.
inline scene::Scene quad_scene() {
    scene::Scene scene;
    scene::Mesh quad;
    quad.name = "quad";
    quad.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    quad.normals.assign(4, {0, 0, 1});
    quad.tangents.assign(4, {1, 0, 0, 1});
    quad.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    quad.indices = {0, 1, 2, 0, 2, 3};
    quad.bounds.min = {-1, -1, 0};
    quad.bounds.max = {1, 1, 0};
    scene.meshes = {quad};
    scene::Material material;
    material.metallic = 0;
    material.specular = 0;
    scene.materials = {material};
    scene.instances = {{"quad", 0, 0, glm::mat4(1)}};
    scene::Camera camera;
    camera.name = "front";
    // The camera is 1000 m away, so that all view rays are nearly parallel.
    constexpr float kDistanceM = 1000;
    camera.transform = glm::translate(glm::mat4(1), glm::vec3(0, 0, kDistanceM));
    camera.fov_y_rad = 2 * std::atan(1 / kDistanceM);
    scene.cameras = {camera};
    return scene;
}

// Returns a horizontal square with sides of 8 m around the origin, facing +y.
inline scene::Mesh ground_mesh() {
    scene::Mesh mesh;
    mesh.positions = {{-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}, {4, 0, -4}};
    mesh.normals.assign(4, {0, 1, 0});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

// Returns a directional light of `intensity` lx that shines on surfaces that face the camera.
inline scene::Light frontal_light(float intensity) {
    scene::Light light;
    light.type = scene::LightType::directional;
    light.direction = {0, 0, -1};
    light.intensity = intensity;
    return light;
}

// Returns the uv of the centre of pixel i on the square. Pixels are numbered row by row.
inline glm::vec2 uv_of_pixel(size_t i) {
    return {(static_cast<float>(i % kQuadSize.width) + 0.5f) / static_cast<float>(kQuadSize.width),
            (static_cast<float>(i / kQuadSize.width) + 0.5f) / static_cast<float>(kQuadSize.height)};
}

}  // namespace weft::test
