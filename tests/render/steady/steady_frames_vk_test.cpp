// Tests that every frame costs the same: after the first frames nothing is compiled, no object is left
// behind, and memory does not grow. Runs without validation layers, because these use more and more memory
// themselves.
#include <malloc.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/render/code_counter/code_counter.h"
#include "tests/render/session/object_counter.h"
#include "tests/render/session_fixture.h"
#include "tests/vulkan/scoped_environment.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

constexpr Extent3D kSize{64, 36, 1};
constexpr double kStep_s = 1.0 / 60;
// Number of frames at the start in which the driver may still compile code.
constexpr uint32_t kFirstFrames = 3;
// Number of frames in which nothing may be compiled. Together with kFirstFrames, these are 12 frames. No
// graph keeps a history of so many frames, and branches.json has only 8 sub-pixel camera offsets (jitter).
constexpr uint32_t kSteadyFrames = 9;
constexpr int64_t kMiB = 1 << 20;

bool extended() {
    return std::getenv("WEFT_EXTENDED") != nullptr;
}

std::string shipped(const std::string& name) {
    return std::string(WEFT_SOURCE_DIR "/graphs/") + name + ".json";
}

std::vector<std::string> shipped_graphs() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(WEFT_SOURCE_DIR "/graphs")) {
        const std::string file = entry.path().filename();
        if (file.ends_with(".json") && file != "weft.schema.json") names.push_back(entry.path().stem());
    }
    std::ranges::sort(names);
    return names;
}

std::vector<std::string> tiers_of(const std::string& path) {
    const auto graph = nlohmann::json::parse(*read_text(path), nullptr, true, true);
    std::vector<std::string> tiers;
    const auto written = graph.value("tiers", nlohmann::json::object());
    for (const auto& [name, tier] : written.items()) tiers.push_back(name);
    return tiers;
}

class Steady : public SessionTest {
 protected:
    void SetUp() override {
        make_device(false);
        if (HasFatalFailure()) return;
        if (!device_->info().driver.starts_with("llvmpipe"))
            GTEST_SKIP() << "counts what llvmpipe compiles, and this is " << device_->info().driver;
    }
    void begin(const std::string& graph, const std::string& scene_name) {
        const Result<scene::Scene> scene = scene::make_builtin(scene_name);
        ASSERT_TRUE(scene) << to_text(scene.errors());
        session_ = start(*scene, scene::framing_camera(*scene, 64.0f / 36), graph, kSize, {});
        ASSERT_TRUE(session_);
    }
    void draw(uint32_t frames) {
        for (uint32_t i = 0; i < frames; ++i) {
            time_s_ += kStep_s;
            const Status done = draw_frame(*session_, time_s_, kStep_s);
            ASSERT_TRUE(done) << to_text(done.errors());
        }
        ASSERT_TRUE(session_->finish());
    }
    // Renders frames, and waits for the end of each frame before the next one begins.
    void draw_apart(uint32_t frames) {
        for (uint32_t i = 0; i < frames; ++i) ASSERT_NO_FATAL_FAILURE(draw(1));
    }
    // Selects another tier or other parameters for the next frames.
    void select(const render::Selection& selection) {
        render::PrepareResult made = session_->prepare(selection);
        ASSERT_TRUE(made.result) << to_text(made.result.errors());
        const Result<bool> swapped = session_->swap_in(std::move(*made.result));
        ASSERT_TRUE(swapped && *swapped);
    }
    void expect_steady(const ObjectCounter& objects) {
        ASSERT_NO_FATAL_FAILURE(draw(kFirstFrames));
        const int64_t live = objects.live();
        const uint64_t compiled = compiled_modules();
        ASSERT_GT(compiled, 0u) << "nothing is counted";
        ASSERT_NO_FATAL_FAILURE(draw(kSteadyFrames));
        EXPECT_EQ(compiled_modules() - compiled, 0u) << "pieces of code in " << kSteadyFrames << " frames";
        EXPECT_EQ(objects.live(), live);
    }

    std::unique_ptr<render::Session> session_;
    double time_s_ = 0;
};

// All threads use one heap (arena). Otherwise lavapipe's thread has a heap of its own, and malloc_trim() does
// not return the free memory at the end of such a heap, so resident_bytes() would count it.
const int one_arena = mallopt(M_ARENA_MAX, 1);

// Here llvmpipe starts no worker threads (LP_NUM_THREADS is 0), so that its memory use does not depend on how
// busy the machine is.
class SteadyMemory : public Steady {
 protected:
    void SetUp() override {
        ASSERT_EQ(one_arena, 1) << "the allocator takes no such setting";
        Steady::SetUp();
    }

 private:
    const vk::ScopedEnvironment one_thread_{"LP_NUM_THREADS", "0"};
};

class SteadyMemoryOfGraph : public SteadyMemory, public testing::WithParamInterface<std::string> {};

