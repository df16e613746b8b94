// Tests that resolve() refuses pipeline state that the device does not support, and accepts pipeline state
// that every device supports.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolvePassState : public ResolveTest {
 protected:
    ResolvePassState() { shaders["s"] = fragment({"color"}); }

    // Returns a graph with one drawing pass. The pipeline state of the pass is on line 5 of the text, so the
    // tests expect the errors on line 5.
    static std::string drawing(const std::string& state, const std::string& type = "raster") {
        const std::string draws = type == "raster" ? R"j("draws": ["opaque"], )j" : "";
        return "\n\"imports\": {\"opaque\": \"drawlist\", \"backbuffer\": \"output\"},\n\"passes\": {\n" +
               ("\"p\": {\"type\": \"" + type + "\", " + draws) +
               "\"shader\": \"s\", \"out\": {\"color\": \"backbuffer\"}, \"state\": {\n" + state + "}}}";
    }
};

struct NeededState {
    const char* name;
    const char* text;
    bool DeviceProfile::*ability;
    // Text that the error message must contain.
    const char* asked;
    const char* help;
    uint32_t column;
};
void PrintTo(const NeededState& state, std::ostream* out) {
    *out << state.text;
}

class ResolveNeededState : public ResolvePassState, public testing::WithParamInterface<NeededState> {};

TEST_P(ResolveNeededState, IsRefusedWhereTheDeviceCantDoIt) {
    const NeededState& state = GetParam();
    shaders["s"].interface.writes_point_size = true;
    for (const char* type : {"raster", "fullscreen"}) {
        profile.*state.ability = true;
        good(drawing(state.text, type));
        profile.*state.ability = false;
        const Diagnostic error = bad(drawing(state.text, type));
        EXPECT_EQ(error.code, "W187");
        EXPECT_EQ(error.line, 5u);
        EXPECT_EQ(error.column, state.column);
        EXPECT_NE(error.message.find(state.asked), std::string::npos) << error.message;
        expect_help(error, state.help);
    }
}

constexpr NeededState kNeeded[]{
    {"Lines", R"j("fill": "line")j", &DeviceProfile::non_solid_fill, "\"fill\": \"line\"", "topology", 9},
    {"Points", R"j("fill": "point")j", &DeviceProfile::non_solid_fill, "\"fill\": \"point\"", "topology", 9},
    {"DepthClamp", R"j("depthClamp": true)j", &DeviceProfile::depth_clamp, "\"depthClamp\": true",
     "gl_Position.z", 15},
    {"BiasClamp", R"j("depthBias": {"slope": 1, "clamp": 0.5})j", &DeviceProfile::depth_bias_clamp,
     "\"clamp\" of \"depthBias\"", "\"slope\"", 36},
    {"BiasClampInWords", R"j("depthBias": {"slope": 1, "clamp": "1 / 2"})j", &DeviceProfile::depth_bias_clamp,
     "\"clamp\" of \"depthBias\"", "\"slope\"", 36},
};
INSTANTIATE_TEST_SUITE_P(All, ResolveNeededState, testing::ValuesIn(kNeeded),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(ResolvePassState, NothingIsAskedForByWhatEachDeviceDoes) {
    profile.non_solid_fill = profile.depth_clamp = profile.depth_bias_clamp = false;
    good(drawing(R"j("fill": "fill", "depthClamp": false, "depthBias": {"slope": 1, "clamp": "1 - 1"})j"));
}

}  // namespace
}  // namespace weft::test
