// Tests how the stages of one program are linked: they get matching location numbers, and declarations that
// do not match give messages.
#include <gtest/gtest.h>

#include <map>

#include "shader/reflect/reflect_stage.h"
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

class Link : public ShaderFolder {};

constexpr const char* kOneOutput = R"(#version 460
layout(location = 0) out vec3 normal;
void main() { normal = vec3(1); gl_Position = vec4(0); }
)";

TEST_F(Link, ports_shared_by_two_stages_get_one_binding) {
    write("graph/two/two.vert", R"(#version 460
uniform sampler2D zebra;
readonly buffer Middle { float m[]; } middle;
layout(push_constant) uniform Params { float k; };
void main() { gl_Position = texture(zebra, vec2(k)) * middle.m[gl_VertexIndex]; }
)");
    write("graph/two/two.frag", R"(#version 460
uniform sampler2D apple;
uniform sampler2D zebra;
layout(push_constant) uniform Params { float k; };
out vec4 color;
void main() { color = texture(apple, vec2(k)) + texture(zebra, vec2(0)); }
)");
    const ShaderInterface interface = program("two", ProgramKind::raster).interface;
    const ShaderStageMask both = stage_bit(ShaderStage::vertex) | stage_bit(ShaderStage::fragment);
    EXPECT_EQ(interface.find("apple")->binding, 0u);
    EXPECT_EQ(interface.find("apple")->stages, stage_bit(ShaderStage::fragment));
    EXPECT_EQ(interface.find("middle")->binding, 1u);
    EXPECT_EQ(interface.find("zebra")->binding, 2u);
    EXPECT_EQ(interface.find("zebra")->stages, both);
    EXPECT_EQ(interface.params.stages, both);
}

TEST_F(Link, unused_declarations_do_not_disturb_the_numbers) {
    write("graph/a.comp", R"(#version 460
layout(local_size_x = 1) in;
uniform sampler2D aUnused;
uniform sampler2D b;
layout(rgba8) uniform writeonly image2D c;
void main() { imageStore(c, ivec2(0), texture(b, vec2(0))); }
)");
    const ShaderInterface interface = program("a.comp", ProgramKind::compute).interface;
    ASSERT_EQ(interface.bindings.size(), 2u);
    EXPECT_EQ(interface.find("b")->binding, 0u);
    EXPECT_EQ(interface.find("c")->binding, 1u);
}

TEST_F(Link, inputs_without_a_location_are_joined_by_name) {
    write("graph/j/j.vert", R"(#version 460
out vec3 zNormal;
layout(location = 1) out vec2 placed;
out mat2 aMatrix;
void main() { zNormal = vec3(1); placed = vec2(1); aMatrix = mat2(1); gl_Position = vec4(0); }
)");
    write("graph/j/j.frag", R"(#version 460
in mat2 aMatrix;
in vec3 zNormal;
layout(location = 1) in vec2 anyName;
out vec4 color;
void main() { color = vec4(zNormal + vec3(aMatrix[0], 0), anyName.x); }
)");
    const ShaderProgram joined = program("j", ProgramKind::raster);
    ASSERT_EQ(joined.modules.size(), 2u);
    shader::InterfaceFaults faults;
    const auto locations = [&](const std::vector<shader::ReflectedVariable>& variables) {
        std::map<std::string, uint32_t> found;
        for (const auto& variable : variables) found[variable.variable.name] = variable.variable.location;
        return found;
    };
    // The matrix needs two consecutive locations, and the shader declares location 1 for `placed`. So the
    // matrix gets the locations 2 and 3.
    const std::map<std::string, uint32_t> written{{"aMatrix", 2}, {"placed", 1}, {"zNormal", 0}};
    const std::map<std::string, uint32_t> read{{"aMatrix", 2}, {"anyName", 1}, {"zNormal", 0}};
    EXPECT_EQ(locations(shader::reflect_stage(ShaderStage::vertex, joined.modules[0].spirv, faults).outputs),
              written);
    EXPECT_EQ(locations(shader::reflect_stage(ShaderStage::fragment, joined.modules[1].spirv, faults).inputs),
              read);
    EXPECT_TRUE(faults.empty());
}

