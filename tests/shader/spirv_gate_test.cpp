// tests/shader/capabilities/ has one small shader for each SPIR-V capability that glslang can emit. The file
// is named after the capability. Its first line begins with the expected result: "// refused: ...". If the
// shader must be rejected, "// expected error line" marks the line that the error must name. Further tests
// check the gate's limits, for example on memory and calls.
#include "shader/gate/spirv_gate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "shader/gate/capability_table.h"
#include "shader/gate/spirv_words.h"
#include "shader/worker/glsl_run.h"
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

namespace fs = std::filesystem;
using shader::capability_table;
using shader::CapabilityRow;
using shader::CapabilityRule;

struct CapabilityShader {
    // Name of a SPIR-V capability. Some extensions, and the use zero_initialised of variables, have no
    // capability of their own. Their shaders have the name of the extension or of the use.
    std::string name;
    ProgramKind kind = ProgramKind::compute;
    std::string extension;
    std::string text;
    std::string verdict;
    uint32_t line = 0;
};

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

CapabilityShader read_shader(const fs::path& path) {
    CapabilityShader shader{
        path.stem().string(), ProgramKind::compute, path.extension().string(), text_of(path), {}, 0};
    if (shader.extension == ".frag") shader.kind = ProgramKind::fullscreen;
    if (shader.extension == ".vert") shader.kind = ProgramKind::raster;
    std::istringstream lines(shader.text);
    uint32_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (number == 1) shader.verdict = line.substr(3, line.find(':') - 3);
        if (line.ends_with("// expected error line")) shader.line = number;
    }
    return shader;
}

std::vector<CapabilityShader> all_shaders() {
    std::vector<CapabilityShader> shaders;
    for (const auto& entry : fs::directory_iterator(fs::path(WEFT_SOURCE_DIR) / "tests/shader/capabilities"))
        shaders.push_back(read_shader(entry.path()));
    std::ranges::sort(shaders, {}, &CapabilityShader::name);
    return shaders;
}

void expect_too_large(const Diagnostics& found, uint32_t line) {
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W209");
    EXPECT_EQ(found[0].line, line);
}

class ShaderGate : public ShaderFolder {
 protected:
    [[nodiscard]] Result<ShaderProgram> compile_for(const CapabilityShader& shader,
                                                    const ShaderTarget& target) {
        roots_.target = target;
        if (shader.kind != ProgramKind::raster) {
            write("graph/a" + shader.extension, shader.text);
            return compile("a" + shader.extension, shader.kind);
        }
        write("graph/a/a.vert", shader.text);
        write("graph/a/a.frag",
              "#version 460\nlayout(location = 0) out vec4 color;\n"
              "void main() { color = vec4(1); }\n");
        return compile("a", ProgramKind::raster);
    }
    void expect_allowed(const CapabilityShader& shader, const ShaderTarget& target) {
        const auto program = compile_for(shader, target);
        EXPECT_TRUE(program.ok()) << shader.name << ":\n" << to_text(program.errors());
    }
    void expect_refused(const CapabilityShader& shader, const ShaderTarget& target, const std::string& code) {
        const auto program = compile_for(shader, target);
        if (program.ok()) {
            ADD_FAILURE() << shader.name << " got past the gate";
            return;
        }
        const Diagnostics& found = program.errors();
        const std::string text = to_text(found);
        // There may be two errors: one for a type and one for an operation on the type.
        EXPECT_LE(found.size(), 2u) << text;
        EXPECT_TRUE(std::ranges::any_of(found, [&](const Diagnostic& d) { return d.line == shader.line; }))
            << shader.name << ", wanted line " << shader.line << ":\n"
            << text;
        for (const Diagnostic& d : found) {
            EXPECT_EQ(d.code, code) << text;
            EXPECT_TRUE(d.file.ends_with(shader.extension)) << text;
            EXPECT_FALSE(d.help.empty() || d.help.front().empty()) << text;
        }
    }
    [[nodiscard]] Diagnostics refused(const std::string& text, const ShaderLimits& limits = {}) {
        write("graph/s.comp", text);
        roots_.limits = limits;
        return errors("s.comp", ProgramKind::compute);
    }
};

const ShaderTarget kEverything{};
const ShaderTarget kNothing{0, false, 16384, false};  // Nothing optional, 16 KiB of shared memory.

