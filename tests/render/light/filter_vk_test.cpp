// Tests how well the module environment.json filters surroundings with 32 samples, and how well spherical
// harmonics give diffuse light. References are sums over many directions in double precision.
#include "tests/render/light/centres_fixture.h"
#include "tests/render/light/reference_sky.h"

namespace weft::test {
namespace {

// Largest allowed errors in percent of the root of the mean square of the light.
struct Allowed {
    std::array<double, 5> rms{}, most{};
};

struct FairCase {
    const char* name;
    FilterSettings settings;
    Allowed allowed;
};

// 32 samples for each roughness: the passes take twice as many samples for the roughnesses 0.2 and 0.4, and
// four times as many for 0.6 and 0.8. The light of the roughness 1 does not come from samples.
FilterSettings thirty_two_samples(const char* lod_bias) {
    return {lod_bias, {16, 8}, {0, 0, 1, 1, 1}};
}

class FairFilter : public CentreTest {
 protected:
    void expect_errors(const char* surroundings, const Surroundings& light,
                       const std::vector<FairCase>& cases) {
        const CentreLight expected = references(light);
        const scene::Environment picture = picture_of(light);
        for (const FairCase& fair : cases) {
            const CentreLight found = filter(picture, fair.settings);
            std::printf("%s, %s: RMS / largest in %%:", surroundings, fair.name);
            for (size_t i = 0; i < expected.size(); ++i) {
                ASSERT_EQ(found[i].size(), kCentres);
                const CentreErrors e = centre_errors(found[i], expected[i], root_mean_square(expected[i]));
                std::printf("  %.2f / %.2f", e.rms, e.most);
                EXPECT_LE(e.rms, fair.allowed.rms[i]) << fair.name << ", roughness " << kCentreRoughness[i];
                EXPECT_LE(e.most, fair.allowed.most[i]) << fair.name << ", roughness " << kCentreRoughness[i];
            }
            std::printf("\n");
        }
    }
};

TEST_F(FairFilter, AClearSky) {
    const SkyLuminance sky;
    const Surroundings light = [&](const glm::dvec3& d) { return 30 * sky(d); };
    const Allowed sharp{{1, 1.2, 1.5, 2.2, 0.56}, {7, 7, 7, 9, 2.55}};
    expect_errors("clear sky", light,
                  {{"default", {}, sharp},
                   {"32 samples, bias 0", thirty_two_samples("0"), {{2, 2, 3, 4, 0.56}, {7, 7, 7, 9, 2.55}}},
                   {"32 samples, bias -1", thirty_two_samples("-1"), sharp}});
}
TEST_F(FairFilter, AHalfWhiteSphere) {
    const Allowed half{{2, 2.5, 3.5, 5, 0.05}, {5, 5, 5, 9, 0.1}};
    expect_errors("half", half_sky,
                  {{"default", {}, half},
                   {"32 samples, bias 0", thirty_two_samples("0"), half},
                   {"32 samples, bias -1", thirty_two_samples("-1"), half}});
}
// A spot of 5° is 1000 times as bright as the rest. Pictures of --env do not contain such spots, because they
// become lights. Without that, single texels are far too bright.
TEST_F(FairFilter, ASpot) {
    expect_errors("spot", spot_sky, {{"default", {}, {{14, 10, 19, 14, 4.7}, {520, 100, 160, 100, 11}}}});
}

// An overcast sky over black and over grey ground. Errors of the diffuse light in percent of its mean, over
// all normals. The smallest possible errors of nine terms are 0.26 and 1.0, and 0.20 and 0.77.
TEST_F(CentreTest, DiffuseLightOfAnOvercastSkyIsAsCloseAsNineTermsCanBe) {
    for (const double ground : {0.0, 0.2}) {
        const Surroundings sky = [&](const glm::dvec3& d) { return d.y > 0 ? (1 + 2 * d.y) / 3 : ground; };
        const std::vector<double> expected = reference(cube_sum(sky), 1);
        const CentreLight found = filter(picture_of(sky));
        ASSERT_EQ(found[4].size(), kCentres);
        const CentreErrors e = centre_errors(found[4], expected, mean_of(expected));
        std::printf("ground %.1f: RMS %.3f %%, largest %.3f %%\n", ground, e.rms, e.most);
        EXPECT_LE(e.rms, ground > 0 ? 0.22 : 0.28);
        EXPECT_LE(e.most, ground > 0 ? 0.85 : 1.1);
    }
}

}  // namespace
}  // namespace weft::test