class SteadyGraph : public Steady, public testing::WithParamInterface<std::string> {};

// Returns the passes that rest in a steady frame of a shipped graph, while the camera stands still.
// `lamp_maps`: the number of shadow maps of lamps.
std::set<std::string> wanted_sleepers(const std::string& graph, bool has_sun, uint32_t lamp_maps) {
    if (graph == "fjord" || graph == "reaction_diffusion") return {};
    std::set<std::string> passes{"dfg", "environmentSource", "environmentIrradiance", "noFurtherSuns"};
    for (int mip = 1; mip <= 8; ++mip) passes.insert("environmentMips#" + std::to_string(mip));
    for (int mip = 1; mip <= 5; ++mip) passes.insert("environmentFilter#" + std::to_string(mip));
    for (uint32_t map = 0; map < lamp_maps; ++map) passes.insert("lampShadows#" + std::to_string(map));
    if (has_sun)
        passes.insert({"sunShadows#0", "sunShadows#1", "sunShadows#2", "sunShadows#3"});
    else
        passes.insert("noSun");
    return passes;
}

// Checks which passes rested in the last frame, and that a frame records no barrier for them.
void expect_sleepers(render::Session& session, const std::string& graph, bool has_sun, uint32_t lamp_maps) {
    const std::vector<vk::FrameTiming> timings = session.take_timings();
    ASSERT_FALSE(timings.empty());
    std::set<std::string> sleepers;
    for (const vk::PassTiming& pass : timings.back().passes)
        if (pass.rested) sleepers.insert(pass.pass);
    EXPECT_EQ(sleepers, wanted_sleepers(graph, has_sun, lamp_maps));
    const FramePlan& plan = session.plan();
    uint32_t recorded = 0, left_out = 0;
    for (const PassStep& step : plan.barriers.steps) {
        if (!sleepers.contains(plan.graph.passes[step.pass].name)) continue;
        for (const std::vector<BarrierDecl>* list : {&step.barriers, &step.after})
            for (const BarrierDecl& barrier : *list) ++(barrier.if_pass_runs ? left_out : recorded);
    }
    std::printf("%s: %zu passes rest; for them %u barriers are recorded and %u left out\n", graph.c_str(),
                sleepers.size(), recorded, left_out);
    EXPECT_EQ(recorded, 0u);
}

TEST_P(SteadyGraph, CompilesNothingInAnyTierAndLetsStillPassesRest) {
    const ObjectCounter objects(*device_);
    ASSERT_NO_FATAL_FAILURE(begin(shipped(GetParam()), "spheres"));
    ASSERT_NO_FATAL_FAILURE(expect_steady(objects));
    expect_sleepers(*session_, GetParam(), false, 6);
    for (const std::string& tier : tiers_of(shipped(GetParam()))) {
        SCOPED_TRACE(tier);
        render::Selection selection = session_->selection();
        selection.request.tier = tier;
        ASSERT_NO_FATAL_FAILURE(select(selection));
        ASSERT_NO_FATAL_FAILURE(expect_steady(objects));
    }
    session_.reset();
    EXPECT_EQ(objects.live(), 0);
}

// With a sun, the shadow maps rest while nothing moves, also with the jitter of the graph taa. They are drawn
// again if the camera moves far enough.
TEST_F(Steady, SunMapsRestWhileNothingMoves) {
    for (const char* graph : {"deferred", "forward", "taa"}) {
        ASSERT_NO_FATAL_FAILURE(begin(shipped(graph), "atrium"));
        ASSERT_NO_FATAL_FAILURE(draw_apart(2));
        expect_sleepers(*session_, graph, true, 64);
        frame_of(*session_).camera.transform[3].x += 1;
        ASSERT_NO_FATAL_FAILURE(draw_apart(1));
        const std::vector<vk::FrameTiming> timings = session_->take_timings();
        ASSERT_FALSE(timings.empty());
        // The map that covers the whole scene stays the same.
        const auto rested = std::ranges::count_if(timings.back().passes, [](const vk::PassTiming& pass) {
            return pass.rested && pass.pass.starts_with("sunShadows");
        });
        EXPECT_LE(rested, 1) << graph;
    }
}

TEST_P(SteadyMemoryOfGraph, StaysForManyFrames) {
    if (!extended()) GTEST_SKIP() << "only with WEFT_EXTENDED";
    const ObjectCounter objects(*device_);
    ASSERT_NO_FATAL_FAILURE(begin(shipped(GetParam()), "atrium"));
    ASSERT_NO_FATAL_FAILURE(draw_apart(kFirstFrames));
    const uint64_t compiled = compiled_modules();
    ASSERT_NO_FATAL_FAILURE(draw_apart(50 - kFirstFrames));
    const uint64_t early = resident_bytes();
    const int64_t live = objects.live();
    ASSERT_NO_FATAL_FAILURE(draw_apart(450));
    const uint64_t late = resident_bytes();
    std::printf("%s: resident KiB %llu after 50 frames and %llu after 500\n", GetParam().c_str(),
                static_cast<unsigned long long>(early / 1024), static_cast<unsigned long long>(late / 1024));
    EXPECT_EQ(compiled_modules() - compiled, 0u);
    EXPECT_EQ(objects.live(), live);
    EXPECT_LE(static_cast<int64_t>(late - early), kMiB);
}

