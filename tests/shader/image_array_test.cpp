// Tests arrays of images in shaders: reflection counts their elements, and the gate allows only constant
// indices.
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

class ImageArray : public ShaderFolder {
 protected:
    // Returns the text of a shader with an array of storage images and one of samplers. `index` is GLSL text.
    static std::string with_index(const std::string& index, const std::string& before = "",
                                  const std::string& sizes = "4") {
        return "#version 460\nlayout(local_size_x = 1) in;\nlayout(constant_id = 1) const int N = 1;\n"
               "layout(r32f) writeonly uniform image2D dst[" +
               sizes + "];\nuniform sampler2D src[" + sizes +
               "];\nlayout(push_constant) uniform Params { int i; } params;\nvoid main() {\n" + before +
               "imageStore(dst[" + index + "], ivec2(0), texelFetch(src[" + index + "], ivec2(0), 0)); }\n";
    }
};

TEST_F(ImageArray, ReflectionCountsTheElements) {
    write("graph/a.comp", with_index("3"));
    const ShaderProgram found = program("a.comp", ProgramKind::compute);
    for (const char* name : {"dst", "src"}) {
        const ShaderBinding* binding = found.interface.find(name);
        ASSERT_NE(binding, nullptr);
        EXPECT_EQ(binding->count, 4u);
        EXPECT_TRUE(binding->is_array);
    }
    write("graph/one.comp", with_index("0", "", "1"));
    EXPECT_TRUE(program("one.comp", ProgramKind::compute).interface.find("dst")->is_array);
}

TEST_F(ImageArray, ASpecialisationConstantIsAnIndex) {
    write("graph/a.comp", with_index("N"));
    EXPECT_TRUE(compile("a.comp", ProgramKind::compute).ok());
}

TEST_F(ImageArray, AnIndexThatIsNoConstantIsRefused) {
    roots_.target.texture_tables = false;
    for (const auto& [index, before] :
         {std::pair{"params.i", ""}, std::pair{"k", "for (int k = 0; k < 4; ++k)\n"}}) {
        write("graph/a.comp", with_index(index, before));
        const Diagnostics found = errors("a.comp", ProgramKind::compute);
        ASSERT_EQ(found.size(), 2u) << to_text(found);
        for (const Diagnostic& d : found) {
            EXPECT_EQ(d.code, "W208");
            EXPECT_NE(d.message.find("index that is not a constant"), std::string::npos) << d.message;
            EXPECT_TRUE(d.line == 4 || d.line == 5) << to_text(found);
            ASSERT_FALSE(d.help.empty());
            EXPECT_NE(d.help.front().find("switch"), std::string::npos);
        }
    }
}

// A device with tables of textures can index arrays of sampled images. Arrays of storage images need another
// feature, which Weft does not enable.
TEST_F(ImageArray, ADeviceWithTablesIndexesSampledImages) {
    write("graph/a.comp", with_index("params.i"));
    const Diagnostics found = errors("a.comp", ProgramKind::compute);
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W208");
    EXPECT_NE(found[0].message.find("\"dst\""), std::string::npos) << found[0].message;
}

std::string table_shader(const std::string& declaration, const std::string& index) {
    return "#version 460\n#extension GL_EXT_nonuniform_qualifier : require\nlayout(local_size_x = 8) in;\n" +
           declaration + "\nlayout(r32f) writeonly uniform image2D dst;\nvoid main() {\n" +
           "const ivec2 at = ivec2(gl_GlobalInvocationID.xy);\nimageStore(dst, at, texelFetch(src[" + index +
           "], ivec2(0), 0)); }\n";
}

TEST_F(ImageArray, WithoutASizeIsATable) {
    // The gate accepts tables for every device; resolve() reports W231 for the pass.
    roots_.target.texture_tables = false;
    for (const char* index : {"nonuniformEXT(at.x)", "at.x"}) {
        write("graph/a.comp", table_shader("uniform sampler2D src[];", index));
        const ShaderProgram found = program("a.comp", ProgramKind::compute);
        const ShaderBinding* binding = found.interface.find("src");
        ASSERT_NE(binding, nullptr);
        EXPECT_TRUE(binding->is_array && binding->is_runtime_array);
        EXPECT_EQ(binding->count, 1u);
        EXPECT_FALSE(found.interface.find("dst")->is_runtime_array);
        EXPECT_TRUE(found.interface.needs_texture_tables);
    }
    // GLSL gives an array the size of its greatest index if all indices are constants.
    write("graph/a.comp", table_shader("uniform sampler2D src[];", "2"));
    EXPECT_EQ(program("a.comp", ProgramKind::compute).interface.find("src")->count, 3u);
    write("graph/a.comp", table_shader("uniform sampler2D src[4];", "2"));
    EXPECT_FALSE(program("a.comp", ProgramKind::compute).interface.needs_texture_tables);
}

TEST_F(ImageArray, OnlySampledPortsNeedNoSize) {
    write("graph/a.comp", table_shader("layout(set = 2, binding = 1) uniform sampler2D src[];", "at.x"));
    const Diagnostics in_a_set = errors("a.comp", ProgramKind::compute);
    ASSERT_EQ(in_a_set.size(), 1u) << to_text(in_a_set);
    EXPECT_EQ(in_a_set[0].code, "W206");
    EXPECT_NE(in_a_set[0].message.find("without a size"), std::string::npos) << in_a_set[0].message;
    EXPECT_FALSE(in_a_set[0].help.empty());

    std::string stored = table_shader("layout(r32f) readonly uniform image2D src[];", "at.x");
    constexpr std::string_view kFetch = "texelFetch(src[at.x], ivec2(0), 0)";
    stored.replace(stored.find(kFetch), kFetch.size(), "imageLoad(src[at.x], ivec2(0))");
    write("graph/a.comp", stored);
    const Diagnostics of_images = errors("a.comp", ProgramKind::compute);
    ASSERT_EQ(of_images.size(), 1u) << to_text(of_images);
    EXPECT_EQ(of_images[0].code, "W208");
}

TEST_F(ImageArray, TheSizeMayNotHangOnASpecialisationConstant) {
    write("graph/a.comp", with_index("0", "", "N"));
    const Diagnostics found = errors("a.comp", ProgramKind::compute);
    ASSERT_EQ(found.size(), 2u) << to_text(found);
    for (const Diagnostic& d : found) EXPECT_EQ(d.code, "W206") << to_text(found);
    write("graph/b.comp", with_index("0][1", "", "2][3"));
    EXPECT_EQ(errors("b.comp", ProgramKind::compute).front().code, "W204");
}

}  // namespace
}  // namespace weft
