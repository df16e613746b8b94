#include "tests/scene/probes/probe_scenes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/builtin/scene_parts.h"
#include "scene/procedural/procedural_mesh.h"

namespace weft::scene::test {

BoxScene::BoxScene() {
    (void)add_matt(scene, "wall", glm::vec3(0.8f));
}

void BoxScene::add(glm::vec3 low, glm::vec3 high) {
    MeshBuilder builder;
    builder.add_box(low, high);
    place(scene, builder.finish("box " + std::to_string(boxes.size())), 0);
    boxes.push_back({low, high});
}

void BoxScene::add_room(glm::vec3 low, glm::vec3 high, float wall_m) {
    const glm::vec3 outer_low = low - wall_m, outer_high = high + wall_m;
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 end = outer_high, begin = outer_low;
        end[axis] = low[axis];
        add(outer_low, end);
        begin[axis] = high[axis];
        add(begin, outer_high);
    }
}

bool BoxScene::is_inside(const glm::vec3& point) const {
    return is_near(point, 0);
}

bool BoxScene::is_near(const glm::vec3& point, float margin_m) const {
    return std::ranges::any_of(boxes, [&](const Bounds& box) {
        return glm::all(glm::greaterThan(point, box.min - margin_m)) &&
               glm::all(glm::lessThan(point, box.max + margin_m));
    });
}

BoxScene open_court() {
    BoxScene court;
    court.add({-6, -0.4f, -5}, {6, 0, 5});
    court.add({-6, 0, -5}, {-5.6f, 4, 5});
    court.add({5.6f, 0, -5}, {6, 4, 5});
    court.add({-5.6f, 0, -5}, {5.6f, 4, -4.6f});
    court.add({-1, 0, -1}, {1, 1.2f, 0.5f});
    return court;
}

BoxScene corridor() {
    BoxScene scene;
    constexpr float kWall = 0.3f, kHeight = 2.5f;
    // Three passages of 2 m meet at right angles. Floors and ceilings:
    for (const float y : {-kWall, kHeight}) {
        scene.add({-kWall, y, -kWall}, {2 + kWall, y + kWall, 8 + kWall});
        scene.add({2 + kWall, y, 6 - kWall}, {8 + kWall, y + kWall, 8 + kWall});
        scene.add({6 - kWall, y, 8 + kWall}, {8 + kWall, y + kWall, 14 + kWall});
    }
    const auto add_wall = [&](float x0, float z0, float x1, float z1) {
        scene.add({x0, 0, z0}, {x1, kHeight, z1});
    };
    add_wall(-kWall, -kWall, 0, 8 + kWall);
    add_wall(0, -kWall, 2, 0);
    add_wall(2, -kWall, 2 + kWall, 6);
    add_wall(2 + kWall, 6 - kWall, 8 + kWall, 6);
    add_wall(8, 6, 8 + kWall, 14 + kWall);
    add_wall(6, 14, 8, 14 + kWall);
    add_wall(6 - kWall, 8 + kWall, 6, 14 + kWall);
    add_wall(0, 8, 6, 8 + kWall);
    return scene;
}

BoxScene object_in_the_open() {
    BoxScene scene;
    scene.add({-0.5f, -0.5f, -0.5f}, {0.7f, 0.6f, 0.5f});
    return scene;
}

BoxScene two_floors() {
    BoxScene scene;
    scene.add_room({0, 0, 0}, {6, 5.6f, 5}, 0.25f);
    // The floor between the storeys has a hole for the stairs.
    scene.add({0, 2.6f, 0}, {4.5f, 2.9f, 5});
    scene.add({4.5f, 2.6f, 0}, {6, 2.9f, 3});
    for (int step = 0; step < 11; ++step) {
        const float z = 0.3f + 0.4f * static_cast<float>(step);
        scene.add({4.9f, 0, z}, {6, 0.24f * static_cast<float>(step + 1), z + 0.4f});
    }
    return scene;
}

BoxScene room_in_a_room() {
    BoxScene scene;
    scene.add_room({-4, 0, -4}, {4, 4, 4}, 0.3f);
    scene.add_room({-1.4f, 0.2f, -1.4f}, {1.4f, 2.6f, 1.4f}, 0.2f);
    return scene;
}

BoxScene house_on_wide_ground() {
    BoxScene scene;
    scene.add({-50, -1, -50}, {50, 0, 50});
    scene.add_room({8, 0.2f, 6}, {13, 3, 10}, 0.2f);
    return scene;
}

BoxScene apartments() {
    BoxScene scene;
    const glm::vec3 size(5 * 2.9f, 2 * 2.9f, 5 * 2.9f);
    for (int axis = 0; axis < 3; ++axis)
        for (float at = 0; at <= size[axis] + 0.1f; at += 2.9f) {
            glm::vec3 low(-0.3f), high = size;
            low[axis] = at - 0.3f;
            high[axis] = at;
            scene.add(low, high);
        }
    return scene;
}

BoxScene random_boxes(uint32_t seed) {
    std::mt19937 random(seed);
    const auto between = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() % 10'007) / 10'007.0f;
    };
    BoxScene scene;
    const uint32_t count = 1 + random() % 12;
    const float extent = between(2, 14);
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 middle(between(-extent, extent), between(-3, 3), between(-extent, extent));
        glm::vec3 half(between(0.05f, 2), between(0.05f, 2), between(0.05f, 2));
        half[static_cast<int>(random() % 3)] *= between(0.5f, 5);
        scene.add(middle - half, middle + half);
    }
    return scene;
}

float terrain_height(float x, float z) {
    return 12 * std::sin(x * 0.013f) * std::cos(z * 0.017f) + 3 * std::sin(x * 0.05f + z * 0.04f);
}

Scene terrain(uint32_t cells) {
    Scene scene;
    const uint32_t ground = add_matt(scene, "ground", glm::vec3(0.4f));
    MeshBuilder builder;
    const float step = 1000.0f / static_cast<float>(cells);
    builder.add_grid(cells + 1, cells + 1, [&](uint32_t col, uint32_t row) {
        const float x = static_cast<float>(col) * step - 500, z = 500 - static_cast<float>(row) * step;
        return GridPoint{{x, terrain_height(x, z), z}, {x, z}};
    });
    place(scene, builder.finish("terrain"), ground);
    return scene;
}

Scene shuffled(const Scene& scene, uint32_t seed) {
    std::mt19937 random(seed);
    Scene out = scene;
    std::vector<uint32_t> order(scene.meshes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::shuffle(order, random);
    for (uint32_t i = 0; i < order.size(); ++i) out.meshes[order[i]] = scene.meshes[i];
    for (Instance& instance : out.instances) instance.mesh = order[instance.mesh];
    std::ranges::shuffle(out.instances, random);
    for (Mesh& mesh : out.meshes) {
        std::vector<std::array<uint32_t, 3>> triangles;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            std::array<uint32_t, 3> t{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
            std::ranges::rotate(t, t.begin() + random() % 3);
            triangles.push_back(t);
        }
        std::ranges::shuffle(triangles, random);
        mesh.indices.clear();
        for (const std::array<uint32_t, 3>& t : triangles)
            mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
    }
    return out;
}

}  // namespace weft::scene::test
