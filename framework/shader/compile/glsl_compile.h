// Purpose: compiles stages of GLSL to SPIR-V. This happens in the worker program, which has limits on memory
// and processor time. If ShaderRoots::worker is empty, it happens in this process. A SourceReader reads the
// included files. The worker starts with the first stage and compiles all later stages, too. If the worker
// stopped or had to be killed, the next stage starts a new one. Binding numbers and missing locations in the
// SPIR-V are provisional until link_stages() assigns them. Errors: W202 GLSL error, W203 the included file
// does not exist or is outside the allowed folders, W207 the worker crashed or exceeded its limits, X570 the
// worker cannot be started.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "shader/compile/shader_sources.h"
#include "shader/worker/glsl_run.h"
#include "shader/worker/worker_process.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft::shader {

struct CompiledStage {
    ShaderStage stage = ShaderStage::compute;
    const SourceText* source = nullptr;
    std::vector<uint32_t> spirv;
    std::set<std::string> unplaced;  // Names of stage inputs and outputs whose declaration has no location.
};

// Compiles the stages of several programs. The class is not thread-safe: each thread needs its own object.
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
