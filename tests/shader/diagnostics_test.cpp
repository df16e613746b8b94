// Tests the messages for faults in shaders: the file and the line that they name, and their remedies.
#include <gtest/gtest.h>

#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

class ShaderErrors : public ShaderFolder {};

constexpr const char* kUsesBrdf = R"(#version 460
layout(local_size_x = 1) in;
#include "brdf.glsl"
buffer Out { float value; };
void main() { value = brdf(); }
)";

TEST_F(ShaderErrors, an_error_in_an_included_file_is_placed_there) {
    write("graph/light.comp", kUsesBrdf);
    write("shaders/include/brdf.glsl", "#include \"more/ggx.glsl\"\nfloat brdf() { return ggx(); }\n");
    write("shaders/include/more/ggx.glsl",
          "// roughness\nfloat roughness = 0.5;\nfloat ggx() { return rougness; }\n");
    const Diagnostics found = errors("light.comp", ProgramKind::compute);
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W202");
    EXPECT_EQ(found[0].file, (base_ / "shaders/include/more/ggx.glsl").string());
    EXPECT_EQ(found[0].line, 3u);
    EXPECT_EQ(found[0].column, 22u);
    EXPECT_EQ(found[0].length, 8u);
    EXPECT_EQ(found[0].source_line, "float ggx() { return rougness; }");
    EXPECT_NE(found[0].message.find("undeclared identifier"), std::string::npos);
    EXPECT_NE(found[0].help.at(0).find("roughness"), std::string::npos);
    ASSERT_EQ(found[0].notes.size(), 2u);
    EXPECT_EQ(found[0].notes[0].file, (base_ / "shaders/include/brdf.glsl").string());
    EXPECT_EQ(found[0].notes[0].line, 1u);
    EXPECT_EQ(found[0].notes[1].file, (base_ / "graph/light.comp").string());
    EXPECT_EQ(found[0].notes[1].line, 3u);
}

TEST_F(ShaderErrors, lines_after_an_include_count_in_their_own_file) {
    write("graph/light.comp", std::string(kUsesBrdf) + "int broken() { return vec2(0); }\n");
    write("shaders/include/brdf.glsl", "float brdf() { return 1; }\n\n\n\n");
    const Diagnostics found = errors("light.comp", ProgramKind::compute);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].file, (base_ / "graph/light.comp").string());
    EXPECT_EQ(found[0].line, 6u);
}

TEST_F(ShaderErrors, both_stages_are_reported_at_once) {
    write("graph/b/b.vert", "#version 460\nvoid main() { oops }\n");
    write("graph/b/b.frag", "#version 460\nvoid main() { other = 1; }\n");
    const Diagnostics found = errors("b", ProgramKind::raster);
    ASSERT_EQ(found.size(), 2u) << to_text(found);
    EXPECT_EQ(found[0].file, (base_ / "graph/b/b.vert").string());
    EXPECT_EQ(found[1].file, (base_ / "graph/b/b.frag").string());
}

TEST_F(ShaderErrors, a_program_without_main_is_one) {
    write("graph/m.comp", "#version 460\nlayout(local_size_x = 1) in;\n");
    const Diagnostics found = errors("m.comp", ProgramKind::compute);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].code, "W202");
    EXPECT_EQ(found[0].file, (base_ / "graph/m.comp").string());
}

TEST_F(ShaderErrors, an_empty_file_is_one) {
    write("graph/e.comp", "");
    EXPECT_EQ(errors("e.comp", ProgramKind::compute).at(0).code, "W202");
}

TEST_F(ShaderErrors, includes_never_leave_the_roots) {
    write("secret.glsl", "float secret_value = 1;\n");
    write("elsewhere/a.glsl", "float secret_value = 1;\n");
    fs::create_symlink(base_ / "secret.glsl", base_ / "graph/link.glsl");
    fs::create_directory_symlink(base_ / "elsewhere", base_ / "shaders/include/linked");
    const std::string outside[] = {"../secret.glsl",
                                   "sub/../../secret.glsl",
                                   (base_ / "secret.glsl").string(),
                                   "link.glsl",
                                   "linked/a.glsl",
                                   "/etc/hostname",
                                   "/dev/zero",
                                   ".."};
    for (const std::string& path : outside) {
        write("graph/x.comp", "#version 460\n#include \"" + path + "\"\nvoid main() {}\n");
        const Diagnostics found = errors("x.comp", ProgramKind::compute);
        ASSERT_EQ(found.size(), 1u) << path << "\n" << to_text(found);
        EXPECT_EQ(found[0].code, "W203") << path;
        EXPECT_EQ(found[0].line, 2u) << path;
        EXPECT_FALSE(found[0].help.empty());
        EXPECT_EQ(to_text(found).find("secret_value"), std::string::npos) << path;
    }
}

TEST_F(ShaderErrors, a_missing_include_is_named) {
    write("graph/x.comp", "#version 460\n#include \"nowhere.glsl\"\nvoid main() {}\n");
    const Diagnostics found = errors("x.comp", ProgramKind::compute);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].code, "W203");
    EXPECT_NE(found[0].message.find("nowhere.glsl"), std::string::npos);
    write("graph/fx/x.comp", "#version 460\n#include \"nowhere.glsl\"\nvoid main() {}\n");
    const std::string text = to_text(errors("fx/x.comp", ProgramKind::compute));
    const std::string graph = (base_ / "graph").string(), shared = (base_ / "shaders/include").string();
    EXPECT_NE(text.find("Weft looked in " + graph + "/fx, then in " + graph + ", then in " + shared),
              std::string::npos)
        << text;
}

