// Tests images with live sizes: a frame uses only the area at the top left of each image, and a change of the
// scale needs no new plan.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/render/session/object_counter.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kWhole{256, 128, 1};
constexpr Extent3D kHalf{128, 64, 1};
constexpr const char* kAreas = WEFT_SOURCE_DIR "/tests/render/areas/areas.json";
constexpr const char* kTrail = WEFT_SOURCE_DIR "/tests/render/areas/trail.json";
// A time at which the shaders of areas.json write NaN.
constexpr double kPoison_s = 2000;
// Number of frames after which the jitter of areas.json repeats.
constexpr uint32_t kJitter = 4;

using Readbacks = std::map<std::string, std::vector<vk::ReadbackData>>;

class Areas : public SessionTest {
 protected:
    static void draw(render::Session& session, double scale, double time_s = 0, double delta_time_s = 0) {
        frame_of(session).parameters = {{"renderScale", scale}};
        const Status done = draw_frame(session, time_s, delta_time_s);
        ASSERT_TRUE(done) << to_text(done.errors());
    }
    // Returns the observed data of all frames since the last call, by the name of the resource.
    static Readbacks take(render::Session& session) {
        EXPECT_TRUE(session.finish());
        Readbacks found;
        for (vk::ReadbackData& data : session.take_readbacks())
            found[data.pass.substr(std::string("observe:").size())].push_back(std::move(data));
        return found;
    }
};

bool has_nan(const vk::ReadbackData& data) {
    const std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
    return std::ranges::any_of(texels, [](const glm::vec4& t) { return glm::any(glm::isnan(t)); });
}

TEST_F(Areas, AFrameAtHalfScaleEqualsAFrameAtHalfTheSize) {
    const std::vector<std::string> observed{"normal", "depth",  "lit",    "copied", "low",
                                            "chain",  "counts", "window", "smooth"};
    const std::unique_ptr<render::Session> large = start(kAreas, kWhole, observed);
    const std::unique_ptr<render::Session> small = start(kAreas, kHalf, observed);
    ASSERT_TRUE(large && small);
    // Fills the images of the large session with NaN, outside of the area, too.
    for (uint32_t frame = 0; frame < kJitter; ++frame) draw(*large, 1, kPoison_s);
    const Readbacks poison = take(*large);
    EXPECT_TRUE(has_nan(poison.at("smooth").back()));
    for (uint32_t frame = 0; frame < 3; ++frame) {
        draw(*large, 0.5, 0, frame);
        draw(*small, 1, 0, frame);
    }
    const Readbacks at_half = take(*large), wanted = take(*small);
    ASSERT_EQ(at_half.size(), observed.size());
    for (const auto& [name, frames] : at_half) {
        ASSERT_EQ(frames.size(), 3u);
        for (size_t i = 0; i < frames.size(); ++i) {
            SCOPED_TRACE(name + " in frame " + std::to_string(i));
            EXPECT_EQ(frames[i].extent, wanted.at(name)[i].extent);
            EXPECT_TRUE(frames[i].bytes == wanted.at(name)[i].bytes);
            EXPECT_FALSE(has_nan(frames[i]));
        }
    }
    // The blit scales the area to the whole output, so each texel of the area fills two by two pixels.
    const Result<vk::ReadbackData> scaled = large->read_output(), plain = small->read_output();
    ASSERT_TRUE(scaled && plain);
    ASSERT_EQ(scaled->extent, kWhole);
    for (uint32_t y = 0; y < kWhole.height; ++y)
        for (uint32_t x = 0; x < kWhole.width; ++x)
            ASSERT_EQ(0, std::memcmp(&scaled->bytes[4 * (size_t{y} * kWhole.width + x)],
                                     &plain->bytes[4 * (size_t{y / 2} * kHalf.width + x / 2)], 4))
                << x << ", " << y;
}

// Returns the picture of `seen` in trail.json.
std::vector<glm::vec4> seen_in(const vk::ReadbackData& data, const Extent3D& area) {
    EXPECT_EQ(data.extent, area);
    return render::decode_texels(data.format, data.bytes);
}

Extent3D area_at(double scale) {
    const auto side = [&](uint32_t px) {
        return static_cast<uint32_t>(std::max(1.0, std::ceil(px * scale - 0.001)));
    };
    return {side(kWhole.width), side(kWhole.height), 1};
}

// Expects that the history has the gradient over its area `before`, and that the pass at rest has drawn it
// again.
void expect_trail(const vk::ReadbackData& data, const Extent3D& now, const Extent3D& before) {
    for (const glm::vec4& texel : seen_in(data, now)) {
        ASSERT_LE(texel.x, 1.0 / 256) << "the history at this place";
        ASSERT_EQ(texel.y, 0) << "a pass with \"rest\" does not run after a change of the area";
        ASSERT_EQ(glm::vec2(texel.z, texel.w), glm::vec2(before.width, before.height));
    }
}

