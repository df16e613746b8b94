// Tests the worker program that compiles shaders. It must give the same SPIR-V as a compilation in this
// process, and inputs that crash or block the worker must not harm this process.
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "shader/compile/glsl_compile.h"
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

class Worker : public ShaderFolder {
 protected:
    Worker() { roots_.worker = WEFT_SHADER_WORKER; }

    // Returns the processor time of all workers that have ended, in milliseconds.
    static int64_t children_ms() {
        rusage children{};
        getrusage(RUSAGE_CHILDREN, &children);
        const auto ms = [](const timeval& time) { return time.tv_sec * 1000 + time.tv_usec / 1000; };
        return ms(children.ru_utime) + ms(children.ru_stime);
    }
    // Returns a shader with a macro that expands to 2^levels copies of `unit`.
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
    EXPECT_NE(faults[0].message.find("the compute stage needs more than 256 MiB of memory"),
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
    // The macro expands to nothing, but its 2^60 expansions would practically never end.
    write("graph/slow.comp", doubling(60, ""));
    const int64_t before_ms = children_ms();
    const Diagnostics faults = errors("slow.comp", ProgramKind::compute);
    EXPECT_LE(children_ms() - before_ms, 2000);
    EXPECT_EQ(faults[0].code, "W207") << to_text(faults);
    EXPECT_NE(faults[0].message.find("more than 300 ms of processor time"), std::string::npos)
        << to_text(faults);
}

// Stops the worker for 1.5 s of elapsed time, as on a machine whose processors are all busy. The limit of 1 s
// counts only processor time, so the compilation must succeed.
TEST_F(Worker, ThatGetsNoProcessorIsWaitedFor) {
    roots_.limits.stage_ms = 1000;
    write("graph/x.comp", kFine);
    write("graph/part.glsl", "float part() { return 1; }\n");
    shader::StageCompiler compiler(roots_);
    ASSERT_TRUE(compile_shader("x.comp", ProgramKind::compute, roots_, compiler)) << "starts the worker";
    pid_t worker = 0;
    std::ifstream("/proc/self/task/" + std::to_string(gettid()) + "/children") >> worker;
    if (worker == 0) GTEST_SKIP() << "this kernel does not list a thread's children";
    ASSERT_EQ(kill(worker, SIGSTOP), 0);
    std::thread busy([worker] {
        std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        kill(worker, SIGCONT);
    });
    const auto stopped = compile_shader("x.comp", ProgramKind::compute, roots_, compiler);
    busy.join();
    EXPECT_TRUE(stopped.ok()) << to_text(stopped.errors());
}

// This worker sleeps: it neither answers nor uses processor time. The caller must not wait for ever.
TEST_F(Worker, ThatSleepsIsStopped) {
    roots_.limits.stage_ms = 100;
    write("sleeper", "#!/bin/sh\nexec sleep 600\n");
    std::filesystem::permissions(base_ / "sleeper", std::filesystem::perms::owner_all);
    roots_.worker = base_ / "sleeper";
    write("graph/x.comp", kFine);
    const Diagnostics faults = errors("x.comp", ProgramKind::compute);
    EXPECT_EQ(faults[0].code, "X570") << to_text(faults);
    EXPECT_NE(faults[0].message.find("does not answer"), std::string::npos) << to_text(faults);
}

// A limit set with `ulimit -t` remains in force, because only root may raise it. The worker must also work
// under such a limit.
TEST_F(Worker, WorksUnderALimitOnProcessorTime) {
    write("graph/x.comp", kFine);
    write("graph/part.glsl", "float part() { return 1; }\n");
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const rlimit limit{600, 600};
        const bool limited = setrlimit(RLIMIT_CPU, &limit) == 0;
        // Without the capability CAP_SYS_RESOURCE, even processes of root cannot raise the limit.
        const bool bound = getuid() != 0 || prctl(PR_CAPBSET_DROP, CAP_SYS_RESOURCE, 0, 0, 0) == 0;
        const auto made = compile_shader("x.comp", ProgramKind::compute, roots_);
        _exit(!limited || !bound ? 2 : made.ok() ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
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
    const int64_t before_ms = children_ms();
    Diagnostics last;
    for (int i = 0; i < 20; ++i)
        last = compile_shader("slow.comp", ProgramKind::compute, roots_, compiler).take_errors();
    EXPECT_LE(children_ms() - before_ms, 3000);
    EXPECT_NE(last[0].message.find("all stages of the graph together need more than"), std::string::npos)
        << to_text(last);
}

TEST_F(Worker, ThatIsNotThereIsNamed) {
    write("graph/x.comp", "#version 460\nvoid main() { }\n");
    for (const auto& [program, why] :
         {std::pair("/no/such/worker", "No such file"), std::pair("/bin/true", "does not answer"),
          std::pair("/bin/cat", "does not answer")}) {
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