TEST_F(ShaderErrors, shaders_of_a_graph_share_an_include_file) {
    for (const std::string stage : {"graph/a/a.vert", "graph/a/a.frag"})
        write(stage,
              "#version 460\n#include \"shared_by_all.glsl\"\n#include \"sub/more.glsl\"\n"
              "void main() { f(); g(); }\n");
    write("graph/shared_by_all.glsl", "void f() {}\n");
    write("graph/sub/more.glsl", "#include \"beside.glsl\"\nvoid g() { h(); }\n");
    write("graph/sub/beside.glsl", "void h() {}\n");
    const auto compiled = compile("a", ProgramKind::raster);
    EXPECT_TRUE(compiled.ok()) << to_text(compiled.errors());
    // The file beside the including file comes first.
    write("graph/a/shared_by_all.glsl", "void f() { fault }\n");
    EXPECT_NE(to_text(errors("a", ProgramKind::raster)).find("graph/a/shared_by_all.glsl"),
              std::string::npos);
    // The folder of the graph is not searched for files that only Weft's shaders include.
    write("shaders/fx/y.comp", "#version 460\n#include \"shared_by_all.glsl\"\nvoid main() { f(); }\n");
    EXPECT_EQ(errors("fx/y.comp", ProgramKind::compute).at(0).code, "W203");
}

TEST_F(ShaderErrors, a_wrong_shader_folder_is_named) {
    write("graph/x.frag",
          "#version 460\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1); }\n");
    fs::remove_all(base_ / "shaders");
    const Diagnostics found = errors("x.frag", ProgramKind::fullscreen);
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W201");
    EXPECT_NE(found[0].help.at(0).find("\"" + (base_ / "shaders").string() +
                                       "\" is not the folder shaders/ of Weft"),
              std::string::npos)
        << to_text(found);
}

TEST_F(ShaderErrors, an_include_that_includes_itself_ends) {
    write("graph/x.comp", "#version 460\n#include \"loop.glsl\"\nvoid main() {}\n");
    write("graph/loop.glsl", "#include \"loop.glsl\"\n");
    const Diagnostics found = errors("x.comp", ProgramKind::compute);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].code, "W203");
    EXPECT_NE(found[0].message.find("32"), std::string::npos);
}

TEST_F(ShaderErrors, includes_are_beside_first_then_in_the_include_root) {
    write("shaders/fx/x.comp", R"(#version 460
layout(local_size_x = 1) in;
#include "value.glsl"
#include <value.glsl>
buffer Out { float v; };
void main() { v = beside() + shared_one(); }
)");
    write("shaders/fx/value.glsl", "float beside() { return 1; }\n");
    write("shaders/include/value.glsl", "float shared_one() { return 2; }\n");
    EXPECT_TRUE(compile("fx/x.comp", ProgramKind::compute).ok());
}

TEST_F(ShaderErrors, the_graphs_own_folder_comes_first) {
    const std::string head = "#version 460\nlayout(local_size_x = ";
    write("shaders/x.comp", head + "4) in;\nvoid main() {}\n");
    EXPECT_EQ(program("x.comp", ProgramKind::compute).interface.local_size[0], 4u);
    write("graph/x.comp", head + "2) in;\nvoid main() {}\n");
    EXPECT_EQ(program("x.comp", ProgramKind::compute).interface.local_size[0], 2u);
}

TEST_F(ShaderErrors, a_missing_shader_names_where_it_was_looked_for_and_its_neighbours) {
    write("shaders/tonemap/tonemap.frag", "#version 460\nvoid main() {}\n");
    const Diagnostics found = errors("tonemap/tonemp.frag", ProgramKind::fullscreen);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].code, "W201");
    EXPECT_NE(found[0].help.at(0).find((base_ / "shaders").string()), std::string::npos);
    EXPECT_NE(found[0].help.at(1).find("tonemap/tonemap.frag"), std::string::npos);
}

TEST_F(ShaderErrors, a_missing_raster_shader_names_both_files) {
    write("shaders/gbuffer/gbuffer.vert", "#version 460\nvoid main() { gl_Position = vec4(0); }\n");
    const Diagnostics one = errors("gbuffer", ProgramKind::raster);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_NE(one[0].message.find("gbuffer/gbuffer.frag"), std::string::npos);
    const Diagnostics both = errors("gbufer", ProgramKind::raster);
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NE(both[0].help.at(1).find("\"gbuffer\""), std::string::npos);
}

TEST_F(ShaderErrors, references_never_leave_the_roots) {
    write("out.comp", "#version 460\nvoid main() {}\n");
    for (const std::string& reference :
         {std::string("../out.comp"), (base_ / "out.comp").string(), std::string("")}) {
        const Diagnostics found = errors(reference, ProgramKind::compute);
        EXPECT_EQ(found.at(0).code, "W201") << reference;
    }
}

TEST_F(ShaderErrors, the_extension_is_the_stage) {
    write("graph/x.frag", "#version 460\nvoid main() {}\n");
    EXPECT_EQ(errors("x.frag", ProgramKind::compute).at(0).code, "W201");
    EXPECT_EQ(errors("x.frag", ProgramKind::raster).at(0).code, "W201");
    EXPECT_EQ(errors("x", ProgramKind::fullscreen).at(0).code, "W201");
}

TEST_F(ShaderErrors, a_folder_or_a_pipe_is_no_shader) {
    fs::create_directories(base_ / "graph/folder.comp");
    EXPECT_EQ(errors("folder.comp", ProgramKind::compute).at(0).code, "W201");
}

}  // namespace
}  // namespace weft
