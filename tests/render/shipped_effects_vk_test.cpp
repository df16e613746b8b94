// Tests properties of the shipped effects with the passes of their own modules: bloom conserves light,
// anti-aliasing converges to the mean of its frames, and the reaction follows Gray and Scott's model.
#include <algorithm>
#include <cmath>

#include "tests/render/effects_fixture.h"

namespace weft::test {
namespace {

class Bloom : public ShippedEffects {
 protected:
    static Json bloom(float speck, float everywhere, float calm) {
        const Json picture{{"type", "compute"},
                           {"shader", "speck.comp"},
                           {"out", {"hdr"}},
                           {"params", {{"speck", speck}, {"everywhere", everywhere}}}};
        Json graph = behind_picture("bloom", picture, {"first", "down", "up"}, {"bloom"});
        graph["params"]["bloomCalm"]["default"] = calm;
        return graph;
    }
};

glm::dvec3 sum_of(const Image& image) {
    glm::dvec3 sum(0);
    for (const glm::vec4& texel : image) sum += glm::dvec3(texel);
    return sum;
}

TEST_F(Bloom, LeavesAnEvenPictureAsItIs) {
    const auto seen = picture(bloom(0, 1.5f, 0.5f), {96, 54, 1}, {"bloom"});
    ASSERT_EQ(seen.size(), 1u);
    for (const glm::vec4& texel : seen.at("bloom")) EXPECT_EQ(glm::vec3(texel), glm::vec3(1.5f, 0.75f, 3));
}

TEST_F(Bloom, SpreadsASpeckAndLosesNoneOfIt) {
    constexpr Extent3D kSize{256, 256, 1};
    constexpr float kSpeck = 4096;
    const auto kept = picture(bloom(kSpeck, 0, 0), kSize, {"bloom.mip(0)"}),
               calmed = picture(bloom(kSpeck, 0, 1), kSize, {"bloom.mip(0)"});
    ASSERT_TRUE(kept.contains("bloom.mip(0)") && calmed.contains("bloom.mip(0)"));
    const Image& image = kept.at("bloom.mip(0)");
    // A texel of the blurred picture stands for 4 pixels.
    const glm::dvec3 share = 4.0 * sum_of(image) / glm::dvec3(kSpeck, kSpeck / 2, kSpeck * 2);
    const double calmed_share = 4.0 * sum_of(calmed.at("bloom.mip(0)")).r / kSpeck;
    const auto lit = std::ranges::count_if(image, [](const glm::vec4& texel) { return texel.r > 0; });
    std::printf("of a speck's light %.4f %.4f %.4f are there, on %td texels; calmed, %.4f\n", share.r,
                share.g, share.b, lit, calmed_share);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(share[c], 1, 0.005);
    EXPECT_GT(lit, 5000) << "it spreads widely";
    EXPECT_LT(image[64 * 128 + 64].r, kSpeck * 0.1f) << "and little remains where it was";
    EXPECT_LT(calmed_share, 0.3) << "a calmed speck spreads less";
}

// Compresses a colour as the anti-aliasing pass does before it blends frames: a channel with the value 0.5
// becomes 0.5.
glm::dvec3 compressed(const glm::vec4& color) {
    const glm::dvec3 c(color);
    return c / (c + 0.5);
}

double worst_between(const Image& image, const std::vector<glm::dvec3>& wanted) {
    double worst = 0;
    for (size_t i = 0; i < image.size(); ++i) {
        const glm::dvec3 off = glm::abs(compressed(image[i]) - wanted[i]);
        worst = std::max({worst, off.r, off.g, off.b});
    }
    return worst;
}

double rms_between(const Image& image, const std::vector<glm::dvec3>& wanted) {
    double sum = 0;
    for (size_t i = 0; i < image.size(); ++i) {
        const glm::dvec3 off = compressed(image[i]) - wanted[i];
        sum += glm::dot(off, off) / 3;
    }
    return std::sqrt(sum / static_cast<double>(image.size()));
}

class AntiAliasing : public ShippedEffects {
 protected:
    static constexpr uint32_t kFrames = 16;

    void run(double trust) {
        Json graph = shipped("taa");
        graph["params"]["trust"]["default"] = trust;
        seen_ = frames(graph, graph_path("taa"), {96, 54, 1}, kFrames, {"hdr", "velocity", "resolved"});
        ASSERT_EQ(seen_.size(), kFrames);
        mean_.assign(seen_[0].at("hdr").size(), glm::dvec3(0));
        for (const auto& frame : seen_)
            for (size_t i = 0; i < mean_.size(); ++i)
                mean_[i] += compressed(frame.at("hdr")[i]) / static_cast<double>(kFrames);
    }

