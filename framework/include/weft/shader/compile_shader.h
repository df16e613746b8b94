// Purpose: compiles a graph's shader reference to a ShaderProgram: SPIR-V that spirv-val accepts, and the
// interface for matching. GLSL 4.60 for Vulkan 1.3, SPIR-V 1.6. References: a path below the graph's own
// folder, then below shaders/. The extension determines the stage: "sky.frag". For raster programs "gbuffer"
// means gbuffer/gbuffer.vert and gbuffer/gbuffer.frag. Numbers: resources without a set are the pass's ports
// and belong to set 1, where bindings are assigned by name over all stages; sets 0, 2 and 3 keep their
// numbers. Stage inputs and outputs without a location are matched by name. Errors: W201 shader not found,
// W202 GLSL error, W203 include not found or outside the roots, W204 invalid SPIR-V, W205 stages that do not
// match, W206 an unsupported interface, W207 a stage that takes too much memory or time to compile, W208 a
// SPIR-V capability that is not allowed, W209 too much memory for its own variables, X570 the compiler cannot
// be started.
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

// No file outside these folders is opened, whatever references, includes or links contain.
struct ShaderRoots {
    std::vector<std::filesystem::path> roots;  // searched in order: the graph's own folder, then shaders/
    std::filesystem::path include_root;        // shaders/include; also holds fullscreen.vert
    std::filesystem::path cache_dir;           // cache of compiled programs; empty: no cache
    // The program weft-shader-worker, which compiles programs that are not in the cache. Empty: this process
    // compiles them, and the memory and time of a hostile shader are not limited.
    std::filesystem::path worker = {};
    ShaderLimits limits = {};
    ShaderTarget target = {};
};

enum class ProgramKind : uint8_t {
    compute,     // x.comp
    fullscreen,  // x.frag, drawn with include_root/fullscreen.vert, which outputs `uv` at location 0
    raster,      // x/x.vert and x/x.frag
};

// Deterministic: equal contents give equal SPIR-V, wherever the roots are. Thread-safe.
[[nodiscard]] Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind,
                                                   const ShaderRoots& roots);
// Uses a compiler made from the same roots, whose worker is reused, and programs kept from earlier loads;
// `memory` may be null.
[[nodiscard]] Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind,
                                                   const ShaderRoots& roots, shader::StageCompiler& compiler,
                                                   ShaderMemory* memory = nullptr);

// The path of weft-shader-worker: beside the running program, or in `bin/` below `install_folder`. If it is
// in neither, the path beside the program is returned, so that the error can name a place.
[[nodiscard]] std::filesystem::path find_shader_worker(const std::filesystem::path& install_folder = {});

}  // namespace weft
