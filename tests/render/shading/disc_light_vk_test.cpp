// Tests directional lights with an angular radius: disc_light.glsl against sums over the disc in double
// precision, and the lights of a session.
#include <algorithm>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_disc.h"

namespace weft::test {
namespace {

constexpr const char* kDiscGraph = WEFT_SOURCE_DIR "/tests/render/disc/disc.json";

// A case of disc.comp, in double precision.
struct DiscCase {
    double roughness, radius_rad;
    glm::dvec3 v, l;
};

DiscCase disc_case(size_t row, size_t column) {
    constexpr std::array kRoughness{0.05, 0.1, 0.2, 0.4, 0.6};
    constexpr std::array kEye_deg{0.0, 40.0, 60.0, 75.0}, kRadius_deg{0.27, 1.0, 2.0, 4.0};
    DiscCase c{kRoughness[row % 5], glm::radians(kRadius_deg[row / 20]), {}, {}};
    const double eye = glm::radians(kEye_deg[row / 5 % 4]);
    c.v = {std::sin(eye), std::cos(eye), 0};
    const double angle = double(column / 4) * 0.25 * std::hypot(c.radius_rad, 2 * c.roughness * c.roughness),
                 turn = double(column % 4) * kPi / 2 + 0.2 * double(column / 4);
    c.l = glm::dvec3(-c.v.x, c.v.y, 0) * std::cos(angle) +
          (glm::dvec3(c.v.y, c.v.x, 0) * std::cos(turn) + glm::dvec3(0, 0, 1) * std::sin(turn)) *
              std::sin(angle);
    return c;
}

class DiscLight : public SessionTest {};

TEST_F(DiscLight, ReflectsTheIntegralOverTheDisc) {
    const std::unique_ptr<render::Session> session = start(kDiscGraph, {16, 16, 1}, {"reflected"});
    ASSERT_TRUE(session && draw_frame(*session) && session->finish());
    const std::vector<vk::ReadbackData> read = session->take_readbacks();
    ASSERT_EQ(read.size(), 1u);
    const std::vector<glm::vec4> found = render::decode_texels(read[0].format, read[0].bytes);
    ASSERT_EQ(found.size(), 36u * 80);
    double most = 0, most_narrow = 0;
    for (size_t row = 0; row < 80; ++row) {
        double peak = 0;
        for (size_t column = 0; column < 36; ++column) {
            const DiscCase c = disc_case(row, column);
            if (c.l.y <= std::sin(c.radius_rad)) continue;  // The horizon cuts the disc.
            const double wanted =
                reference_disc(
                    {.base_color = glm::dvec3(0.9, 0.5, 0.1), .metallic = 1, .roughness = c.roughness}, c.v,
                    c.l, c.radius_rad)
                    .r;
            peak = std::max(peak, wanted);
            const glm::vec4& texel = found[row * 36 + column];
            // Relative where the highlight is bright; elsewhere an error of 5 % of the tenth of its middle is
            // allowed.
            const double error = (texel.r - wanted) / std::max(wanted, peak * 0.1);
            EXPECT_NEAR(error, 0, 0.05)
                << "row " << row << " column " << column << ": " << texel.r << " for " << wanted;
            EXPECT_NEAR(texel.b / texel.r, 1, 2e-3) << "row " << row << " column " << column;
            EXPECT_NEAR(texel.a, 1, 2e-3) << "row " << row << " column " << column;
            most = std::max(most, std::abs(error));
            most_narrow = std::max(most_narrow, row < 60 ? std::abs(error) : 0);
        }
    }
    std::printf("largest error: %.2f %%, for radii up to 2 degrees %.2f %%\n", most * 100, most_narrow * 100);
}

}  // namespace
}  // namespace weft::test