    std::vector<std::map<std::string, Image>> seen_;
    std::vector<glm::dvec3> mean_;
};

TEST_F(AntiAliasing, VelocitiesOfWhatStandsStillAreZeroWhileThePictureIsJittered) {
    ASSERT_NO_FATAL_FAILURE(run(1.25));
    for (uint32_t frame = 0; frame < kFrames; ++frame) {
        for (const glm::vec4& texel : seen_[frame].at("velocity")) ASSERT_EQ(glm::vec2(texel), glm::vec2(0));
        if (frame > 0) {
            EXPECT_NE(seen_[frame].at("hdr"), seen_[frame - 1].at("hdr")) << frame;
        }
    }
}

TEST_F(AntiAliasing, EndsAtTheMeanOfItsFramesWhereHistoryIsTrusted) {
    ASSERT_NO_FATAL_FAILURE(run(100));
    const Image& resolved = seen_.back().at("resolved");
    const double worst = worst_between(resolved, mean_), single = worst_between(seen_[0].at("hdr"), mean_);
    std::printf("off the mean of %u frames by at most %.5f, a single frame by %.3f\n", kFrames, worst,
                single);
    // The colour of each frame and the blended colours are rounded to half floats. A rounding changes a
    // channel by at most 1/2048 of it, and the compressed channel by a quarter of this. Frame k of n keeps
    // k/n of its rounding in the mean.
    const double roundings = 1 + (kFrames + 1) / 2.0;
    EXPECT_LT(worst, roundings * 0.25 / 2048);
    EXPECT_GT(single, 0.1) << "edges that need no smoothing prove nothing";
    for (const glm::vec4& texel : resolved) EXPECT_EQ(texel.a, float{kFrames});
}

TEST_F(AntiAliasing, StaysCloseToTheMeanAsItIsShipped) {
    ASSERT_NO_FATAL_FAILURE(run(shipped("modules/taa").at("params").at("trust").at("default").get<double>()));
    const double smooth = rms_between(seen_.back().at("resolved"), mean_),
                 single = rms_between(seen_[0].at("hdr"), mean_);
    std::printf("off the mean by %.5f rms, a single frame by %.5f\n", smooth, single);
    EXPECT_LT(smooth, single / 5);
}

// Computes one step of the Gray-Scott reaction on a grid that wraps around, with Pearson's equations and
// Sims's Laplacian weights (0.2 and 0.05). A cell is (u, v). The feed rate varies by ±`drift` along x.
// The kill rate changes with the feed rate, and also along y.
std::vector<glm::dvec2> react(const std::vector<glm::dvec2>& cells, int width, int height, double feed,
                              double kill, double drift) {
    const auto border = [](double f) { return 0.5 * std::sqrt(f) - f; };
    std::vector<glm::dvec2> next(cells.size());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            glm::dvec2 spread(0);
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const double weight = dx == 0 && dy == 0 ? -1 : dx == 0 || dy == 0 ? 0.2 : 0.05;
                    const int at = (y + dy + height) % height * width + (x + dx + width) % width;
                    spread += weight * cells[static_cast<size_t>(at)];
                }
            const double aside = std::abs(2 * (x + 0.5) / width - 1),
                         above = std::abs(2 * (y + 0.5) / height - 1);
            const double f = feed + drift * (2 * aside - 1);
            const double k = kill + border(f) - border(feed) + 0.05 * drift * (1 - 2 * above);
            const size_t i = static_cast<size_t>(y * width + x);
            const double u = cells[i].x, v = cells[i].y, eaten = u * v * v;
            next[i] = {u + spread.x - eaten + f * (1 - u), v + 0.5 * spread.y + eaten - (f + k) * v};
        }
    }
    return next;
}

TEST_F(ShippedEffects, TheReactionIsGrayAndScotts) {
    constexpr int kWidth = 120, kHeight = 60, kSteps = 40, kFrames = 3;
    Json graph = shipped("reaction_diffusion");
    graph["resources"]["cells"]["size"] = {kWidth, kHeight};
    graph["passes"]["step"]["threads"] = {kWidth / 2, kHeight / 2};
    graph["params"]["steps"]["default"] = kSteps;
    const auto seen = frames(graph, graph_path("reaction_diffusion"), {32, 18, 1}, kFrames, {"cells"});
    ASSERT_EQ(seen.size(), size_t{kFrames});
    const auto number = [&](const char* name) { return graph["params"][name]["default"].get<double>(); };
    const size_t cells = size_t{kWidth} * kHeight;
    const auto state = [&](int frame) {
        const Image& both = seen[static_cast<size_t>(frame)].at("cells");
        std::vector<glm::dvec2> first;
        for (size_t i = 0; i < cells; ++i) first.emplace_back(both[i].x, both[i].y);
        return first;
    };
    for (int frame = 1; frame < kFrames; ++frame) {
        std::vector<glm::dvec2> wanted = state(frame - 1);
        for (int i = 0; i < kSteps; ++i)
            wanted = react(wanted, kWidth, kHeight, number("feed"), number("kill"), number("drift"));
        const std::vector<glm::dvec2> found = state(frame);
        double worst = 0, moved = 0;
        for (size_t i = 0; i < cells; ++i) {
            worst = std::max({worst, std::abs(found[i].x - wanted[i].x), std::abs(found[i].y - wanted[i].y)});
            moved = std::max(moved, std::abs(found[i].y - state(frame - 1)[i].y));
        }
        std::printf("frame %d: %.1e off after %d steps, in which a cell changed by %.2f\n", frame, worst,
                    kSteps, moved);
        EXPECT_LT(worst, 1e-4);
        EXPECT_GT(moved, 0.05) << "a dead dish proves nothing";
    }
}

}  // namespace
}  // namespace weft::test
