// Purpose: stages of GLSL to SPIR-V, with includes read by a SourceReader: in the worker program, which has
// limits on memory and processor time, or in this process. The worker is started for the first stage, serves
// all that follow, and is replaced when it had to be killed. Numbers of bindings and free locations are
// provisional until link_stages() has dealt them out. Errors: W202 GLSL error, W203 include not found or
// outside the roots, W207 over the limits, or the worker crashed; X570 there is no worker to start.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "shader/compile/glsl_run.h"
#include "shader/compile/shader_sources.h"
#include "shader/worker/worker_process.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft::shader {

struct CompiledStage {
    ShaderStage stage = ShaderStage::compute;
    const SourceText* source = nullptr;
    std::vector<uint32_t> spirv;
    std::set<std::string> unplaced;  // stage inputs and outputs that state no location
};

// For one thread.
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
