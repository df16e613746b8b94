// Tests passes with "rest" on the device. A pass runs only if something has changed that its result depends
// on. Every frame must have the same bytes as the frame of a session in which no pass rests.
#include <algorithm>
#include <random>
#include <set>

#include "tests/graph/samples/random_rest.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr const char* kGraph = WEFT_SOURCE_DIR "/tests/render/rest/rest.json";
const std::vector<std::string> kObserved{"table", "rough", "smooth", "place", "outline"};

// Reads files without the key "rest".
std::optional<std::string> read_restless(const std::string& path) {
    std::optional<std::string> text = read_text(path);
    const std::string key = ", \"rest\": true";
    for (size_t at = 0; text && (at = text->find(key)) != std::string::npos;) text->erase(at, key.size());
    return text;
}

class Rest : public SessionTest {
 protected:
    std::unique_ptr<render::Session> begin(const FileReader& reader) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        EXPECT_TRUE(scene);
        return start(*scene, scene::framing_camera(*scene, 1), kGraph, {32, 32, 1}, kObserved, 0, reader);
    }

    // Renders one frame, and returns the names of the passes with "rest" that ran.
    static std::set<std::string> frame(render::Session& session, double time_s = 0) {
        EXPECT_TRUE(draw_frame(session, time_s));
        EXPECT_TRUE(session.finish());
        std::set<std::string> ran;
        for (const vk::FrameTiming& timing : session.take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (!pass.woken_by.empty()) ran.insert(pass.pass);
        return ran;
    }

    std::unique_ptr<render::Session> begin_random(const RandomRest& made, const FileReader& reader,
                                                  bool rests) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        passes_ = registered_passes();
        render::SessionInput input;
        input.request.path = WEFT_SOURCE_DIR "/tests/render/rest/random/graph.json";
        input.request.size = {64, 64, 1};
        input.request.observed = made.observed;
        input.request.rests = rests;
        input.load.reader = reader;
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.passes = &passes_;
        input.check_plan = true;
        input.queues = queues_;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, *scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = scene::framing_camera(*scene, 1)};
        return std::move(*session);
    }

    void set_power(render::Session& session, double power) { set_param(session, "power", power); }
    void set_param(render::Session& session, const std::string& name, double value) {
        render::Selection selection = session.selection();
        selection.request.params[name] = value;
        render::PrepareResult made = session.prepare(selection);
        ASSERT_TRUE(made.result) << to_text(made.result.errors());
        const Result<bool> swapped = session.swap_in(std::move(*made.result));
        ASSERT_TRUE(swapped) << to_text(swapped.errors());
        ASSERT_TRUE(*swapped);
    }
};

TEST_F(Rest, APassRunsOnlyIfItsInputsHaveChanged) {
    const std::unique_ptr<render::Session> session = begin(read_text);
    ASSERT_TRUE(session);
    using Names = std::set<std::string>;
    EXPECT_EQ(frame(*session), (Names{"base", "blurred", "eye", "fill", "halve", "shape"}));
    EXPECT_EQ(frame(*session), Names{});
    EXPECT_EQ(frame(*session, 1.5), Names{}) << "no pass with rest reads the time";
    set_power(*session, 3);
    EXPECT_EQ(frame(*session), (Names{"base", "blurred", "halve"}));
    set_power(*session, 3);
    EXPECT_EQ(frame(*session), Names{});
    frame_of(*session).camera.transform[3].x += 0.5f;
    EXPECT_EQ(frame(*session), (Names{"eye", "shape"}));
    frame_of(*session).exposure_ev = 1;
    EXPECT_EQ(frame(*session), Names{}) << "no pass with rest reads the exposure";
}

