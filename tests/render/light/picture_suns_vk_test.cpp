// Tests a scene in the light of a picture with a sun: the sun of the picture is a light with shadows. Checks
// that the pictures are the same after a reload, after a change of the size and in another run, and that
// deferred and forward shading agree.
#include <cmath>
#include <cstring>

#include "tests/render/exposure/exposure_fixture.h"
#include "tests/render/light/sunny_spheres.h"
#include "tests/render/shading/half_steps.h"

namespace weft::test {
namespace {

constexpr Extent3D kSunnySize{160, 90, 1};

class PictureSuns : public ExposureTest {
 protected:
    void SetUp() override {
        ExposureTest::SetUp();
        scene_ = sunny_spheres();
        ASSERT_EQ(scene_.lights.size(), 1u);
        ASSERT_GT(scene_.lights[0].angular_radius_rad, 0);
    }
    std::unique_ptr<render::Session> begin(const char* graph, Extent3D size,
                                           std::vector<std::string> observed = {}, float exposure_ev = 0,
                                           const FileReader& reader = read_text) {
        return start(scene_, scene_.cameras.at(0), graph_path(graph), size, std::move(observed), exposure_ev,
                     reader);
    }
    static std::vector<std::byte> next_picture(render::Session& session) {
        const Status drawn = draw_frame(session);
        EXPECT_TRUE(drawn) << to_text(drawn.errors());
        return output_of(session);
    }

    scene::Scene scene_;
};

class SunnyGraph : public PictureSuns, public testing::WithParamInterface<const char*> {};

TEST_P(SunnyGraph, APictureStaysTheSameAfterAReloadAndAChangeOfTheSize) {
    const std::unique_ptr<render::Session> session = begin(GetParam(), kSunnySize);
    ASSERT_TRUE(session);
    const std::vector<std::byte> first = next_picture(*session);
    ASSERT_EQ(first.size(), size_t{kSunnySize.width} * kSunnySize.height * 4);
    EXPECT_TRUE(next_picture(*session) == first) << "the second frame, in which passes rest";
    render::PrepareResult prepared = session->prepare(session->selection());
    ASSERT_TRUE(prepared.result) << to_text(prepared.result.errors());
    const Result<bool> swapped = session->swap_in(std::move(*prepared.result));
    ASSERT_TRUE(swapped && *swapped);
    EXPECT_TRUE(next_picture(*session) == first) << "after a reload";
    ASSERT_TRUE(session->resize({97, 55, 1}, warnings_));
    const std::vector<std::byte> small = next_picture(*session);
    const std::unique_ptr<render::Session> other = begin(GetParam(), {97, 55, 1});
    ASSERT_TRUE(other);
    EXPECT_TRUE(next_picture(*other) == small) << "a change of the size, and a session of this size";
    ASSERT_TRUE(session->resize(kSunnySize, warnings_));
    EXPECT_TRUE(next_picture(*session) == first) << "the size of the start";
}

INSTANTIATE_TEST_SUITE_P(Graphs, SunnyGraph, testing::Values("deferred", "forward_plus"),
                         [](const auto& graph) { return std::string(graph.param); });

// Returns the half floats of `hdr`, and the exposure of the picture.
struct SunnyRun {
    std::vector<uint16_t> halves;
    float exposure_ev = 0;
};
SunnyRun run_of(const std::vector<vk::ReadbackData>& readbacks, const Adaptation& adaptation) {
    SunnyRun run;
    run.exposure_ev = adaptation.exposure_ev;
    for (const vk::ReadbackData& data : readbacks)
        if (data.pass == "observe:hdr") {
            run.halves.resize(data.bytes.size() / sizeof(uint16_t));
            std::memcpy(run.halves.data(), data.bytes.data(), data.bytes.size());
        }
    return run;
}

TEST_F(PictureSuns, ForwardShadingAgreesWithDeferredShading) {
    std::array<SunnyRun, 3> runs;
    std::array<std::vector<std::byte>, 3> outputs;
    for (size_t i = 0; i < 3; ++i) {
        const std::unique_ptr<render::Session> session =
            begin(i == 0 ? "deferred" : "forward", kSunnySize, {"hdr", "adaptation"}, 0,
                  i == 1 ? FileReader(read_quantized) : FileReader(read_text));
        ASSERT_TRUE(session);
        outputs[i] = next_picture(*session);
        const std::vector<vk::ReadbackData> readbacks = session->take_readbacks();
        runs[i] = run_of(readbacks, adaptation_of(readbacks));
        ASSERT_EQ(runs[i].halves.size(), size_t{kSunnySize.width} * kSunnySize.height * 4);
    }
    const int steps = most_half_steps("rounded as the G-buffer", runs[0].halves, runs[1].halves);
    int shown = 0;
    for (size_t i = 0; i < outputs[0].size(); ++i)
        shown = std::max(shown,
                         std::abs(std::to_integer<int>(outputs[0][i]) - std::to_integer<int>(outputs[1][i])));
    std::printf("at most %d of 255 in the picture; exposure %.4f EV deferred, %.4f EV forward\n", shown,
                runs[0].exposure_ev, runs[2].exposure_ev);
    EXPECT_LE(steps, 1);
    EXPECT_LE(shown, 1);
    EXPECT_NEAR(runs[0].exposure_ev, runs[2].exposure_ev, 0.02);
}

// 1000 times the light of the picture and its sun, with a pre-exposure of −log₂ 1000, gives the same picture,
// with a fixed and with automatic exposure.
TEST_F(PictureSuns, AThousandTimesTheLightWithLessExposureIsTheSamePicture) {
    scene::Scene bright = sunny_spheres(1000);
    std::array<std::vector<std::byte>, 2> fixed, automatic;
    for (size_t i = 0; i < 2; ++i) {
        const std::unique_ptr<render::Session> session =
            begin("deferred", kSunnySize, {}, i == 0 ? 0 : -std::log2(1000.0f));
        ASSERT_TRUE(session);
        // At night, the module darkens the picture, which depends on the light.
        frame_of(*session).parameters["nightDarkening"] = 0;
        automatic[i] = next_picture(*session);
        frame_of(*session).parameters["autoExposure"] = 0;
        fixed[i] = next_picture(*session);
        std::swap(scene_, bright);
    }
    int worst = 0;
    for (const auto& pair : {fixed, automatic}) {
        ASSERT_EQ(pair[0].size(), pair[1].size());
        for (size_t k = 0; k < pair[0].size(); ++k)
            worst = std::max(worst,
                             std::abs(std::to_integer<int>(pair[0][k]) - std::to_integer<int>(pair[1][k])));
    }
    std::printf("1000 times the light: at most %d of 255\n", worst);
    EXPECT_FALSE(fixed[0] == automatic[0]);
    EXPECT_LE(worst, 2);
}

}  // namespace
}  // namespace weft::test