INSTANTIATE_TEST_SUITE_P(Shipped, SteadyGraph, testing::ValuesIn(shipped_graphs()),
                         [](const auto& graph) { return graph.param; });
INSTANTIATE_TEST_SUITE_P(Shipped, SteadyMemoryOfGraph, testing::ValuesIn(shipped_graphs()),
                         [](const auto& graph) { return graph.param; });

// Tests shaders with branches on values that may change while frames are rendered, as authors may write them.
class SteadyBranches : public Steady {
 protected:
    const std::string graph_ = WEFT_SOURCE_DIR "/tests/render/steady/branches.json";
};

TEST_F(SteadyBranches, CompileNothing) {
    const ObjectCounter objects(*device_);
    ASSERT_NO_FATAL_FAILURE(begin(graph_, "spheres"));
    expect_steady(objects);
}

TEST_F(SteadyBranches, CompileNothingWhenAParameterChanges) {
    const ObjectCounter objects(*device_);
    ASSERT_NO_FATAL_FAILURE(begin(graph_, "spheres"));
    ASSERT_NO_FATAL_FAILURE(draw(kFirstFrames));
    const int64_t live = objects.live();
    const uint64_t compiled = compiled_modules();
    for (int i = 1; i <= 5; ++i) {
        render::Selection selection = session_->selection();
        selection.request.params["gain"] = 0.5 + 0.1 * i;
        ASSERT_NO_FATAL_FAILURE(select(selection));
        ASSERT_NO_FATAL_FAILURE(draw(2));
    }
    EXPECT_EQ(compiled_modules() - compiled, 0u) << "pieces of code for 5 values";
    EXPECT_EQ(objects.live(), live);
}

// Runs the tests on a newer version of Mesa, which tests/drivers/fetch.sh downloads from Debian.
class SteadyOnMesaOfBackports : public Steady {
 protected:
    void SetUp() override {
        const fs::path driver = WEFT_SOURCE_DIR "/build/drivers/mesa-backports/icd.json";
        if (!fs::exists(driver)) GTEST_SKIP() << "no " << driver << ": tests/drivers/fetch.sh gets it";
        chosen_.emplace("VK_DRIVER_FILES", driver.string());
        Steady::SetUp();
    }

 private:
    std::optional<vk::ScopedEnvironment> chosen_;
};

TEST_F(SteadyOnMesaOfBackports, BranchesCompileNothing) {
    const ObjectCounter objects(*device_);
    ASSERT_NO_FATAL_FAILURE(begin(WEFT_SOURCE_DIR "/tests/render/steady/branches.json", "spheres"));
    expect_steady(objects);
}

TEST_F(SteadyOnMesaOfBackports, ShippedGraphsCompileNothing) {
    if (!extended()) GTEST_SKIP() << "only with WEFT_EXTENDED";
    const ObjectCounter objects(*device_);
    for (const std::string& name : shipped_graphs()) {
        SCOPED_TRACE(name);
        ASSERT_NO_FATAL_FAILURE(begin(shipped(name), "spheres"));
        expect_steady(objects);
        session_.reset();
    }
}

// Tests a scene with moving lights, which are uploaded in every frame.
TEST_F(Steady, MovingLightsCompileNothing) {
    const ObjectCounter objects(*device_);
    ASSERT_NO_FATAL_FAILURE(begin(shipped("light_indexed"), "lights"));
    expect_steady(objects);
}

TEST_F(Steady, TimesThatNobodyTakesDoNotPileUp) {
    ASSERT_NO_FATAL_FAILURE(begin(WEFT_SOURCE_DIR "/tests/render/steady/branches.json", "spheres"));
    ASSERT_NO_FATAL_FAILURE(draw(40));
    EXPECT_EQ(session_->take_timings().size(), 32u) << "the newest, as executor.h says";
}

TEST_F(SteadyMemory, OfForwardShadingStays) {
    ASSERT_NO_FATAL_FAILURE(begin(shipped("forward"), "spheres"));
    ASSERT_NO_FATAL_FAILURE(draw_apart(20));
    const uint64_t early = resident_bytes();
    ASSERT_NO_FATAL_FAILURE(draw_apart(60));
    EXPECT_LE(static_cast<int64_t>(resident_bytes() - early), kMiB) << "in 60 frames";
}

}  // namespace
}  // namespace weft::test
