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
