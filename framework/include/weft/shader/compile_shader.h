// Purpose: a shader reference of a graph becomes a ShaderProgram: SPIR-V that passed spirv-val, and the
// interface that graphs are matched against. GLSL 4.60 for Vulkan 1.3, SPIR-V 1.6. References: a path under
// the graph's own folder, then under shaders/. The extension is the stage: "sky.frag". For raster programs
// "gbuffer" means gbuffer/gbuffer.vert and gbuffer/gbuffer.frag. Numbers: resources without a set are the
// pass's ports and go to set 1, where bindings are dealt out by name over all stages; sets 0, 2 and 3 keep
// what they say. Stage inputs and outputs without a location are joined by name. Errors: W201 shader not
// found, W202 GLSL error, W203 include not found or outside the roots, W204 invalid SPIR-V, W205 stages that
// do not fit together, W206 an interface that no pass can offer, W207 a stage that takes too much memory or
// time to compile, W208 a
// capability of SPIR-V that is not allowed, W209 too much memory for its own variables, X570 no compiler to
// start.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/shader/shader_target.h"
#include "weft/shader_interface.h"

namespace weft {

namespace shader {
class StageCompiler;
}
class ShaderMemory;

// No file outside these folders is ever opened, whatever references, includes or links say.
struct ShaderRoots {
    std::vector<std::filesystem::path> roots;  // searched in order: the graph's own folder, then shaders/
    std::filesystem::path include_root;        // shaders/include; also holds fullscreen.vert
    std::filesystem::path cache_dir;           // compiled programs by content; empty: no cache
    // The program weft-shader-worker, which compiles what is not in the cache. Empty: this process does,
    // where nothing limits the memory and the time that a hostile shader takes.
    std::filesystem::path worker = {};
    ShaderLimits limits = {};
    ShaderTarget target = {};
};

enum class ProgramKind : uint8_t {
    compute,     // x.comp
    fullscreen,  // x.frag, drawn with include_root/fullscreen.vert, which gives it `uv` at location 0
    raster,      // x/x.vert and x/x.frag
};

// Deterministic: equal contents give equal words, wherever the roots lie. Safe to call from several threads.
[[nodiscard]] Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind,
                                                   const ShaderRoots& roots);
// With a compiler made from the same roots, whose worker lives on for the next one, and with what earlier
// loads left; `memory` may be null.
[[nodiscard]] Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind,
                                                   const ShaderRoots& roots, shader::StageCompiler& compiler,
                                                   ShaderMemory* memory = nullptr);

// Where weft-shader-worker is: beside the running program, or else in `bin/` below `install_folder`; beside
// the program too when it is in neither, so that the error names a place.
[[nodiscard]] std::filesystem::path find_shader_worker(const std::filesystem::path& install_folder = {});

}  // namespace weft