TEST_F(ShaderGate, EachCapabilityIsAllowedOrRefusedAtItsLine) {
    for (const CapabilityShader& shader : all_shaders()) {
        SCOPED_TRACE(shader.name);
        if (shader.verdict == "allowed" || shader.verdict == "compute") {
            expect_allowed(shader, kNothing);
        } else if (shader.verdict == "device" || shader.verdict == "compute+device") {
            expect_allowed(shader, kEverything);
            expect_refused(shader, kNothing, "W208");
        } else if (shader.verdict == "tables") {
            const auto program = compile_for(shader, kEverything);
            EXPECT_TRUE(program && program->interface.needs_texture_tables);
        } else if (shader.verdict == "interface") {
            // The gate accepts the capability on every device. If the shader has an expected error line,
            // reflection must reject it, because no pass can bind its variable.
            if (shader.line == 0)
                expect_allowed(shader, kNothing);
            else
                expect_refused(shader, kNothing, "W206");
        } else {
            ASSERT_EQ(shader.verdict, "refused");
            expect_refused(shader, kEverything, "W208");
        }
    }
}

TEST_F(ShaderGate, EachRowHasAShaderThatSaysTheSame) {
    std::map<std::string, CapabilityShader> shaders;
    for (const CapabilityShader& shader : all_shaders()) shaders[shader.name] = shader;
    const std::map<CapabilityRule, std::string> verdicts{{CapabilityRule::always, "allowed"},
                                                         {CapabilityRule::device, "device"},
                                                         {CapabilityRule::compute, "compute"},
                                                         {CapabilityRule::tables, "tables"},
                                                         {CapabilityRule::never, "refused"}};
    for (const CapabilityRow& row : capability_table()) {
        const auto found = shaders.find(row.name);
        ASSERT_NE(found, shaders.end()) << row.name << " has no shader";
        const std::string& verdict = found->second.verdict;
        EXPECT_TRUE(verdict.starts_with(verdicts.at(row.rule)) ||
                    (verdict == "interface" && row.rule == CapabilityRule::always))
            << row.name << ": " << verdict;
        EXPECT_EQ(row.rule == CapabilityRule::never,
                  std::string(row.remedy).empty() == false && verdict == "refused");
    }
}

// A test shader must use the capability that its file is named after.
TEST_F(ShaderGate, EachShaderAsksForWhatItIsNamedAfter) {
    const auto capability_of = [](const std::string& name) -> const CapabilityRow* {
        const auto rows = capability_table();
        const auto found =
            std::ranges::find(rows, name, [](const CapabilityRow& row) { return std::string(row.name); });
        return found == rows.end() ? nullptr : &*found;
    };
    for (const CapabilityShader& shader : all_shaders()) {
        const ShaderStage stage = shader.extension == ".comp"   ? ShaderStage::compute
                                  : shader.extension == ".frag" ? ShaderStage::fragment
                                                                : ShaderStage::vertex;
        const auto no_includes = [](const shader::IncludeRequest&) { return shader::IncludeAnswer{}; };
        const shader::GlslOutcome outcome = shader::run_glslang(stage, "a", shader.text, no_includes);
        ASSERT_TRUE(outcome.good) << shader.name << ": " << outcome.log;
        const CapabilityRow* row = capability_of(shader.name);
        bool asked = row == nullptr;
        shader::SpirvReader reader(outcome.spirv);
        for (shader::SpirvInstruction i; row != nullptr && reader.next(i);)
            asked = asked || (i.opcode == 17 && i.operand(0) == row->capability);
        EXPECT_TRUE(asked) << shader.name;
    }
}

// The table in docs/shaders.md must agree with the table in the code. Capabilities that have the same rule
// and the same remedy share a row in docs/shaders.md.
TEST_F(ShaderGate, TheDocumentedTableIsTheOneInTheCode) {
    const std::map<CapabilityRule, std::string> verdicts{
        {CapabilityRule::always, "yes"},
        {CapabilityRule::device, "if the device has it"},
        {CapabilityRule::compute, "in compute stages"},
        {CapabilityRule::tables, "if the device has tables of textures (W231)"},
        {CapabilityRule::never, "no"}};
    const auto verdict = [&](const CapabilityRow& row) {
        const bool asks = row.rule == CapabilityRule::compute && row.needs != 0;
        return verdicts.at(row.rule) + (asks ? ", if the device has it" : "");
    };
    std::vector<std::pair<std::string, std::string>> lines;
    for (const CapabilityRow& row : capability_table()) {
        const bool none = row.rule == CapabilityRule::compute && row.needs == 0;
        const std::string end = " | " + verdict(row) + " | " + (none ? "" : row.remedy) + " |";
        const auto line = std::ranges::find(lines, end, &std::pair<std::string, std::string>::second);
        const std::string name = std::string("`") + row.name + "`";
        if (line == lines.end())
            lines.emplace_back(name, end);
        else
            line->first += ", " + name;
    }
    const std::string page = text_of(fs::path(WEFT_SOURCE_DIR) / "docs/shaders.md");
    for (const auto& [names, end] : lines)
        EXPECT_NE(page.find("| " + names + end + "\n"), std::string::npos) << "| " << names << end;
}

