#include "scene/builtin/builtin_cornell.h"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "scene/builtin/scene_parts.h"
#include "scene/procedural/procedural_mesh.h"

namespace weft::scene {
namespace {

// Length of one unit of the published data in metres. One unit is taken as one centimetre.
constexpr float kUnit_m = 0.01f;

Mesh wall(const char* name, glm::vec3 origin, glm::vec3 right, glm::vec3 up) {
    MeshBuilder builder;
    builder.add_rectangle(origin * kUnit_m, right * kUnit_m, up * kUnit_m);
    return builder.finish(name);
}

// Makes a block that stands on the floor. The four corners (x, z) are in counter-clockwise order, seen from
// above. Corners and height are in units of the published data.
Mesh block(const char* name, const std::array<glm::vec2, 4>& corners, float height) {
    MeshBuilder builder;
    const auto at = [](glm::vec2 corner, float y) { return glm::vec3(corner.x, y, corner.y) * kUnit_m; };
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 from = at(corners[i], 0), to = at(corners[(i + 1) % corners.size()], 0);
        builder.add_rectangle(from, to - from, glm::vec3(0, height, 0) * kUnit_m);
    }
    const glm::vec3 top = at(corners[0], height);
    builder.add_rectangle(top, at(corners[1], height) - top, at(corners[3], height) - top);
    return builder.finish(name);
}

void add_box_walls(Scene& scene) {
    const uint32_t white = add_matt(scene, "white", {0.725f, 0.71f, 0.68f});
    const uint32_t red = add_matt(scene, "red", {0.63f, 0.065f, 0.05f});
    const uint32_t green = add_matt(scene, "green", {0.14f, 0.45f, 0.091f});
    constexpr float kWidth = 552.8f, kHeight = 548.8f, kDepth = 559.2f;
    place(scene, wall("floor", {kWidth, 0, 0}, {-kWidth, 0, 0}, {0, 0, kDepth}), white);
    place(scene, wall("ceiling", {0, kHeight, 0}, {kWidth, 0, 0}, {0, 0, kDepth}), white);
    place(scene, wall("back", {kWidth, 0, kDepth}, {-kWidth, 0, 0}, {0, kHeight, 0}), white);
    place(scene, wall("right", {0, 0, kDepth}, {0, 0, -kDepth}, {0, kHeight, 0}), green);
    place(scene, wall("left", {kWidth, 0, 0}, {0, 0, kDepth}, {0, kHeight, 0}), red);
    place(scene, block("short block", {{{130, 65}, {82, 225}, {240, 272}, {290, 114}}}, 165), white);
    place(scene, block("tall block", {{{423, 247}, {265, 296}, {314, 456}, {472, 406}}}, 330), white);
}

void add_ceiling_lamp(Scene& scene) {
    const uint32_t lamp = add_matt(scene, "lamp", glm::vec3(0.78f));
    scene.materials[lamp].emissive = glm::vec3(900, 680, 420);
    place(scene, wall("lamp", {213, 548.3f, 227}, {130, 0, 0}, {0, 0, 105}), lamp);
    Light light;
    light.name = "lamp";
    light.type = LightType::spot;
    light.color = {1.0f, 0.82f, 0.6f};
    light.intensity = 900;
    light.position = glm::vec3(278, 540, 279.5f) * kUnit_m;
    light.direction = {0, -1, 0};
    // A flat lamp emits less light in directions close to the ceiling. The wide falloff between the two cones
    // imitates this.
    light.inner_cone_rad = glm::radians(25.0f);
    light.outer_cone_rad = glm::radians(89.0f);
    scene.lights.push_back(light);
}

Camera front_camera(glm::vec3 eye, glm::vec3 at, float fov_y_rad) {
    Camera camera;
    camera.name = "front";
    camera.transform = glm::inverse(glm::lookAt(eye, at, glm::vec3(0, 1, 0)));
    camera.fov_y_rad = fov_y_rad;
    return camera;
}

// Adds a chrome sphere in the middle of the floor and six matt objects around it. The polished floor and the
// chrome sphere reflect the objects.
void add_mirror_things(Scene& scene) {
    struct Thing {
        const char* name;
        glm::vec3 color;
        float turn_rad;  // Angle of the object around the middle of the floor, from +z towards +x.
    };
    const std::array<Thing, 6> things{{{"coral", {0.80f, 0.22f, 0.15f}, 0.75f},
                                       {"saffron", {0.85f, 0.55f, 0.08f}, 1.75f},
                                       {"leaf", {0.16f, 0.45f, 0.14f}, 2.55f},
                                       {"chalk", {0.75f, 0.74f, 0.70f}, -2.55f},
                                       {"sea", {0.07f, 0.28f, 0.55f}, -1.75f},
                                       {"plum", {0.35f, 0.10f, 0.38f}, -0.75f}}};
    for (size_t i = 0; i < things.size(); ++i) {
        const uint32_t material = add_matt(scene, things[i].name, things[i].color, 0.5f);
        const glm::vec3 at = 2.4f * glm::vec3(std::sin(things[i].turn_rad), 0, std::cos(things[i].turn_rad));
        MeshBuilder builder;
        if (i % 2 == 0)
            builder.add_sphere(at + glm::vec3(0, 0.55f, 0), 0.55f, 32, 16);
        else
            builder.add_bevelled_box(at - glm::vec3(0.42f, 0, 0.42f), at + glm::vec3(0.42f, 1.2f, 0.42f),
                                     0.04f);
        place(scene, builder.finish(things[i].name), material);
    }
    const uint32_t chrome = add_matt(scene, "chrome", glm::vec3(0.75f, 0.755f, 0.75f), 0.05f);
    scene.materials[chrome].metallic = 1;
    MeshBuilder builder;
    builder.add_sphere({0, 0.9f, 0}, 0.9f, 48, 24);
    place(scene, builder.finish("chrome"), chrome);
}

}  // namespace

Scene make_cornell() {
    Scene scene;
    scene.name = "cornell";
    add_box_walls(scene);
    add_ceiling_lamp(scene);
    // The vertical field of view is that of a lens with a focal length of 35 mm and a film 25 mm high.
    scene.cameras.push_back(front_camera(glm::vec3(278, 273, -800) * kUnit_m,
                                         glm::vec3(278, 273, 0) * kUnit_m, 2 * std::atan(0.0125f / 0.035f)));
    // The sky has the same luminance in all directions. It replaces the indirect light between the walls.
    finish_scene(scene, glm::vec3(2.6f, 2.2f, 1.8f), glm::vec3(2.6f, 2.2f, 1.8f), -4.2f);
    return scene;
}

Scene make_mirror() {
    Scene scene;
    scene.name = "mirror";
    const uint32_t floor = add_matt(scene, "polished floor", glm::vec3(0.03f), 0.04f);
    MeshBuilder builder;
    builder.add_rectangle({-6, 0, 6}, {12, 0, 0}, {0, 0, -12});
    place(scene, builder.finish("floor"), floor);
    add_mirror_things(scene);
    Light sun;
    sun.name = "sun";
    sun.type = LightType::directional;
    sun.color = {1.0f, 0.95f, 0.88f};
    sun.intensity = 900;
    sun.direction = glm::normalize(glm::vec3(-0.5f, -0.8f, -0.45f));
    scene.lights.push_back(sun);
    scene.cameras.push_back(front_camera({0, 2.3f, 7.2f}, {0, 0.55f, 0}, glm::radians(36.0f)));
    finish_scene(scene, glm::vec3(70, 105, 170), glm::vec3(210, 225, 240), -8.6f);
    return scene;
}

}  // namespace weft::scene
