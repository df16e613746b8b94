// Tests passes with "rest" on the device. A pass runs only if something has changed that its result depends
// on. Every frame must have the same bytes as the frame of a session in which no pass rests.
#include <algorithm>
#include <random>
#include <set>

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

    void set_power(render::Session& session, double power) {
        render::Selection selection = session.selection();
        selection.request.params["power"] = power;
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

}  // namespace
}  // namespace weft::test