TEST_F(Link, a_port_declared_in_two_ways_is_refused) {
    write("graph/p/p.vert", R"(#version 460
uniform sampler2D port;
void main() { gl_Position = texture(port, vec2(0)); }
)");
    write("graph/p/p.frag", R"(#version 460
uniform sampler3D port;
out vec4 color;
void main() { color = texture(port, vec3(0)); }
)");
    const Diagnostics found = errors("p", ProgramKind::raster);
    EXPECT_EQ(found.at(0).code, "W205");
    EXPECT_NE(found.at(0).message.find("\"port\""), std::string::npos);
    EXPECT_EQ(found.at(0).file, (base_ / "graph/p/p.frag").string());
    EXPECT_EQ(found.at(0).line, 2u);
    EXPECT_EQ(found.at(0).column, 19u);
}

TEST_F(Link, an_input_that_nothing_writes_is_refused_with_its_place) {
    write("graph/n/n.vert", kOneOutput);
    // The error must point at the declaration of uv in line 4, not at the comments with "uv" above it.
    write("graph/n/n.frag", R"(#version 460  // uv;
/* reads uv; */
layout(location = 0) in vec3 normal;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() { color = vec4(normal, uv.x); }
)");
    const Diagnostics found = errors("n", ProgramKind::raster);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].code, "W205");
    EXPECT_EQ(found[0].line, 4u);
    EXPECT_NE(found[0].message.find("vec2 uv at location 1"), std::string::npos);
    EXPECT_NE(found[0].help.at(0).find("vec3 normal at location 0"), std::string::npos);
}

TEST_F(Link, an_input_of_another_type_is_refused) {
    write("graph/t/t.vert", kOneOutput);
    write("graph/t/t.frag", R"(#version 460
layout(location = 0) in vec2 normal;
layout(location = 0) out vec4 color;
void main() { color = vec4(normal, 0, 1); }
)");
    const Diagnostics found = errors("t", ProgramKind::raster);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].code, "W205");
    EXPECT_NE(found[0].message.find("vec2 normal"), std::string::npos);
    EXPECT_NE(found[0].message.find("vec3 normal"), std::string::npos);
}

TEST_F(Link, an_unplaced_input_without_a_namesake_is_refused) {
    write("graph/effect.frag", R"(#version 460
in vec2 texcoord;
out vec4 color;
void main() { color = vec4(texcoord, 0, 1); }
)");
    const Diagnostics found = errors("effect.frag", ProgramKind::fullscreen);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].code, "W205");
    EXPECT_NE(found[0].message.find("\"texcoord\""), std::string::npos);
    EXPECT_NE(found[0].help.at(0).find("vec2 uv at location 0"), std::string::npos);
}

TEST_F(Link, specialisation_constants_must_agree) {
    write("graph/s/s.vert", R"(#version 460
layout(constant_id = 0) const int A = 1;
void main() { gl_Position = vec4(A); }
)");
    write("graph/s/s.frag", R"(#version 460
layout(constant_id = 0) const int B = 1;
out vec4 color;
void main() { color = vec4(B); }
)");
    EXPECT_EQ(errors("s", ProgramKind::raster).at(0).code, "W205");
}

TEST_F(Link, what_no_pass_can_offer_is_refused) {
    write("graph/f.comp", R"(#version 460
layout(local_size_x = 1) in;
uniform texture2D lonelyTexture;
uniform sampler lonelySampler;
layout(push_constant) uniform Constants { float k; };
layout(set = 9, binding = 0) uniform sampler2D far;
layout(rgba8) uniform writeonly image2D c;
void main() { imageStore(c, ivec2(0), k * texture(sampler2D(lonelyTexture, lonelySampler), vec2(0)) + texture(far, vec2(0))); }
)");
    const Diagnostics found = errors("f.comp", ProgramKind::compute);
    EXPECT_EQ(found.size(), 4u) << to_text(found);
    for (const Diagnostic& diagnostic : found) {
        EXPECT_EQ(diagnostic.code, "W206");
        EXPECT_GT(diagnostic.line, 0u);
        EXPECT_FALSE(diagnostic.help.empty());
    }
}

}  // namespace
}  // namespace weft
