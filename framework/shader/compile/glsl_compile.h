// Purpose: compiles stages of GLSL to SPIR-V, in the worker program, which has limits on memory and processor
// time, or in this process. A SourceReader reads the includes. The worker starts with the first stage, serves
// all later stages, and is replaced after it had to be killed. Binding numbers and free locations are
// provisional until link_stages() assigns them. Errors: W202 GLSL error, W203 include not found or outside
// the roots, W207 over the limits, or the worker crashed; X570 the worker cannot be started.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "shader/worker/glsl_run.h"
#include "shader/compile/shader_sources.h"
#include "shader/worker/worker_process.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft::shader {

struct CompiledStage {
    ShaderStage stage = ShaderStage::compute;
    const SourceText* source = nullptr;
    std::vector<uint32_t> spirv;
    std::set<std::string> unplaced;  // stage inputs and outputs without an explicit location
};

// Not thread-safe: use one object per thread.
class StageCompiler {
 public:
    explicit StageCompiler(const ShaderRoots& roots) : program_(roots.worker), limits_(roots.limits) {}

    [[nodiscard]] Result<CompiledStage> compile(ShaderStage stage, const SourceText& source,
                                                SourceReader& reader);

 private:
    [[nodiscard]] Result<GlslOutcome> run_worker(ShaderStage stage, const SourceText& source,
                                                 const IncludeReader& includes);
    [[nodiscard]] std::optional<Message> converse(ShaderStage stage, const SourceText& source,
                                                  const IncludeReader& includes);
    [[nodiscard]] Diagnostic stopped(ShaderStage stage, const SourceText& source, uint64_t time_ms) const;

    std::filesystem::path program_;
    ShaderLimits limits_;
    std::unique_ptr<WorkerProcess> worker_;
    uint64_t spent_ms_ = 0;
};

}  // namespace weft::shader