TEST_F(Rest, APassThatWakesTellsWhatHasChanged) {
    const std::unique_ptr<render::Session> session = begin(read_text);
    ASSERT_TRUE(session);
    const auto reasons = [&] {
        EXPECT_TRUE(draw_frame(*session));
        EXPECT_TRUE(session->finish());
        std::map<std::string, std::string> found;
        for (const vk::FrameTiming& timing : session->take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (!pass.woken_by.empty()) found[pass.pass] = pass.woken_by;
        return found;
    };
    EXPECT_EQ(reasons()["base"], "the pass has not run with this plan and these shaders");
    set_power(*session, 3);
    std::map<std::string, std::string> found = reasons();
    EXPECT_EQ(found["base"], "member \"power\" of Params of pass \"base\" has changed");
    EXPECT_EQ(found["halve"], "pass \"base\" ran");
    frame_of(*session).camera.transform[3].x += 0.5f;
    found = reasons();
    EXPECT_EQ(found["eye"],
              "a constant of the frame or of view \"camera\" that pass \"eye\" reads has changed");
    EXPECT_EQ(found.count("base"), 0u);
}

// After a resize, a unit rests if its resources keep their size and its inputs have not changed.
TEST_F(Rest, AResizeWakesOnlyWhatItTouches) {
    const std::unique_ptr<render::Session> session = begin(read_text);
    ASSERT_TRUE(session);
    EXPECT_EQ(frame(*session).size(), 6u);
    ASSERT_TRUE(session->resize({40, 40, 1}, warnings_));
    // The transient `rough` is observed, and a new plan does not have its content.
    EXPECT_EQ(frame(*session), (std::set<std::string>{"blurred", "halve"}));
    EXPECT_EQ(frame(*session), std::set<std::string>{});
    ASSERT_TRUE(session->resize({40, 20, 1}, warnings_));
    EXPECT_TRUE(frame(*session).contains("shape")) << "the view has another shape";
}

// 60 frames with random changes give the same bytes with and without rest.
TEST_F(Rest, GivesTheBytesOfASessionWithoutRest) {
    for (queues_ = 1; queues_ <= 3; queues_ += 2) {
        make_device(true);
        const std::unique_ptr<render::Session> resting = begin(read_text), running = begin(read_restless);
        ASSERT_TRUE(resting && running);
        std::mt19937 random(queues_);
        size_t ran = 0;
        for (uint32_t i = 0; i < 60; ++i) {
            SCOPED_TRACE("frame " + std::to_string(i));
            if (random() % 4 == 0) frame_of(*resting).camera.transform[3].x += 0.25f;
            frame_of(*running).camera = frame_of(*resting).camera;
            if (random() % 4 == 0) {
                const double power = 1 + static_cast<double>(random() % 12) / 4;
                set_power(*resting, power);
                set_power(*running, power);
            }
            if (random() % 10 == 0) {
                const uint32_t side = 24 + 8 * static_cast<uint32_t>(random() % 3);
                ASSERT_TRUE(resting->resize({side, side, 1}, warnings_));
                ASSERT_TRUE(running->resize({side, side, 1}, warnings_));
            }
            ran += frame(*resting, i).size();
            EXPECT_TRUE(frame(*running, i).empty());
            const std::vector<vk::ReadbackData> a = resting->take_readbacks(), b = running->take_readbacks();
            ASSERT_EQ(a.size(), kObserved.size());
            ASSERT_EQ(b.size(), kObserved.size());
            for (size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].bytes, b[k].bytes) << a[k].pass;
            const Result<vk::ReadbackData> left = resting->read_output(), right = running->read_output();
            ASSERT_TRUE(left && right);
            EXPECT_EQ(left->bytes, right->bytes);
        }
        std::printf("%u queues: %zu of 360 passes ran\n", queues_, ran);
        EXPECT_LT(ran, 250u);
    }
}

// Random graphs with random changes of their parameters give the same bytes with and without rest.
TEST_F(Rest, RandomGraphsGiveTheBytesOfRunningEverything) {
    size_t ran = 0, all = 0;
    queues_ = 3;
    make_device(true);
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 50 : 12;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        queues_ = 1 + seed % 3;
        const RandomRest made = random_rest(seed + 60000, RestShaders::real);
        SCOPED_TRACE("seed " + std::to_string(seed + 60000) + "\n" + made.text);
        const FileReader reader = [&](const std::string& path) {
            return path.ends_with("graph.json") ? std::optional("{\"version\": 1, " + made.text + "}")
                                                : read_text(path);
        };
        const std::unique_ptr<render::Session> resting = begin_random(made, reader, true),
                                               running = begin_random(made, reader, false);
        ASSERT_TRUE(resting && running);
        std::mt19937 random(seed);
        for (uint32_t i = 0; i < 8; ++i) {
            for (uint32_t change = random() % 3; change > 0; --change) {
                const std::string param = "p" + std::to_string(random() % made.params);
                const double value = static_cast<double>(random() % 8) / 8;
                set_param(*resting, param, value);
                set_param(*running, param, value);
            }
            ran += frame(*resting).size();
            all += made.rest_passes;
            EXPECT_TRUE(frame(*running).empty());
            const std::vector<vk::ReadbackData> a = resting->take_readbacks(), b = running->take_readbacks();
            ASSERT_EQ(a.size(), b.size());
            for (size_t k = 0; k < a.size(); ++k)
                ASSERT_EQ(a[k].bytes, b[k].bytes) << a[k].pass << " in frame " << i;
        }
    }
    std::printf("seeds 60001..%u: %zu of %zu passes with rest ran\n", 60000 + seeds, ran, all);
    EXPECT_LT(ran * 3, all * 2);
}

}  // namespace
}  // namespace weft::test
