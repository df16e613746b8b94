// Tests the complete path from a saved file to a new picture: the change is noticed, prepared on another
// thread, and swapped in between two frames.
#include <chrono>
#include <cstring>
#include <thread>

#include "tests/render/session/live_folder.h"
#include "tests/render/session_fixture.h"
#include "vulkan/device/functions.h"
#include "weft/render/reloader.h"

namespace weft::test {
namespace {

using Clock = std::chrono::steady_clock;
constexpr Extent3D kReloaderSize{64, 36, 1};

// The threads that created pipelines. Global, because make_graphics() and make_compute() are plain
// functions in the device's table, without access to the test object.
std::set<std::thread::id> pipeline_threads;
PFN_vkCreateGraphicsPipelines real_graphics = nullptr;
PFN_vkCreateComputePipelines real_compute = nullptr;
VKAPI_ATTR VkResult VKAPI_CALL make_graphics(VkDevice device, VkPipelineCache cache, uint32_t count,
                                             const VkGraphicsPipelineCreateInfo* infos,
                                             const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    pipeline_threads.insert(std::this_thread::get_id());
    return real_graphics(device, cache, count, infos, allocator, pipelines);
}
VKAPI_ATTR VkResult VKAPI_CALL make_compute(VkDevice device, VkPipelineCache cache, uint32_t count,
                                            const VkComputePipelineCreateInfo* infos,
                                            const VkAllocationCallbacks* allocator, VkPipeline* pipelines) {
    pipeline_threads.insert(std::this_thread::get_id());
    return real_compute(device, cache, count, infos, allocator, pipelines);
}

class Reloads : public SessionTest {
 protected:
    void begin() {
        live_ = start(folder_.graph(), kReloaderSize, {"frames"});
        ASSERT_TRUE(live_);
        draw(2);
        Result<std::unique_ptr<render::Reloader>> made = render::Reloader::start(*live_);
        ASSERT_TRUE(made) << to_text(made.errors());
        reloader_ = std::move(*made);
    }
    void draw(uint32_t frames) {
        for (uint32_t i = 0; i < frames; ++i) {
            const Status done = draw_frame(*live_);
            ASSERT_TRUE(done) << to_text(done.errors());
            ++drawn_;
        }
    }
    // Renders frames until a changed file has led to a result, or until the time `most` is over.
    std::optional<render::Reload> next(std::chrono::milliseconds most = std::chrono::minutes(10)) {
        const Clock::time_point end = Clock::now() + most;
        while (Clock::now() < end) {
            if (std::optional<render::Reload> reload = reloader_->update()) return reload;
            draw(1);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return std::nullopt;
    }
    // Returns the number of frames rendered since the start, from a counter in the graph that goes on when
    // the graph is replaced.
    uint32_t counted() {
        EXPECT_TRUE(live_->finish());
        uint32_t count = 0;
        for (const vk::ReadbackData& data : live_->take_readbacks())
            if (data.pass == "observe:frames") std::memcpy(&count, data.bytes.data(), sizeof count);
        return count;
    }
    Extent3D paint_extent() const {
        const ResolvedGraph& graph = live_->plan().graph;
        const ResourceId paint = find_resource(graph, "paint");
        return paint != kNoId ? graph.resources[paint].extent : Extent3D{};
    }
    // Returns the last texel of the output image of the last frame.
    uint32_t last_texel() {
        EXPECT_TRUE(live_->finish());
        const Result<vk::ReadbackData> output = live_->read_output();
        EXPECT_TRUE(output);
        uint32_t texel = 0;
        std::memcpy(&texel, output->bytes.data() + output->bytes.size() - sizeof texel, sizeof texel);
        return texel;
    }

    LiveFolder folder_;
    std::unique_ptr<render::Session> live_;
    // Declared after the session, so that it is destroyed before the session.
    std::unique_ptr<render::Reloader> reloader_;
    uint32_t drawn_ = 0;
};

TEST_F(Reloads, AnEditAnErrorAndItsEnd) {
    begin();
    EXPECT_FALSE(next(std::chrono::milliseconds(300))) << "nobody changed anything";
    const uint32_t before = last_texel();
    real_graphics = std::exchange(device_->fn().vkCreateGraphicsPipelines, make_graphics);
    real_compute = std::exchange(device_->fn().vkCreateComputePipelines, make_compute);
    pipeline_threads.clear();

    folder_.replace("tint.glsl", "vec3(1.0", "vec3(0.5");
    std::optional<render::Reload> reload = next();
    ASSERT_TRUE(reload);
    EXPECT_TRUE(reload->good()) << to_text(reload->errors);
    EXPECT_EQ(to_text(reload->rebuilt), "1 of 4 shaders, 1 of 4 pipelines");
    draw(2);
    const uint32_t after = last_texel();
    EXPECT_NE(after, before);

    folder_.remove("tint.glsl");
    reload = next();
    ASSERT_TRUE(reload);
    ASSERT_FALSE(reload->good());
    EXPECT_EQ(reload->errors.front().code, "W203");
    draw(2);
    EXPECT_EQ(last_texel(), after);

    folder_.restore();
    reload = next();
    ASSERT_TRUE(reload) << "an include that was missing is waited for";
    EXPECT_TRUE(reload->good()) << to_text(reload->errors);
    EXPECT_EQ(to_text(reload->rebuilt), "nothing changed");
    EXPECT_EQ(last_texel(), after);

    device_->fn().vkCreateGraphicsPipelines = real_graphics;
    device_->fn().vkCreateComputePipelines = real_compute;
    EXPECT_FALSE(pipeline_threads.empty());
    EXPECT_FALSE(pipeline_threads.contains(std::this_thread::get_id()));
}

TEST_F(Reloads, WhatABrokenGraphDoesNotNameIsStillWatched) {
    begin();
    folder_.spoil("live.json", "{ \"version\": 1,");
    std::optional<render::Reload> reload = next();
    ASSERT_TRUE(reload);
    EXPECT_FALSE(reload->good());
    folder_.replace("paint.comp", "scale = 1.0", "scale = 0.5");
    reload = next();
    ASSERT_TRUE(reload);
    EXPECT_FALSE(reload->good()) << "the graph is as broken as before";
    folder_.restore();
    reload = next();
    ASSERT_TRUE(reload);
    EXPECT_EQ(to_text(reload->rebuilt), "1 of 4 shaders, 1 of 4 pipelines");
}

TEST_F(Reloads, AGraphThatStartsToIncludeIsFollowedThere) {
    begin();
    std::filesystem::create_directory(folder_.path("deep"));
    folder_.set("deep/other.glsl", "const vec3 kTint = vec3(0.5);");
    folder_.replace("paint.comp", "tint.glsl", "deep/other.glsl");
    std::optional<render::Reload> reload = next();
    ASSERT_TRUE(reload);
    ASSERT_TRUE(reload->good()) << to_text(reload->errors);
    draw(2);
    const uint32_t before = last_texel();
    folder_.replace("deep/other.glsl", "0.5", "0.9");
    reload = next();
    ASSERT_TRUE(reload) << "the new include isn't watched";
    EXPECT_EQ(to_text(reload->rebuilt), "1 of 4 shaders, 1 of 4 pipelines");
    draw(2);
    EXPECT_NE(last_texel(), before);
}

TEST_F(Reloads, ANewSizeMayComeInBetween) {
    begin();
    folder_.replace("live.json", "[40, 24]", "[56, 16]");
    // Waits until the new graph is probably prepared. The resize then makes that prepared graph out of date.
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    ASSERT_TRUE(live_->resize({48, 20, 1}, warnings_));
    const std::optional<render::Reload> reload = next();
    ASSERT_TRUE(reload);
    EXPECT_TRUE(reload->good()) << to_text(reload->errors);
    draw(1);
    ASSERT_TRUE(live_->finish());
    const Result<vk::ReadbackData> output = live_->read_output();
    ASSERT_TRUE(output);
    EXPECT_EQ(output->extent, (Extent3D{48, 20, 1}));
    EXPECT_EQ(paint_extent(), (Extent3D{56, 16, 1}));
    EXPECT_EQ(counted(), drawn_);
}

// Tests a change of parameters, as a menu of the program would make it.
TEST_F(Reloads, OtherParametersAreAnotherSelection) {
    begin();
    const uint32_t before = last_texel();
    render::Selection selection = live_->selection();
    selection.request.params["gain"] = 0.125;
    reloader_->select(selection);
    const std::optional<render::Reload> reload = next();
    ASSERT_TRUE(reload);
    EXPECT_EQ(to_text(reload->rebuilt), "new values");
    draw(1);
    EXPECT_NE(last_texel(), before);
}

TEST_F(Reloads, AnotherTierIsAnotherSelection) {
    begin();
    render::Selection selection = live_->selection();
    selection.request.tier = "low";
    reloader_->select(selection);
    const std::optional<render::Reload> reload = next();
    ASSERT_TRUE(reload);
    EXPECT_TRUE(reload->good()) << to_text(reload->errors);
    EXPECT_EQ(to_text(reload->rebuilt), "a new plan");
    draw(1);
    ASSERT_TRUE(live_->finish());
    EXPECT_EQ(paint_extent(), (Extent3D{20, 12, 1}));
    EXPECT_EQ(counted(), drawn_);
    // The selected tier stays selected when a file changes.
    folder_.replace("paint.comp", "scale = 1.0", "scale = 0.5");
    ASSERT_TRUE(next());
    EXPECT_EQ(live_->selection().request.tier, "low");
}

TEST_F(Reloads, AnIncludedGraphIsFollowedToo) {
    begin();
    folder_.spoil("count.json", "{");
    std::optional<render::Reload> reload = next();
    ASSERT_TRUE(reload);
    ASSERT_FALSE(reload->good());
    EXPECT_TRUE(reload->errors.front().file.ends_with("count.json")) << to_text(reload->errors);
    folder_.set("count.json", folder_.text("count.json") + "\n", LiveFolder::Way::in_place);
    reload = next();
    ASSERT_TRUE(reload);
    EXPECT_EQ(to_text(reload->rebuilt), "nothing changed");
    EXPECT_EQ(counted(), drawn_);
}

}  // namespace
}  // namespace weft::test
