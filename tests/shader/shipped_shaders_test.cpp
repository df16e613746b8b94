// Tests that every shader in shaders/ compiles and that the SPIR-V gate accepts it. Also tests that each
// complete header in shaders/include compiles when a shader includes only this header.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/shader/shader_folder.h"
#include "weft/shader/compile_shader.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

struct Shipped {
    std::string reference;
    ProgramKind kind = ProgramKind::compute;
};

std::vector<Shipped> shipped(const fs::path& folder) {
    std::vector<Shipped> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path file = entry.path();
        const std::string reference = file.lexically_relative(folder).generic_string();
        if (reference.starts_with("include/")) continue;
        const bool has_vertex = fs::exists(fs::path(file).replace_extension(".vert"));
        if (file.extension() == ".comp") found.push_back({reference, ProgramKind::compute});
        if (file.extension() == ".frag" && !has_vertex) found.push_back({reference, ProgramKind::fullscreen});
        if (file.extension() == ".vert") {
            found.push_back(
                {file.parent_path().lexically_relative(folder).generic_string(), ProgramKind::raster});
        }
    }
    return found;
}

// Returns the names of the test programs for a header; `header` is its text. A header is tested in every
// stage, unless it uses a built-in variable of one stage, such as gl_FragCoord.
std::vector<const char*> programs_of(const std::string& header) {
    const auto names = [&header](const char* word) { return header.find(word) != std::string::npos; };
    if (names("gl_Position")) return {"vertices"};
    if (names("gl_FragCoord") || names("gl_FrontFacing") || names("surface_fragment.glsl"))
        return {"surface"};
    if (names("gl_WorkGroupSize")) return {"alone.comp"};
    return {"alone.comp", "alone.frag", "vertices"};
}

ProgramKind kind_of(const std::string& program) {
    if (program.ends_with(".comp")) return ProgramKind::compute;
    return program.ends_with(".frag") ? ProgramKind::fullscreen : ProgramKind::raster;
}

// Tests every header in shaders/include. A header must include everything that it needs, so that headers can
// be included in any order.
class Headers : public ShaderFolder, public testing::WithParamInterface<std::string> {};

TEST_P(Headers, CompileAlone) {
    const std::string& header = GetParam();
    roots_.include_root = fs::path(WEFT_SOURCE_DIR) / "shaders/include";
    std::ifstream file(roots_.include_root / header);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    // The header is included twice, as happens if two other headers include it.
    const std::string body = "#include \"" + header + "\"\n#include \"" + header + "\"\nvoid main() { ";
    write("graph/alone.comp", "#version 460\nlayout(local_size_x = 1) in;\n" + body + "}\n");
    write("graph/alone.frag", "#version 460\n" + body + "}\n");
    write("graph/vertices/vertices.vert", "#version 460\n" + body + "gl_Position = vec4(0); }\n");
    write("graph/vertices/vertices.frag", "#version 460\nvoid main() { }\n");
    // This vertex shader calls place_surface(), as the vertex shaders of surfaces do. place_surface() writes
    // the outputs that the surface's fragment shader reads.
    write("graph/surface/surface.vert",
          "#version 460\n#include \"surface_vertex.glsl\"\n"
          "void main() { place_surface(); gl_Position = vec4(0); }\n");
    write("graph/surface/surface.frag", "#version 460\n" + body + "}\n");
    for (const char* name : programs_of(text)) {
        const auto program = compile(name, kind_of(name));
        EXPECT_TRUE(program.ok()) << name << "\n" << (program ? "" : to_text(program.errors()));
    }
}

std::vector<std::string> headers() {
    const fs::path folder = fs::path(WEFT_SOURCE_DIR) / "shaders/include";
    // Each header in shared/ includes begin.glsl as its first part and end.glsl as its last part. These two
    // files are not complete headers, so they are not tested alone.
    const std::set<std::string> parts{"shared/begin.glsl", "shared/end.glsl"};
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).generic_string();
        if (entry.path().extension() == ".glsl" && !parts.contains(name)) found.push_back(name);
    }
    std::ranges::sort(found);
    return found;
}

INSTANTIATE_TEST_SUITE_P(All, Headers, testing::ValuesIn(headers()), [](const auto& row) {
    std::string name = row.param.substr(0, row.param.rfind('.'));
    for (char& c : name)
        if (c == '/') c = '_';
    return name;
});

TEST(ShippedShaders, all_compile) {
    const fs::path folder = fs::path(WEFT_SOURCE_DIR) / "shaders";
    const ShaderRoots roots{{folder}, folder / "include", {}};
    for (const Shipped& shader : shipped(folder)) {
        const auto program = compile_shader(shader.reference, shader.kind, roots);
        EXPECT_TRUE(program.ok()) << shader.reference << "\n"
                                  << (program.ok() ? "" : to_text(program.errors()));
    }
}

}  // namespace
}  // namespace weft
