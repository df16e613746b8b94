// Every shader under shaders/ compiles, and its words pass the gate.
#include <gtest/gtest.h>

#include <filesystem>

#include "shader/compile_shader.h"

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
