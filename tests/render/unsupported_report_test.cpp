// Tests the warnings about parts of a scene that a graph does not draw.
#include "render/unsupported_report.h"

#include <gtest/gtest.h>

#include "shared/light.glsl"

namespace weft::render {
namespace {

FramePlan plan_that_draws(std::vector<std::string> lists) {
    FramePlan plan;
    plan.graph.name = "deferred";
    // Pass 1 is culled, because the schedule's order contains only pass 0.
    plan.graph.passes.resize(2);
    plan.graph.passes[0].draw_lists = std::move(lists);
    plan.graph.passes[1].draw_lists = {"transparent"};
    plan.schedule.order = {0};
    return plan;
}

scene::Scene scene_of(const std::vector<scene::AlphaMode>& modes) {
    scene::Scene scene;
    for (const scene::AlphaMode mode : modes) {
        scene::Material material;
        material.name = "m" + std::to_string(scene.materials.size());
        material.alpha_mode = mode;
        scene.instances.push_back({"", 0, static_cast<uint32_t>(scene.materials.size()), glm::mat4(1)});
        scene.materials.push_back(material);
    }
    return scene;
}

constexpr auto kBlend = scene::AlphaMode::blend;
constexpr auto kMask = scene::AlphaMode::mask;

TEST(UnsupportedReport, TransparentObjectsAreNamedOnce) {
    const Diagnostics said = report_unsupported(plan_that_draws({"opaque", "masked"}),
                                                scene_of({kMask, kBlend, kBlend, kBlend, kBlend, kBlend}));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].code, "S155");
    EXPECT_EQ(said[0].severity, Severity::warning);
    EXPECT_EQ(said[0].message,
              "5 transparent objects are not drawn (BLEND materials: \"m1\", \"m2\", \"m3\", \"m4\" and 1 "
              "more), because no pass of "
              "graph \"deferred\" draws the list \"transparent\"");
    EXPECT_EQ(said[0].help.at(0),
              "use a graph that draws transparent objects, for example --graph graphs/forward.json");
}

TEST(UnsupportedReport, NothingIsSaidOfWhatIsDrawnOrAbsent) {
    EXPECT_TRUE(report_unsupported(plan_that_draws({"opaque", "transparent"}), scene_of({kBlend})).empty());
    EXPECT_TRUE(report_unsupported(plan_that_draws({"opaque"}), scene_of({kMask})).empty());
    EXPECT_TRUE(report_unsupported(plan_that_draws({}), scene_of({kBlend})).empty())
        << "a graph without surfaces";
}

TEST(UnsupportedReport, LightsWithoutRoomAreCountedWhereTheyShine) {
    FramePlan plan;
    plan.graph.passes.resize(1);
    plan.graph.passes[0].type = "light_upload";
    plan.graph.passes[0].uses.resize(1);
    plan.graph.passes[0].uses[0].resource = 0;
    plan.graph.resources.resize(1);
    plan.graph.resources[0].name = "lights";
    plan.graph.resources[0].size_bytes = 2 * sizeof(shared::Light);
    plan.schedule.order = {0};
    scene::Scene scene;
    scene.lights.resize(3);
    scene.lights[1].intensity = 0;
    EXPECT_TRUE(report_unsupported(plan, scene).empty());
    scene.lights[1].intensity = 1;
    const Diagnostics said = report_unsupported(plan, scene);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].code, "S157");
    EXPECT_EQ(said[0].message,
              "the scene has 3 lights, but the buffer \"lights\" has space for only 2; the other lights are "
              "ignored");
}

}  // namespace
}  // namespace weft::render
