// The worker program: the same words as in this process, and no harm from what would harm this process.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>

#include "shader/glsl_compile.h"
#include "shader_folder.h"

namespace weft {
namespace {

using Clock = std::chrono::steady_clock;

class Worker : public ShaderFolder {
 protected:
    Worker() { roots_.worker = WEFT_SHADER_WORKER; }

    // A macro that expands to 2^levels copies of `unit`.
    static std::string doubling(int levels, const std::string& unit) {
        std::string text = "#version 460\nlayout(local_size_x = 1) in;\n#define M0 " + unit + "\n";
        for (int i = 1; i <= levels; ++i)
            text += "#define M" + std::to_string(i) + " M" + std::to_string(i - 1) + " M" +
                    std::to_string(i - 1) + "\n";
        return text + "void main() { float x = 0; M" + std::to_string(levels) + " }\n";
    }
};

constexpr const char* kFine = R"(#version 460
#include "part.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D result;
void main() { imageStore(result, ivec2(gl_GlobalInvocationID.xy), vec4(part())); }
)";

TEST_F(Worker, GivesTheSameWordsAsThisProcess) {
    write("graph/x.comp", kFine);
    write("graph/part.glsl", "#include <deep/other.glsl>\nfloat part() { return other(); }\n");
    write("shaders/include/deep/other.glsl", "float other() { return 0.5; }\n");
    const ShaderProgram apart = program("x.comp", ProgramKind::compute);
    roots_.worker.clear();
    const ShaderProgram here = program("x.comp", ProgramKind::compute);
    ASSERT_EQ(apart.modules.size(), 1u);
    EXPECT_EQ(apart.modules[0].spirv, here.modules[0].spirv);
    EXPECT_EQ(apart.content_hash, here.content_hash);
}

TEST_F(Worker, TellsFaultsAsThisProcessDoes) {
    write("graph/bad.comp", "#version 460\n#include \"inner.glsl\"\nvoid main() { }\n");
    write("graph/inner.glsl", "float f() { return amuont; }\n");
    write("graph/lost.comp", "#version 460\n#include \"nowhere.glsl\"\nvoid main() { }\n");
    write("graph/round.comp", "#version 460\n#include \"round.comp\"\nvoid main() { }\n");
    for (const char* name : {"bad.comp", "lost.comp", "round.comp"}) {
        roots_.worker = WEFT_SHADER_WORKER;
        const std::string apart = to_text(errors(name, ProgramKind::compute));
        roots_.worker.clear();
        EXPECT_EQ(apart, to_text(errors(name, ProgramKind::compute)));
    }
}

TEST_F(Worker, IsStoppedWhenItTakesTooMuchMemory) {
    roots_.limits.worker_bytes = 256ull << 20;
    roots_.limits.stage_ms = 60'000;
    write("graph/bomb.comp", doubling(40, "x += sin(x) * 2.0;"));
    const Diagnostics faults = errors("bomb.comp", ProgramKind::compute);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].code, "W207") << to_text(faults);
    EXPECT_NE(faults[0].message.find("the compute stage takes more than 256 MiB of memory"),
              std::string::npos)
        << to_text(faults);
    EXPECT_NE(faults[0].file.find("bomb.comp"), std::string::npos);
    ASSERT_FALSE(faults[0].help.empty());
    EXPECT_NE(faults[0].help[0].find("shader.workerBytes"), std::string::npos);
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    EXPECT_LE(children.ru_maxrss, 1 << 20) << "KiB; the largest of all tests here";
}

TEST_F(Worker, IsStoppedWhenItTakesTooLong) {
    roots_.limits.stage_ms = 300;
    write("graph/slow.comp", doubling(60, ""));  // expands to nothing, for ever
    const Clock::time_point begin = Clock::now();
    const Diagnostics faults = errors("slow.comp", ProgramKind::compute);
    EXPECT_LE(Clock::now() - begin, std::chrono::seconds(2));
    EXPECT_EQ(faults[0].code, "W207") << to_text(faults);
    EXPECT_NE(faults[0].message.find("more than 300 ms"), std::string::npos) << to_text(faults);
}

