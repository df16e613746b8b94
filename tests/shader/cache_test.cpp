// Tests that the shader cache only saves time: it returns the same SPIR-V as a compilation, or nothing.
#include <gtest/gtest.h>

#include <iterator>

#include "shader/compile/sealed_file.h"
#include "shader/compile/shader_cache.h"
#include "shader/gate/validate_spirv.h"
#include "shader/reflect/interface_merge.h"
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

class Cache : public ShaderFolder {
 protected:
    Cache() {
        roots_.cache_dir = base_ / "cache";
        write("graph/x.frag", kFragment);
        write("shaders/include/tint.glsl", "vec4 tint() { return vec4(0.5); }\n");
    }

    [[nodiscard]] std::vector<fs::path> cached(const std::string& extension) const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(roots_.cache_dir)) {
            if (entry.path().extension() == extension) files.push_back(entry.path());
        }
        return files;
    }

    [[nodiscard]] bool hits() const {
        shader::SourceReader reader(roots_);
        return shader::load_cached("x.frag", ProgramKind::fullscreen, roots_, reader).has_value();
    }

    static constexpr const char* kFragment = R"(#version 460
#include "tint.glsl"
uniform sampler2D image;
layout(push_constant) uniform Params { float exposure; };
in vec2 uv;
out vec4 color;
void main() { color = tint() * texture(image, uv) * exposure; }
)";
};

void expect_same(const ShaderProgram& a, const ShaderProgram& b) {
    EXPECT_EQ(a.reference, b.reference);
    EXPECT_EQ(a.content_hash, b.content_hash);
    ASSERT_EQ(a.modules.size(), b.modules.size());
    for (size_t i = 0; i < a.modules.size(); ++i) {
        EXPECT_EQ(a.modules[i].stage, b.modules[i].stage);
        EXPECT_EQ(a.modules[i].spirv, b.modules[i].spirv);
    }
    EXPECT_EQ(a.interface.bindings.size(), b.interface.bindings.size());
    EXPECT_EQ(a.interface.find("image")->binding, b.interface.find("image")->binding);
    EXPECT_EQ(a.interface.params.size_bytes, b.interface.params.size_bytes);
    EXPECT_EQ(a.interface.stages, b.interface.stages);
}

TEST_F(Cache, a_hit_gives_the_same_program) {
    EXPECT_FALSE(hits());
    const ShaderProgram first = program("x.frag", ProgramKind::fullscreen);
    EXPECT_TRUE(hits());
    expect_same(first, program("x.frag", ProgramKind::fullscreen));
    EXPECT_TRUE(cached(".draft").empty());
}

TEST_F(Cache, any_change_of_any_text_misses) {
    const ShaderProgram first = program("x.frag", ProgramKind::fullscreen);
    write("shaders/include/tint.glsl", "vec4 tint() { return vec4(0.6); }\n");
    EXPECT_FALSE(hits());
    const ShaderProgram second = program("x.frag", ProgramKind::fullscreen);
    EXPECT_NE(first.content_hash, second.content_hash);
    EXPECT_NE(first.modules[1].spirv, second.modules[1].spirv);
}

TEST_F(Cache, a_new_file_that_would_be_found_first_misses) {
    const ShaderProgram first = program("x.frag", ProgramKind::fullscreen);
    write("graph/tint.glsl", "vec4 tint() { return vec4(0.25); }\n");
    EXPECT_FALSE(hits());
    EXPECT_NE(program("x.frag", ProgramKind::fullscreen).modules[1].spirv, first.modules[1].spirv);
}

TEST_F(Cache, damaged_entries_are_rebuilt) {
    const ShaderProgram first = program("x.frag", ProgramKind::fullscreen);
    for (const char* extension : {".spirv", ".manifest"}) {
        for (const std::string damage : {"cut", "flip", "empty", "grow"}) {
            const fs::path file = cached(extension).at(0);
            std::ifstream in(file, std::ios::binary);
            std::string bytes(std::istreambuf_iterator<char>(in), {});
            in.close();
            if (damage == "cut") bytes.resize(bytes.size() / 2);
            if (damage == "flip") bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
            if (damage == "empty") bytes.clear();
            if (damage == "grow") bytes += '\0';
            std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
            EXPECT_FALSE(hits()) << extension << " " << damage;
            expect_same(first, program("x.frag", ProgramKind::fullscreen));
            EXPECT_TRUE(hits()) << extension << " " << damage;
        }
    }
}

// Returns the SPIR-V of the program with one changed bit. spirv-val rejects the changed module, but
// reflection does not notice the change.
std::vector<uint32_t> subtly_broken(const ShaderProgram& program) {
    for (size_t at = program.modules[1].spirv.size(); at-- > 0;) {
        std::vector<ShaderModule> modules = program.modules;
        modules[1].spirv[at] ^= 1;
        shader::InterfaceFaults faults;
        if (!shader::spirv_fault(modules[1].spirv)) continue;
        (void)shader::reflect_program(modules, faults);
        if (faults.empty()) return modules[1].spirv;
    }
    ADD_FAILURE() << "no such change";
    return {};
}

// The forged cache entry is complete and has a correct checksum, but its SPIR-V is invalid. So the gate must
// reject the entry.
TEST_F(Cache, a_forged_entry_does_not_pass_the_gate) {
    const ShaderProgram first = program("x.frag", ProgramKind::fullscreen);
    ShaderProgram forged = first;
    forged.modules[1].spirv = subtly_broken(first);
    const fs::path manifest = cached(".manifest").at(0);
    const auto honest_manifest = shader::read_sealed(manifest);
    shader::store_cached(forged, ProgramKind::fullscreen, roots_, shader::SourceReader(roots_));
    shader::write_sealed(manifest, *honest_manifest);
    shader::SourceReader again(roots_);
    ASSERT_EQ(shader::load_cached("x.frag", ProgramKind::fullscreen, roots_, again)->modules[1].spirv,
              forged.modules[1].spirv);
    expect_same(first, program("x.frag", ProgramKind::fullscreen));
}

TEST_F(Cache, a_folder_that_cannot_be_written_is_no_error) {
    roots_.cache_dir = base_ / "graph/x.frag/cache";
    EXPECT_TRUE(compile("x.frag", ProgramKind::fullscreen).ok());
}

TEST_F(Cache, the_words_do_not_depend_on_where_the_roots_lie) {
    const ShaderProgram first = program("x.frag", ProgramKind::fullscreen);
    fs::rename(base_ / "graph", base_ / "moved");
    roots_.roots[0] = base_ / "moved";
    expect_same(first, program("x.frag", ProgramKind::fullscreen));
}

TEST(SpirvGate, refuses_what_is_not_spirv) {
    EXPECT_TRUE(shader::spirv_fault({}).has_value());
    EXPECT_TRUE(shader::spirv_fault({1, 2, 3, 4, 5, 6}).has_value());
}

}  // namespace
}  // namespace weft