TEST_F(ShaderGate, SubgroupOperationsAreForComputeStages) {
    const CapabilityShader shader{"fragment",
                                  ProgramKind::fullscreen,
                                  ".frag",
                                  "#version 460\n#extension GL_KHR_shader_subgroup_vote : require\n"
                                  "layout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 color;\n"
                                  "void main() { color = vec4(subgroupAll(uv.x > 0.5)); }\n",
                                  "",
                                  5};
    expect_refused(shader, kEverything, "W208");
}

// Vulkan requires the feature vertexPipelineStoresAndAtomics for a vertex shader that writes to a buffer.
// SPIR-V has no capability for such writes, so the gate must find the writes itself.
TEST_F(ShaderGate, AVertexStageWritesToNoBuffer) {
    const auto vertex = [](const std::string& qualifier) {
        return "#version 460\n" + qualifier +
               "buffer Data { uint items[]; } data;\n"
               "void main() { gl_Position = vec4(data.items[0]); }\n";
    };
    expect_refused({"writes", ProgramKind::raster, ".vert", vertex(""), "", 2}, kEverything, "W206");
    expect_allowed({"reads", ProgramKind::raster, ".vert", vertex("readonly "), "", 0}, kEverything);
}

TEST_F(ShaderGate, ACapabilityThatIsNotInTheTableIsRefused) {
    const CapabilityShader shader{"unknown",
                                  ProgramKind::compute,
                                  ".comp",
                                  "#version 460\n#extension GL_EXT_spirv_intrinsics : require\n"
                                  "layout(local_size_x = 1) in;\nbuffer Data { uint items[]; } data;\n"
                                  "spirv_instruction(capabilities = [6], id = 200) uint twist(uint number);\n"
                                  "void main() { data.items[0] = twist(1u); }\n",
                                  "",
                                  5};
    expect_refused(shader, kEverything, "W208");
}

// A cached module may come from another device, or from another version of Weft that accepted it. So the gate
// must judge modules from the cache too.
TEST_F(ShaderGate, WhatComesFromTheCacheIsJudgedForThisDevice) {
    roots_.cache_dir = base_ / "cache";
    const CapabilityShader shader =
        read_shader(fs::path(WEFT_SOURCE_DIR) / "tests/shader/capabilities/SampledCubeArray.comp");
    expect_allowed(shader, kEverything);
    expect_refused(shader, kNothing, "W208");
    expect_allowed(shader, kEverything);
}

constexpr const char* kHead =
    "#version 460\nlayout(local_size_x = 1) in;\nbuffer Data { uint items[]; } data;\n";

std::string with(const std::string& declarations, const std::string& body) {
    return kHead + declarations + "void main() {\n" + body + "}\n";
}

TEST_F(ShaderGate, SharedMemoryHasALimit) {
    const Diagnostics found =
        refused(with("// expected error line\nshared float s[1 << 28];\n", "s[0] = 1; data.items[0] = 1;"));
    expect_too_large(found, 5);
    EXPECT_NE(found[0].message.find("1 GiB"), std::string::npos) << found[0].message;
    EXPECT_NE(found[0].help.at(0).find("shader.sharedBytes"), std::string::npos) << found[0].help[0];
    ShaderLimits limits;
    limits.shared_bytes = 1ull << 31;
    write("graph/s.comp", with("shared float s[1 << 28];\n", "s[0] = 1; data.items[0] = 1;"));
    roots_.limits = limits;
    EXPECT_TRUE(compile("s.comp", ProgramKind::compute).ok()) << "the limit can be raised";
}

TEST_F(ShaderGate, TheDevicesSharedMemoryIsALimitToo) {
    write("graph/s.comp", with("shared float s[5000];\n", "s[0] = 1; data.items[0] = 1;"));
    EXPECT_TRUE(compile("s.comp", ProgramKind::compute).ok());
    roots_.target = kNothing;
    const Diagnostics found = errors("s.comp", ProgramKind::compute);
    EXPECT_EQ(found.at(0).code, "W209");
    EXPECT_EQ(found[0].line, 4u);
    EXPECT_NE(found[0].message.find("16 KiB"), std::string::npos) << found[0].message;
}

TEST_F(ShaderGate, PrivateMemoryHasALimit) {
    for (const std::string& text :
         {with("float big[1 << 28];\n", "big[data.items[0]] = 1; data.items[0] = uint(big[data.items[1]]);"),
          with("\n",
               "float big[1 << 28]; big[data.items[0]] = 1; data.items[0] = uint(big[data.items[1]]);")}) {
        const Diagnostics found = refused(text);
        ASSERT_EQ(found.size(), 1u) << to_text(found);
        EXPECT_EQ(found[0].code, "W209");
        EXPECT_NE(found[0].source_line.find("big[1 << 28]"), std::string::npos) << found[0].source_line;
        EXPECT_NE(found[0].help.at(0).find("shader.privateBytes"), std::string::npos);
    }
}