TEST_F(Worker, ThatCrashesFailsItsStageOnly) {
    std::string sum = "x";
    for (int i = 0; i < 200'000; ++i) sum += "+x";
    write("graph/deep.comp",
          "#version 460\nlayout(local_size_x = 1) in;\nbuffer B { float x; };\nvoid main() { x = " + sum +
              "; }\n");
    write("graph/x.comp", kFine);
    write("graph/part.glsl", "float part() { return 1; }\n");
    shader::StageCompiler compiler(roots_);
    const auto before = compile_shader("x.comp", ProgramKind::compute, roots_, compiler);
    EXPECT_TRUE(before.ok()) << to_text(before.errors());
    const auto deep = compile_shader("deep.comp", ProgramKind::compute, roots_, compiler);
    ASSERT_FALSE(deep.ok());
    EXPECT_EQ(deep.errors()[0].code, "W207");
    EXPECT_NE(deep.errors()[0].message.find("crashed the compiler (signal 11)"), std::string::npos)
        << to_text(deep.errors());
    const auto after = compile_shader("x.comp", ProgramKind::compute, roots_, compiler);
    EXPECT_TRUE(after.ok()) << to_text(after.errors());
}

TEST_F(Worker, ThatGivesTooMuchIsNotBelieved) {
    roots_.limits.spirv_bytes = 1;
    std::string text = "#version 460\nlayout(local_size_x = 1) in;\nbuffer B { float x; };\nvoid main() {\n";
    for (int i = 0; i < 40'000; ++i) text += "x += 1;\n";
    write("graph/long.comp", text + "}\n");
    const Diagnostics faults = errors("long.comp", ProgramKind::compute);
    EXPECT_EQ(faults[0].code, "W207") << to_text(faults);
    EXPECT_NE(faults[0].message.find("of SPIR-V"), std::string::npos) << to_text(faults);
}

TEST_F(Worker, AllStagesOfAGraphShareOneTime) {
    roots_.limits.stage_ms = 300;
    roots_.limits.graph_ms = 400;
    write("graph/slow.comp", doubling(60, ""));
    shader::StageCompiler compiler(roots_);
    const Clock::time_point begin = Clock::now();
    Diagnostics last;
    for (int i = 0; i < 20; ++i)
        last = compile_shader("slow.comp", ProgramKind::compute, roots_, compiler).take_errors();
    EXPECT_LE(Clock::now() - begin, std::chrono::seconds(3));
    EXPECT_NE(last[0].message.find("came too late"), std::string::npos) << to_text(last);
}

TEST_F(Worker, ThatIsNotThereIsNamed) {
    write("graph/x.comp", "#version 460\nvoid main() { }\n");
    for (const auto& [program, why] :
         {std::pair("/no/such/worker", "No such file"), std::pair("/bin/true", "says nothing"),
          std::pair("/bin/cat", "says nothing")}) {
        roots_.worker = program;
        const Diagnostics faults = errors("x.comp", ProgramKind::compute);
        EXPECT_EQ(faults[0].code, "X570") << to_text(faults);
        EXPECT_NE(faults[0].message.find(program), std::string::npos) << to_text(faults);
        EXPECT_NE(faults[0].message.find(why), std::string::npos) << to_text(faults);
        EXPECT_FALSE(faults[0].help.empty());
    }
}

TEST_F(Worker, IsNotNeededForWhatIsInTheCache) {
    roots_.cache_dir = base_ / "cache";
    write("graph/x.comp", kFine);
    write("graph/part.glsl", "float part() { return 1; }\n");
    const ShaderProgram cold = program("x.comp", ProgramKind::compute);
    roots_.worker = "/no/such/worker";
    EXPECT_EQ(program("x.comp", ProgramKind::compute).modules[0].spirv, cold.modules[0].spirv);
}

}  // namespace
}  // namespace weft
