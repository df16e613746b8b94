// Tests a change of the tier that changes only formats and sizes: resources with `"onResize": "resample"`
// keep their content in the new format. The expected values are computed on the CPU.
#include <algorithm>
#include <cmath>

#include "tests/render/session_fixture.h"
#include "weft/transition.h"

namespace weft::test {
namespace {

constexpr uint32_t kWidth = 24, kHeight = 16;
using Texels = std::vector<glm::vec4>;

// The value that pass "paint" writes at a texel.
glm::dvec4 painted(uint32_t x, uint32_t y) {
    const double third = (x * 7 + y * 3) / 17.0;
    return {x / 31.0, y / 29.0, third - std::floor(third), 0.75};
}

struct Tier {
    const char* name;
    const char* format;
    // The largest error of one channel. `srgb` tells that the error is one of the encoded value.
    double error;
    bool srgb;
};

double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

class ConvertVk : public SessionTest {
 protected:
    void begin() {
        session_ = start(WEFT_SOURCE_DIR "/tests/render/convert/convert.json", {16, 16, 1},
                         {"kept", "trail", "lost"});
        ASSERT_TRUE(session_);
        frame();
    }
    void frame() {
        const Status done = draw_frame(*session_);
        ASSERT_TRUE(done) << to_text(done.errors());
        ASSERT_TRUE(session_->finish());
        for (const vk::ReadbackData& data : session_->take_readbacks())
            images_[data.pass.substr(std::string("observe:").size())] =
                render::decode_texels(data.format, data.bytes);
    }
    void choose(const std::string& tier) {
        render::Selection selection = session_->selection();
        selection.request.tier = tier;
        if (tier == "whole") std::erase(selection.request.observed, "lost");
        render::PrepareResult prepared = session_->prepare(selection);
        ASSERT_TRUE(prepared.result) << to_text(prepared.result.errors());
        const FramePlan& next = *prepared.result->new_plan();
        const TransitionPlan between = transition(session_->plan(), next);
        for (const char* name : {"kept", "trail[-1]", "lost"})
            if (const ResourceId id = find_resource(next.graph, name); id != kNoId)
                report_[name] = content_text(session_->plan(), next, between, id);
        const Result<bool> swapped = session_->swap_in(std::move(*prepared.result));
        ASSERT_TRUE(swapped) << to_text(swapped.errors());
    }
    // Expects that image `name` has the painted picture.
    void expect_picture(const std::string& name, const Tier& tier) {
        const Texels& found = images_.at(name);
        ASSERT_EQ(found.size(), size_t{kWidth} * kHeight);
        double worst = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                glm::dvec4 wanted = painted(x, y);
                if (name == "trail") std::swap(wanted.x, wanted.z);
                const glm::dvec4 got = found[size_t{y} * kWidth + x];
                for (int c = 0; c < 4; ++c) {
                    const bool encodes = tier.srgb && c < 3;
                    worst = std::max(worst, encodes ? std::abs(encoded(got[c]) - encoded(wanted[c]))
                                                    : std::abs(got[c] - wanted[c]));
                }
            }
        EXPECT_LE(worst, tier.error) << name;
        EXPECT_GT(worst, 0) << "the new format has less precision, so some value must differ";
    }

    std::unique_ptr<render::Session> session_;
    std::map<std::string, Texels> images_;
    std::map<std::string, std::string> report_;
};

TEST_F(ConvertVk, TheContentGetsTheNewFormat) {
    // Half floats below 1 have 11 significant bits. Vulkan requires conversions to normalised formats to
    // round to a neighbouring value.
    for (const Tier& tier :
         {Tier{"half", "rgba16f", 1.0 / 1024, false}, Tier{"byte", "rgba8", 1.0 / 255, false},
          Tier{"srgb", "rgba8_srgb", 1.5 / 255, true}}) {
        SCOPED_TRACE(tier.name);
        begin();
        choose(tier.name);
        frame();
        expect_picture("kept", tier);
        expect_picture("trail", tier);
        const std::string wanted = std::string("is converted from rgba32f to ") + tier.format;
        EXPECT_EQ(report_["kept"], "\"kept\" " + wanted);
        EXPECT_EQ(report_["trail[-1]"], "\"trail\" " + wanted);
        for (const glm::vec4& texel : images_.at("lost")) EXPECT_NEAR(texel.x, 0.25, 1.0 / 255);
        EXPECT_NE(report_["lost"].find("is cleared"), std::string::npos) << report_["lost"];
    }
}

// Each texel of the small picture is the mean of four texels: the linear filter samples at their corner.
TEST_F(ConvertVk, SizeAndFormatChangeTogether) {
    begin();
    choose("small");
    frame();
    const Texels& found = images_.at("kept");
    ASSERT_EQ(found.size(), size_t{12} * 8);
    for (uint32_t y = 0; y < 8; ++y)
        for (uint32_t x = 0; x < 12; ++x) {
            const glm::dvec4 mean = (painted(2 * x, 2 * y) + painted(2 * x + 1, 2 * y) +
                                     painted(2 * x, 2 * y + 1) + painted(2 * x + 1, 2 * y + 1)) *
                                    0.25;
            const glm::dvec4 got = found[size_t{y} * 12 + x];
            for (int c = 0; c < 4; ++c)
                EXPECT_NEAR(got[c], mean[c], 1.0 / 256 + 1.0 / 1024) << x << ", " << y;
        }
}

// Floats cannot become integers by a blit.
TEST_F(ConvertVk, OtherKindsOfNumbersAreCleared) {
    begin();
    choose("whole");
    frame();
    for (const glm::vec4& texel : images_.at("kept")) EXPECT_EQ(texel.x, 0);
    EXPECT_EQ(report_["kept"],
              "\"kept\" is cleared: it changes from rgba32f to r32u, and cannot be scaled or converted");
}

TEST_F(ConvertVk, ThereAndBackKeepsThePictureInTheLowerPrecision) {
    begin();
    choose("half");
    frame();
    const Texels half = images_.at("kept");
    choose("byte");
    frame();
    choose("half");
    frame();
    const Texels& again = images_.at("kept");
    ASSERT_EQ(again.size(), half.size());
    for (size_t i = 0; i < half.size(); ++i)
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(again[i][c], half[i][c], 1.0 / 255 + 1.0 / 1024);
}

}  // namespace
}  // namespace weft::test