// The shader has only about 200 bytes of text. But a driver can need minutes to compile it, because the
// driver copies each array element separately.
TEST_F(ShaderGate, AnArrayThatIsCopiedAsAWholeIsPrivateMemory) {
    const std::string declarations =
        "struct Big { float a[1 << 16]; };\nbuffer From { Big v; } from;\nbuffer To { Big v; } to;\n";
    const Diagnostics found = refused(with(declarations, "to.v = from.v;"));
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W209");
    EXPECT_NE(found[0].message.find("256 KiB"), std::string::npos) << found[0].message;
    write("graph/s.comp", with(declarations, "to.v.a[data.items[0]] = from.v.a[data.items[1]];"));
    EXPECT_TRUE(compile("s.comp", ProgramKind::compute).ok());
}

// Drivers inline a function at each of its calls, so its arrays are counted once per call.
TEST_F(ShaderGate, PrivateMemoryCountsEachCall) {
    std::string calls;
    for (int i = 0; i < 40; ++i) calls += "data.items[0] += some(" + std::to_string(i) + "u);\n";
    const std::string some = "uint some(uint i) { uint a[512]; a[i] = i; return a[data.items[i]]; }\n";
    EXPECT_TRUE((write("graph/s.comp", with(some, calls.substr(0, calls.find('\n') + 1))),
                 compile("s.comp", ProgramKind::compute).ok()));
    const Diagnostics found = refused(with(some, calls));
    expect_too_large(found, 4);
}

TEST_F(ShaderGate, FunctionsThatDoubleThemselvesAreRefused) {
    std::string text = "uint f0(uint i) { return data.items[i] * 3u + 1u; }\n";
    for (int i = 1; i <= 30; ++i) {
        const std::string before = "f" + std::to_string(i - 1);
        text += "uint f" + std::to_string(i) + "(uint i) { return " + before + "(i) + " + before +
                "(i + 1u); }\n";
    }
    const Diagnostics found = refused(with(text, "data.items[0] = f30(1u);"));
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W209");
    EXPECT_NE(found[0].help.at(0).find("shader.inlinedBytes"), std::string::npos);
}

TEST_F(ShaderGate, LongChainsOfCallsAreRefused) {
    std::string text = "uint f0(uint i) { return i; }\n";
    for (int i = 1; i <= 3000; ++i)
        text += "uint f" + std::to_string(i) + "(uint i) { return f" + std::to_string(i - 1) + "(i); }\n";
    const Diagnostics found = refused(with(text, "data.items[0] = f3000(1u);"));
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W209");
}

TEST_F(ShaderGate, TypesOfManyDimensionsAreRefused) {
    std::string dimensions, first;
    for (int i = 0; i < 200; ++i) {
        dimensions += "[1]";
        first += "[0]";
    }
    const Diagnostics found = refused(with("shared uint deep" + dimensions + ";\n",
                                           "deep" + first + " = 1u; data.items[0] = deep" + first + ";"));
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W209") << to_text(found);
}

TEST_F(ShaderGate, PushConstantsHaveALimit) {
    const Diagnostics found =
        refused(with("layout(push_constant) uniform Params { float a[1 << 28]; } params;\n",
                     "data.items[0] = uint(params.a[data.items[1]]);"));
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W209");
    EXPECT_EQ(found[0].line, 4u);
}

TEST_F(ShaderGate, InputsAndOutputsHaveALimit) {
    write("graph/p/p.vert",
          "#version 460\nlayout(location = 0) out vec4 many[1 << 24];\n"
          "void main() { gl_Position = vec4(1); many[0] = vec4(1); }\n");
    write("graph/p/p.frag",
          "#version 460\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1); }\n");
    const Diagnostics found = errors("p", ProgramKind::raster);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].code, "W209") << to_text(found);
    EXPECT_EQ(found[0].line, 2u);
}

TEST_F(ShaderGate, AnArraysSizeMayNotHangOnASpecialisationConstant) {
    const Diagnostics found =
        refused(with("layout(constant_id = 0) const uint N = 4u;\nshared float s[N * 2u];\n",
                     "s[0] = 1; data.items[0] = uint(s[0]);"));
    ASSERT_EQ(found.size(), 1u) << to_text(found);
    EXPECT_EQ(found[0].code, "W209");
    EXPECT_EQ(found[0].line, 5u);
}

}  // namespace
}  // namespace weft
