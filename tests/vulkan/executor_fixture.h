// Purpose: runs small frames in tests of the executor. The shaders are written in the test, the graphs come
// from GraphBuilder, the plans from compile(), and the results from readbacks. Any validation message fails
// the test.
#pragma once

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/graph/samples/graph_builder.h"
#include "tests/vulkan/device_fixture.h"
#include "weft/compile.h"
#include "weft/shader/compile_shader.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

class ExecutorTest : public DeviceTest {
 protected:
    ExecutorTest();
    ~ExecutorTest() override;

    // Stores the GLSL code of one shader stage in the file `path`, for example "fill.comp" or
    // "flat/flat.vert". The function adds the #version line.
    void write_shader(const std::string& path, const std::string& glsl) const;
    // Compiles a shader and assigns it to `pass`. Each port of the pass gets the binding of the shader
    // resource with the same name. The pass also gets the size and the kind of the block Params.
    void use_shader(PassDecl& pass, const std::string& reference, ProgramKind kind);
    [[nodiscard]] ShaderInterface interface_of(const std::string& reference) const;

    [[nodiscard]] FramePlan compile_plan(const test::GraphBuilder& builder);
    // Returns the input for an executor: the plan and all shaders that the test has used so far.
    [[nodiscard]] ExecutorInput input_for(FramePlan plan) const;
    [[nodiscard]] std::unique_ptr<Executor> executor_for(ExecutorInput input);
    // Runs `frames` frames with several frames in flight. Frame i has the input `first`, with i added to the
    // frame index. Then waits for all frames and returns all readbacks.
    [[nodiscard]] static std::vector<ReadbackData> run_frames(Executor& executor, uint32_t frames,
                                                              const FrameInput& first = {});

    ShaderCatalog shaders_;

 private:
    std::filesystem::path folder_;
};

template <class T>
[[nodiscard]] std::vector<T> values_of(const ReadbackData& data) {
    std::vector<T> values(data.bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), data.bytes.data(), values.size() * sizeof(T));
    return values;
}

}  // namespace weft::vk
