// Tests the debug views of depth images: they show the distance in metres from the viewpoint of the view that
// was drawn. Each graph also draws the distance itself, and a debug view with its own shader shows it with
// the same greys.
#include <gtest/gtest.h>

#include "tests/viewer/pictures/pfm_image.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kVertex = R"(#version 460
#include "frame_set.glsl"
#include "shared/instance.glsl"
layout(location = 0) in vec4 position;
layout(set = 3, binding = 0, std430) readonly buffer Instances { Instance instances[]; };
layout(location = 0) out float distance_m;
void main() {
    const vec4 world = instances[gl_InstanceIndex].object_to_world * vec4(position.xyz, 1.0);
    // The distance of a parallel projection begins at its near plane, where depth is 1.
    const mat4 p = view.projection;
    distance_m = -(view.view * world).z - (p[2][3] == 0.0 ? (p[3][2] - 1.0) / p[2][2] : 0.0);
    gl_Position = view.view_projection * world;
}
)";

constexpr const char* kFragment = R"(#version 460
layout(location = 0) in float distance_m;
layout(location = 0) out float far;
void main() { far = distance_m; }
)";

// Black: nothing was drawn.
constexpr const char* kGreys = R"(#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D shown;
void main() {
    const float far = textureLod(shown, uv, 0.0).r;
    color = vec4(vec3(far > 0.0 ? 1.0 - log2(1.0 + far) / 6.0 : 0.0), 1.0);
}
)";

class DebugDepth : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        folder_.write("far/far.vert", kVertex);
        folder_.write("far/far.frag", kFragment);
        folder_.write("greys.frag", kGreys);
    }

    // Draws the depth and the distance by a pass with the keys `keys` to images with the keys `image`, and
    // compares their debug views. `part` is the layer that is shown.
    void compare(const std::string& keys, const std::string& image, const std::string& part,
                 const std::string& scene = "builtin:spheres") {
        folder_.write("g.json",
                      R"({ "version": 1, "imports": { "opaque": "drawlist", "backbuffer": "output" },
  "views": { "floor": { "of": "camera", "plane": [0, 1, 0, 0.5] },
             "probe": { "cube": { "at": [0.1, 1.2, 0], "near": 0.3 } } },
  "resources": { "depth": { "format": "d32f", )" +
                          image + R"( }, "far": { "format": "r32f", )" + image + R"( } },
  "passes": {
    "draw": { "type": "raster", )" +
                          keys +
                          R"(, "draws": ["opaque"], "shader": "far", "state": { "cull": "none" } },
    "end": { "type": "clear", "out": ["backbuffer"] } },
  "debug": { "Depth": "depth)" +
                          part + R"(", "Far": { "show": "far)" + part +
                          R"(", "shader": "greys.frag" } } }
)");
        const PfmImage depth = picture("Depth", scene), far = picture("Far", scene);
        ASSERT_EQ(depth.texels.size(), 128u * 72);
        ASSERT_EQ(far.texels.size(), depth.texels.size());
        size_t drawn = 0;
        for (uint32_t y = 0; y < 72; ++y)
            for (uint32_t x = 0; x < 128; ++x) {
                if (far.at(x, y)[0] == 0) continue;
                ++drawn;
                ASSERT_NEAR(depth.at(x, y)[0], far.at(x, y)[0], 0.01) << x << ", " << y;
            }
        EXPECT_GT(drawn, 400u);
    }

 private:
    // The picture is too small for a legend.
    PfmImage picture(const std::string& view, const std::string& scene) const {
        const RunResult run = run_weft({"render", scene, "--graph", folder_ / "g.json", "--size", "128x72",
                                        "--debug", view, "--output", folder_ / "view.pfm", "--validate"});
        EXPECT_EQ(run.exit_code, 0) << run.text();
        return read_pfm(folder_ / "view.pfm").value_or(PfmImage{});
    }

    ScratchFolder folder_;
};

TEST_F(DebugDepth, OfTheCameraIsItsDistance) {
    compare(R"("out": { "far": "far" }, "depth": "depth")", R"("size": "output")", "");
}

TEST_F(DebugDepth, OfAMirrorIsTheDistanceFromTheMirroredCamera) {
    compare(R"("view": "floor", "out": { "far": "far" }, "depth": "depth")", R"("size": "output")", "");
}

TEST_F(DebugDepth, OfALayerIsTheDistanceOfTheViewWithItsNumber) {
    compare(R"("views": "probe", "out": { "far": "far" }, "depth": "depth")",
            R"("size": 64, "kind": "array", "layers": 8)", ".layer(3)");
}

TEST_F(DebugDepth, OfARepeatIsTheDistanceOfTheViewOfTheLayer) {
    compare(R"json("repeat": { "i": "0..3" }, "view": "sun(i)", "out": { "far": "far.layer(i)" },
                "depth": "depth.layer(i)")json",
            R"("size": 64, "kind": "array", "layers": 4)", ".layer(2)", "builtin:atrium");
}

}  // namespace
}  // namespace weft::test
