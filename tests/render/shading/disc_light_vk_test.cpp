// Tests directional lights with an angular radius: disc_light.glsl against sums over the disc in double
// precision, and the lights of a session.
#include <algorithm>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_brdf.h"

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

// Returns ∫ BRDF · n·l dω over the disc, divided by the irradiance of the disc on a plane that faces it. A
// narrow lobe is integrated over half vectors that are distributed as the facets are, a wide one over the
// disc.
double reference_disc(const DiscCase& c, const ReferenceSurface& s) {
    const double alpha = c.roughness * c.roughness,
                 faced = kPi * std::sin(c.radius_rad) * std::sin(c.radius_rad);
    const bool narrow = alpha < c.radius_rad;
    const int side = narrow ? 200 : 60;
    const glm::dvec3 u = glm::normalize(
                         glm::cross(c.l, std::abs(c.l.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))),
                     w = glm::cross(c.l, u);
    double sum = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double share = (i + 0.5) / side, turn = 2 * kPi * (j + 0.25 + 0.5 * (i % 2)) / side;
            if (!narrow) {
                const double cosine = 1 - share * (1 - std::cos(c.radius_rad)),
                             sine = std::sqrt(1 - cosine * cosine);
                sum += reflected(s, c.v, cosine * c.l + sine * (std::cos(turn) * u + std::sin(turn) * w)).r *
                       2 * kPi * (1 - std::cos(c.radius_rad));
                continue;
            }
            const double slope = alpha * std::sqrt(share / (1 - share));
            const glm::dvec3 h =
                glm::normalize(glm::dvec3(slope * std::cos(turn), 1, slope * std::sin(turn)));
            const glm::dvec3 l = 2 * glm::dot(c.v, h) * h - c.v;
            if (l.y <= 0 || glm::dot(l, c.l) < std::cos(c.radius_rad)) continue;
            // The density of l for these half vectors is D · n·h / (4 v·h).
            sum += reflected(s, c.v, l).r * 4 * glm::dot(c.v, h) / (ggx(alpha, h.y) * h.y);
        }
    return sum / (side * side) / faced;
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
            const double wanted = reference_disc(
                c, {.base_color = glm::dvec3(0.9, 0.5, 0.1), .metallic = 1, .roughness = c.roughness});
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
