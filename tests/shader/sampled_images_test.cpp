// Tests which images count as sampled at texture coordinates.
#include "shader/reflect/sampled_images.h"
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

class SampledImages : public ShaderFolder {
 protected:
    // Returns the names of the sampled images of a fragment shader, with spaces between them.
    std::string found(const std::string& main, const std::string& functions = "") {
        write("graph/a.frag",
              "#version 460\nlayout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 color;\n"
              "uniform sampler2D a, b, many[2];\nuniform sampler2DShadow c;\n" +
                  functions + "\nvoid main() {\n" + main + "\n}\n");
        const ShaderProgram compiled = program("a.frag", ProgramKind::fullscreen);
        std::string names;
        for (const ShaderModule& module : compiled.modules)
            for (const std::string& name : shader::sampled_images(module.spirv))
                names += (names.empty() ? "" : " ") + name;
        return names;
    }
};

TEST_F(SampledImages, AllFunctionsWithCoordinatesCount) {
    EXPECT_EQ(found("color = texture(a, uv);"), "a");
    EXPECT_EQ(found("color = textureLod(a, uv, 1.0) + textureGather(b, uv);"), "a b");
    EXPECT_EQ(found("color = vec4(texture(c, vec3(uv, 0.5)));"), "c");
    EXPECT_EQ(found("color = textureGrad(many[1], uv, vec2(0), vec2(0));"), "many");
}

TEST_F(SampledImages, FetchesAndImagesWithKnownSizeDoNotCount) {
    EXPECT_EQ(found("color = texelFetch(a, ivec2(gl_FragCoord.xy), 0);"), "");
    EXPECT_EQ(found("color = texture(a, gl_FragCoord.xy / vec2(textureSize(a, 0))) + texture(b, uv);"), "b");
}

TEST_F(SampledImages, ArgumentsOfFunctionsDoNotCount) {
    const std::string blur = "vec4 blur(sampler2D s) { return texture(s, uv); }";
    EXPECT_EQ(found("color = blur(a) + texture(b, uv);", blur), "b");
}

TEST_F(SampledImages, AnImageThatIsOnlyFetchedIsNotFiltered) {
    write("graph/a.frag",
          "#version 460\nlayout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 color;\n"
          "uniform sampler2D fetched, both, passed, asked;\n"
          "vec4 first(sampler2D s) { return texelFetch(s, ivec2(0), 0); }\n"
          "void main() {\n"
          "    color = texelFetch(fetched, textureSize(asked, 0), 0) + texelFetch(both, ivec2(1), 0) +\n"
          "            textureLod(both, uv, 0.0) + first(passed);\n}\n");
    const ShaderProgram compiled = program("a.frag", ProgramKind::fullscreen);
    const auto filters = [&](const char* name) {
        const ShaderBinding* binding = compiled.interface.find(name);
        return binding != nullptr && binding->filters;
    };
    EXPECT_FALSE(filters("fetched"));
    EXPECT_FALSE(filters("asked"));
    EXPECT_TRUE(filters("both"));
    EXPECT_TRUE(filters("passed"));  // The function may sample it.
}

TEST_F(SampledImages, BrokenModulesGiveNothing) {
    EXPECT_TRUE(shader::sampled_images({}).empty());
    const std::vector<uint32_t> words{0x07230203, 0x10000, 0, 8, 0, 0x00020057, 1, 0x00010039};
    EXPECT_TRUE(shader::sampled_images(words).empty());
}

}  // namespace
}  // namespace weft