TEST_F(Areas, AHistoryHasTheAreaOfItsFrame) {
    const std::unique_ptr<render::Session> session = start(kTrail, kWhole, {"seen"});
    ASSERT_TRUE(session);
    const std::vector<double> scales{1, 0.5, 0.7, 0.1, 1, 0.33, 0.999, 0.5, 0.5};
    for (const double scale : scales) draw(*session, scale);
    const Readbacks found = take(*session);
    for (size_t i = 0; i < scales.size(); ++i) {
        SCOPED_TRACE("frame " + std::to_string(i));
        expect_trail(found.at("seen")[i], area_at(scales[i]), area_at(scales[i == 0 ? 0 : i - 1]));
    }
}

TEST_F(Areas, AScaleOutsideOfItsRangeIsClamped) {
    const std::unique_ptr<render::Session> session = start(kTrail, kWhole, {"seen"});
    ASSERT_TRUE(session);
    for (const double scale : {7.0, -1.0, 0.0, std::nan("")}) draw(*session, scale);
    const Readbacks found = take(*session);
    const std::vector<vk::ReadbackData>& seen = found.at("seen");
    EXPECT_EQ(seen[0].extent, kWhole);
    EXPECT_EQ(seen[1].extent, area_at(0.1));
    EXPECT_EQ(seen[2].extent, area_at(0.1));
    EXPECT_EQ(seen[3].extent, kWhole);
}

TEST_F(Areas, TheParameterIsTheScaleOfFramesWithoutOne) {
    const std::unique_ptr<render::Session> session = start(kTrail, kWhole, {"seen"});
    ASSERT_TRUE(session);
    const FramePlan* plan = &session->plan();
    const Status first = draw_frame(*session);
    ASSERT_TRUE(first);
    render::Selection selection = session->selection();
    selection.request.params["renderScale"] = 0.5;
    render::PrepareResult prepared = session->prepare(selection);
    ASSERT_TRUE(prepared.result) << to_text(prepared.result.errors());
    EXPECT_TRUE(*session->swap_in(std::move(*prepared.result)));
    EXPECT_EQ(&session->plan(), plan) << "the running plan takes the new value";
    ASSERT_TRUE(draw_frame(*session));
    const Readbacks found = take(*session);
    expect_trail(found.at("seen")[1], kHalf, kWhole);
}

TEST_F(Areas, AChangeOfTheScaleMakesNoObjects) {
    const std::unique_ptr<render::Session> session = start(kAreas, kWhole);
    ASSERT_TRUE(session);
    const FramePlan* plan = &session->plan();
    draw(*session, 1);
    ASSERT_TRUE(session->finish());
    const ObjectCounter counter(*device_);
    for (uint32_t frame = 0; frame < 12; ++frame) draw(*session, 0.1 + 0.075 * frame, 0, 1);
    ASSERT_TRUE(session->finish());
    EXPECT_EQ(counter.live(), 0);
    EXPECT_EQ(session->pipelines_made_between_frames(), 0u);
    EXPECT_EQ(&session->plan(), plan);
}

TEST_F(Areas, AfterAResizeTheAreaOfTheHistoryIsScaledToTheNewArea) {
    const std::unique_ptr<render::Session> session = start(kTrail, kWhole, {"seen"});
    ASSERT_TRUE(session);
    for (const double scale : {1.0, 0.25}) draw(*session, scale);
    const Extent3D larger{320, 200, 1};
    ASSERT_TRUE(session->resize(larger, warnings_));
    draw(*session, 0.5);
    const Readbacks found = take(*session);
    const Extent3D area{160, 100, 1};
    // The old content is stretched, so at the edges it is constant for half a texel of the old area.
    for (const glm::vec4& texel : seen_in(found.at("seen").back(), area)) {
        ASSERT_LE(texel.x, 0.5 / 32 + 1.0 / 128);
        ASSERT_EQ(glm::vec2(texel.z, texel.w), glm::vec2(area.width, area.height));
    }
}

TEST_F(Areas, AScaleStaysUntilTheNextOneOrUntilASwap) {
    const std::unique_ptr<render::Session> session = start(kAreas, kWhole, {"lit"});
    ASSERT_TRUE(session);
    const auto extent = [&] {
        EXPECT_TRUE(draw_frame(*session));
        return take(*session).at("lit").back().extent;
    };
    frame_of(*session).parameters = {{"renderScale", 0.5}};
    EXPECT_EQ(extent(), kHalf);
    frame_of(*session).parameters.clear();
    EXPECT_EQ(extent(), kHalf);
    render::PrepareResult same = session->prepare(session->selection());
    ASSERT_TRUE(same.result) << to_text(same.result.errors());
    ASSERT_TRUE(session->swap_in(std::move(*same.result)));
    EXPECT_EQ(extent(), kWhole) << "the value of the selection holds again";
}

}  // namespace
}  // namespace weft::test
