// Tests --import with the program: graphs with imports of another program are checked without this program.
#include <gtest/gtest.h>

#include "tests/viewer/program.h"
#include "viewer/options/import_texts.h"

namespace weft::test {
namespace {

constexpr const char* kPropsGraph = R"j({
  "version": 1, "name": "props",
  "imports": { "props": "drawlist", "paint": "image", "weights": "buffer", "pictures": "textures", "portals": "views",
               "backbuffer": "output" },
  "resources": { "seen": { "format": "rgba8", "size": [16, 16] }, "sum": "rgba8" },
  "passes": {
    "props":  { "type": "raster", "draws": ["props"], "view": "portals(1)", "shader": "props", "out": { "color": "seen" } },
    "sum":    { "type": "compute", "shader": "sum.comp", "in": ["paint", "weights", "seen"], "out": ["sum"] },
    "show":   { "type": "blit", "in": ["sum"], "out": ["backbuffer"] }
  }
})j";
constexpr const char* kPropsVertex = R"(#version 460
#include "frame_set.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 tint;
layout(set = 3, binding = 4, std430) readonly buffer Props { mat4 to_world[]; };
layout(location = 0) out vec4 color_of_vertex;
void main() {
    color_of_vertex = tint;
    gl_Position = view.view_projection * to_world[gl_InstanceIndex] * vec4(position, 1);
}
)";
constexpr const char* kPropsFragment = R"(#version 460
layout(location = 0) in vec4 color_of_vertex;
layout(location = 0) out vec4 color;
void main() { color = color_of_vertex; }
)";
constexpr const char* kSumShader = R"(#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D paint;
uniform sampler2D seen;
readonly buffer Weights { float items[]; } weights;
writeonly uniform image2D sum;
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(sum, at, texelFetch(paint, at % 4, 0) * weights.items[0] + texelFetch(seen, at % 16, 0));
}
)";

class ImportOption : public testing::Test {
 protected:
    ImportOption() {
        scratch_.write("g.json", kPropsGraph);
        scratch_.write("props/props.vert", kPropsVertex);
        scratch_.write("props/props.frag", kPropsFragment);
        scratch_.write("sum.comp", kSumShader);
    }
    RunResult run(std::vector<std::string> words, const std::vector<std::string>& imports) const {
        for (const std::string& import : imports) words.insert(words.end(), {"--import", import});
        return run_weft(words, {}, scratch_.path());
    }

    ScratchFolder scratch_;
    const std::vector<std::string> all_{"props=drawlist:position,tint", "paint=image:rgba8:4x4",
                                        "weights=buffer:16", "pictures=textures:2", "portals=views:2"};
};

TEST_F(ImportOption, AGraphOfAProgramIsCheckedAndPlanned) {
    const RunResult checked = run({"check", "g.json"}, all_);
    EXPECT_EQ(checked.exit_code, 0) << checked.text();
    const RunResult plan = run({"plan", "g.json"}, all_);
    EXPECT_EQ(plan.exit_code, 0) << plan.text();
    EXPECT_NE(plan.out.find("weights"), std::string::npos) << plan.out;
    const RunResult boxed = run({"check", "g.json", "--sandbox"}, all_);
    if (boxed.err.find("X595") == std::string::npos) {
        EXPECT_EQ(boxed.exit_code, 0) << boxed.text();
    }
    const RunResult unknown = run({"check", "g.json"}, {});
    EXPECT_EQ(unknown.exit_code, 3) << unknown.text();
    EXPECT_NE(unknown.err.find("as a draw list: --import props="), std::string::npos) << unknown.text();
}

TEST_F(ImportOption, TheAttributesOfADrawListAreChecked) {
    std::vector<std::string> imports = all_;
    imports.front() = "props=drawlist:position,tnit";
    const RunResult wrong = run({"check", "g.json"}, imports);
    EXPECT_EQ(wrong.exit_code, 3) << wrong.text();
    EXPECT_NE(wrong.err.find("error[W167]"), std::string::npos) << wrong.text();
    EXPECT_NE(wrong.err.find("did you mean \"tnit\""), std::string::npos) << wrong.text();
}

TEST_F(ImportOption, TheNumberOfViewsIsChecked) {
    std::vector<std::string> imports = all_;
    imports.back() = "portals=views:1";
    const RunResult wrong = run({"check", "g.json"}, imports);
    EXPECT_EQ(wrong.exit_code, 3) << wrong.text();
    EXPECT_NE(wrong.err.find("portals(1)"), std::string::npos) << wrong.text();
}

TEST(ImportTexts, FaultsNameTheWantedForm) {
    for (const char* good :
         {"a=drawlist:position", "a=views:1", "a=textures:4", "a=image:rgba16f:1x1", "a=buffer:4294967296"})
        EXPECT_EQ(viewer::import_fault(good), "") << good;
    for (const char* bad : {"", "a", "a=drawlist", "=drawlist:p", "a=drawlist:", "a=drawlist:p,", "a=lists:p",
                            "a=views:0", "a=views:x", "a=textures:-1", "a=image:rgba8", "a=image:rgb32f:4x4",
                            "a=image:rgba8:0x4", "a=buffer:0"})
        EXPECT_NE(viewer::import_fault(bad), "") << bad;
    EXPECT_NE(viewer::import_fault("a=image:rgba8u8:4x4").find("did you mean"), std::string::npos);
}

}  // namespace
}  // namespace weft::test
