#include "tests/vulkan/executor_fixture.h"

#include <stdlib.h>  // Declares mkdtemp(), which the C++ headers do not declare.

#include <fstream>

namespace weft::vk {

ExecutorTest::ExecutorTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "weft_executor_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
}

ExecutorTest::~ExecutorTest() {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
}

void ExecutorTest::write_shader(const std::string& path, const std::string& glsl) const {
    std::filesystem::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path, std::ios::binary) << "#version 460\n" << glsl;
}

void ExecutorTest::use_shader(PassDecl& pass, const std::string& reference, ProgramKind kind) {
    ShaderRoots roots;
    roots.roots = {folder_};
    roots.include_root = WEFT_SOURCE_DIR "/shaders/include";
    Result<ShaderProgram> program = compile_shader(reference, kind, roots);
    ASSERT_TRUE(program.ok()) << to_text(program.errors());
    const ShaderInterface& interface = program->interface;
    pass.shader = reference;
    if (interface.has_params) {
        pass.params_bytes = interface.params.size_bytes;
        pass.params_push = interface.params.push_constants;
    }
    for (UseDecl& use : pass.uses)
        if (const ShaderBinding* binding = interface.find(use.port)) use.binding = binding->binding;
    shaders_.insert_or_assign(reference, std::move(*program));
}

ShaderInterface ExecutorTest::interface_of(const std::string& reference) const {
    return shaders_.at(reference).interface;
}

FramePlan ExecutorTest::compile_plan(const test::GraphBuilder& builder) {
    const ResolvedGraph graph = builder.build();
    return compile(graph, query_memory_needs(device(), graph), {});
}

ExecutorInput ExecutorTest::input_for(FramePlan plan) const {
    ExecutorInput input;
    input.plan = std::move(plan);
    input.shaders = &shaders_;
    return input;
}

std::unique_ptr<Executor> ExecutorTest::executor_for(ExecutorInput input) {
    Result<std::unique_ptr<Executor>> made = Executor::create(device(), std::move(input));
    if (!made) {
        ADD_FAILURE() << to_text(made.errors());
        return nullptr;
    }
    return std::move(*made);
}

std::vector<ReadbackData> ExecutorTest::run_frames(Executor& executor, uint32_t frames,
                                                   const FrameInput& first) {
    for (uint32_t i = 0; i < frames; ++i) {
        const Result<uint32_t> slot = executor.begin_frame();
        EXPECT_TRUE(slot.ok());
        FrameInput frame = first;
        frame.frame_index += i;
        const Status ran = executor.run(frame);
        EXPECT_TRUE(ran.ok()) << to_text(ran.errors());
    }
    const Status finished = executor.finish();
    EXPECT_TRUE(finished.ok());
    return executor.take_readbacks();
}

}  // namespace weft::vk
