// Purpose: compiles the shader that a graph names to a ShaderProgram: SPIR-V that spirv-val accepts, and the
// interface for matching with ports. Languages: GLSL 4.60 for Vulkan 1.3, SPIR-V 1.6. References: a reference
// is a path in the graph's own folder, or else in shaders/. The extension gives the stage: "sky.frag". For a
// raster pass, "gbuffer" means gbuffer/gbuffer.vert and gbuffer/gbuffer.frag. Bindings: resources without a
// set are ports of the pass. They belong to set 1 and get their bindings in the order of their names, over
// all stages. Resources in sets 0, 2 and 3 keep the binding numbers that the shader gives. Inputs and outputs
// of stages without a location are matched by name. Errors: W201 shader not found, W202 GLSL error, W203
// include not found or outside the folders, W204 invalid SPIR-V, W205 stages that do not match, W206 an
// unsupported interface, W207 a stage takes too much memory or time to compile, W208 a SPIR-V capability that
// is not allowed, W209 variables of a shader need too much memory, X570 the compiler cannot be started.
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

// The folders and limits of a compilation. No file outside these folders is opened, even if a reference, an
// include or a symbolic link names one.
struct ShaderRoots {
    // Folders that are searched in this order: the folder of the file that names the shader, the graph's own
    // folder, then shaders/.
    std::vector<std::filesystem::path> roots;
    std::filesystem::path include_root;  // The folder shaders/include. It also contains fullscreen.vert.
    std::filesystem::path cache_dir;     // Folder for the cache of compiled programs; empty: no cache.
    // Path of the program weft-shader-worker, which compiles programs that are not in the cache. Empty: this
    // process compiles them; then the memory and time that a hostile shader takes are not limited.
    std::filesystem::path worker = {};
    ShaderLimits limits = {};
    ShaderTarget target = {};
    // Further folders to which symbolic links may lead.
    std::vector<std::filesystem::path> allowed = {};
};

enum class ProgramKind : uint8_t {
    compute,  // One compute stage: x.comp.
    // A fragment stage x.frag, drawn with include_root/fullscreen.vert, which outputs `uv` at location 0.
    fullscreen,
    raster,  // A vertex stage x/x.vert and a fragment stage x/x.frag.
};

// Compiles the shader `reference`. The SPIR-V depends on the texts, not on the folders. Thread-safe.
[[nodiscard]] Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind,
                                                   const ShaderRoots& roots);
// Compiles the shader `reference` with an existing compiler, which must be made from the same `roots`. The
// compiler keeps its worker process for all its shaders. `memory` has programs from earlier loads, which are
// not compiled again; it may be null.
[[nodiscard]] Result<ShaderProgram> compile_shader(const std::string& reference, ProgramKind kind,
                                                   const ShaderRoots& roots, shader::StageCompiler& compiler,
                                                   ShaderMemory* memory = nullptr);

// Returns the path of weft-shader-worker: beside the running program, or in `bin/` in `install_folder`. If it
// is in neither folder, the path beside the program is returned, so that the error message can name a place.
[[nodiscard]] std::filesystem::path find_shader_worker(const std::filesystem::path& install_folder = {});

}  // namespace weft
