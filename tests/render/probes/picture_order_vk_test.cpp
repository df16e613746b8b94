// Tests that a picture with light probes does not depend on the order of meshes, instances, triangles and
// lights, or on the order of the probes in a file.
#include <nlohmann/json.hpp>

#include "tests/render/probes/picture_fixture.h"

namespace weft::test {
namespace {

// A court and a room with five lamps of several types, under a sun and a second directional light.
scene::Scene lit_rooms() {
    scene::test::BoxScene boxes = dark_room_beside_court();
    boxes.add({0.8f, 0, -1.2f}, {1.6f, 1.1f, -0.4f});
    scene::Scene& scene = boxes.scene;
    scene.materials[0].base_color = glm::vec4(0.7f, 0.5f, 0.3f, 1);
    scene::MeshBuilder builder;
    builder.add_sphere({1.9f, 0.6f, 0.7f}, 0.6f, 48, 24);
    const uint32_t metal = add_metal(scene, {0.9f, 0.8f, 0.5f}, 0.1f);
    place(scene, builder.finish("ball"), metal);
    scene.lights = {sun_from({-0.4f, -1, -0.3f}, 5000), sun_from({0.5f, -1, 0.8f}, 1500)};
    for (int i = 0; i < 5; ++i) {
        scene::Light lamp;
        lamp.type = i % 2 == 0 ? scene::LightType::point : scene::LightType::spot;
        lamp.position = {1.1f * float(i) - 2.4f, 1.5f, 0.7f * float(i % 3) - 0.6f};
        lamp.direction = glm::normalize(glm::vec3(0.2f, -1, 0.1f * float(i)));
        lamp.color = glm::vec3(1, 0.9f - 0.15f * float(i), 0.4f + 0.1f * float(i));
        lamp.intensity = 900.0f + 350.0f * float(i);
        scene.lights.push_back(lamp);
    }
    return scene;
}

// Writes the probes to the text of a file, lists them in another order, and reads them.
scene::Probes listed_in_another_order(const scene::Scene& scene, const scene::Probes& probes, uint32_t seed) {
    nlohmann::json file = nlohmann::json::parse(scene::probes_to_json(probes));
    std::mt19937 random(seed);
    for (nlohmann::json* list : {&file["volume"]["probes"], &file["reflections"]})
        std::shuffle(list->begin(), list->end(), random);
    EXPECT_NE(file, nlohmann::json::parse(scene::probes_to_json(probes)));
    const auto reader = [&](const std::string&) { return std::optional(file.dump()); };
    const Result<scene::Probes> read = scene::read_probes("other.probes.json", reader, scene);
    EXPECT_TRUE(read) << to_text(read.errors());
    return read ? *read : scene::Probes{};
}

class PictureOrder : public ProbePicture {
 protected:
    std::vector<glm::vec3> seen(const scene::Scene& scene, const scene::Probes& probes) {
        const glm::vec3 sky(400);
        const std::unique_ptr<render::Session> session = begin(scene, probes, {sky, sky, sky});
        if (!session) return {};
        return picture(*session, camera_at({2.7f, 2.1f, 1.7f}, {-0.5f, 0.7f, -0.6f}, 1.2f));
    }
};

// Returns the scene with its instances and lights in another order.
scene::Scene listed_in_another_order(const scene::Scene& scene, uint32_t seed) {
    std::mt19937 random(seed);
    scene::Scene other = scene;
    std::ranges::shuffle(other.instances, random);
    std::ranges::shuffle(other.lights, random);
    return other;
}

// Returns the mean difference of two pictures, as a share of the mean.
double difference_of(const std::vector<glm::vec3>& one, const std::vector<glm::vec3>& two, const char* name) {
    EXPECT_EQ(one.size(), two.size());
    double sum = 0, apart = 0, most = 0;
    for (size_t i = 0; i < std::min(one.size(), two.size()); ++i)
        for (int c = 0; c < 3; ++c) {
            const double away = std::abs(double{one[i][c]} - double{two[i][c]});
            sum += double{one[i][c]};
            apart += away;
            most = std::max(most, away);
        }
    EXPECT_GT(sum, 0);
    std::printf("%s: mean difference %.7f, largest %.6f of the mean\n", name, apart / sum,
                most * 3 * double(one.size()) / sum);
    return apart / sum;
}

// The results differ by roundings: the order of lights is that in which they are added up. Where surfaces lie
// in the same plane, the order of instances and meshes decides which one is drawn.
TEST_F(PictureOrder, DoesNotMatter) {
    const scene::Scene scene = lit_rooms(), listed = listed_in_another_order(scene, 11),
                       shuffled = scene::test::shuffled(scene, 3);
    const scene::Probes probes = placed(scene, 60);
    ASSERT_GE(probes.reflections.size(), 2u);
    EXPECT_NE(scene.lights[0].direction, listed.lights[0].direction);
    const std::vector<glm::vec3> one = seen(scene, probes);
    EXPECT_TRUE(one == seen(scene, listed_in_another_order(scene, probes, 5)));
    EXPECT_LT(difference_of(one, seen(listed, probes), "instances and lights"), 1e-3);
    EXPECT_LT(difference_of(one, seen(shuffled, placed(shuffled, 60)), "meshes and triangles"), 1e-3);
}

}  // namespace
}  // namespace weft::test
