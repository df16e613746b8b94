// Purpose: test fixture that renders pictures of known luminances and reads the state of the automatic
// exposure.
#pragma once

#include <cmath>
#include <cstring>

#include "tests/render/session_fixture.h"

namespace weft::test {

// The first members of AdaptationState in shaders/exposure/adaptation.glsl.
struct Adaptation {
    float exposure_ev = 0;
    float adapted_ev = 0;
    float metered_ev = 0;
    float adapted = 0;
};

class ExposureTest : public SessionTest {
 protected:
    static constexpr Extent3D kPicture{320, 180, 1};
    // Hdr of the test picture stores values × 2^kStored_ev, so that 10⁶ cd/m² is a finite half float.
    static constexpr float kStored_ev = -6;
    // Half of the width of a bin of the histogram, W / 2n: what the histogram may add to a metered EV; and
    // the rounding of half floats.
    static constexpr double kBound_ev = 32.0 / (2 * 256) + 1e-3;

    static std::string meter_graph() { return WEFT_SOURCE_DIR "/tests/render/exposure/meter.json"; }

    std::unique_ptr<render::Session> start_meter(std::vector<std::string> observed = {"adaptation"}) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        return start(*scene, scene->cameras.at(0), meter_graph(), kPicture, std::move(observed), kStored_ev);
    }
    // Renders a frame with the given parameters and returns the state after it.
    static Adaptation after_frame(render::Session& session, const render::ParameterValues& values,
                                  double delta_time_s = 0) {
        for (const auto& [name, value] : values) frame_of(session).parameters[name] = value;
        const Status drawn = draw_frame(session, 0, delta_time_s);
        EXPECT_TRUE(drawn) << to_text(drawn.errors());
        EXPECT_TRUE(session.finish());
        return adaptation_of(session.take_readbacks());
    }
    static Adaptation adaptation_of(const std::vector<vk::ReadbackData>& readbacks) {
        Adaptation state;
        for (const vk::ReadbackData& data : readbacks)
            if (data.pass == "observe:adaptation" && data.bytes.size() >= sizeof state)
                std::memcpy(&state, data.bytes.data(), sizeof state);
        return state;
    }
    // The first byte of the picture for a value before the tone curve (shaders/include/srgb.glsl).
    static int shown(double x) {
        const double y = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
        return static_cast<int>(std::lround(255 * (1.055 * std::pow(y, 1 / 2.4) - 0.055)));
    }
    static std::vector<std::byte> output_of(render::Session& session) {
        EXPECT_TRUE(session.finish());
        Result<vk::ReadbackData> output = session.read_output();
        EXPECT_TRUE(output);
        return output ? std::move(output->bytes) : std::vector<std::byte>();
    }
};

}  // namespace weft::test
