#include "load/load_steps.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "graph/parse/parse.h"
#include "graph/syntax/merge.h"
#include "load/measure_files.h"
#include "load/place_shaders.h"
#include "shader/compile/glsl_compile.h"

namespace weft {
namespace {

std::optional<ProgramKind> program_kind(const PassDesc& pass) {
    if (pass.type == "compute") return ProgramKind::compute;
    if (pass.type == "fullscreen") return ProgramKind::fullscreen;
    if (pass.type == "raster") return ProgramKind::raster;
    return std::nullopt;
}

// Moves the error W201 (shader not found) to the place in the graph that names the shader, because the fault
// is in the graph.
void locate(const GraphDesc& graph, const PassDesc& pass, Diagnostics& faults) {
    for (Diagnostic& fault : faults) {
        if (fault.code != "W201") continue;
        Diagnostic located = graph.sources.error(pass.shader_loc, fault.code, fault.message);
        located.pointer = "/passes/" + pass.name + "/shader";
        located.help = std::move(fault.help);
        fault = std::move(located);
    }
}

bool says_no_compiler(const Diagnostic& fault) {
    return fault.code == "X570";
}

// The folder of the graph is taken from the request unchanged, so that messages name shader files with the
// path that the user gave (relative or absolute). `beside` is the folder of an included file; empty: none.
ShaderRoots shader_roots(const LoadInput& input, const std::string& beside) {
    const LoadSettings& settings = input.settings;
    ShaderRoots roots{{std::filesystem::path(input.request.path).parent_path(), settings.shader_root},
                      settings.shader_root / "include",
                      settings.shader_cache,
                      settings.shader_worker,
                      settings.limits.shader,
                      shader_target(input.profile),
                      settings.graph_path};
    if (!beside.empty()) roots.roots.insert(roots.roots.begin(), beside);
    return roots;
}

}  // namespace

void append(Diagnostics& to, Diagnostics from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

Result<GraphDesc> parse_tier(const JsonDoc& document, const std::string& tier, const LoadSettings& settings,
                             std::set<std::filesystem::path>* searched) {
    Result<JsonDoc> merged = merge(document, tier);
    if (!merged) return merged.take_errors();
    Result<GraphDesc> desc = parse(*merged, settings.limits.graph);
    if (!desc) return desc;
    desc->tier = tier;
    Diagnostics faults;
    place_shaders(*desc, settings);
    measure_files(*desc, settings, searched, faults);
    if (!faults.empty()) return faults;
    return desc;
}

ResolveInput resolve_input(const GraphDesc& desc, const ShaderCatalog& shaders, const LoadInput& input,
                           const SkippedFormats& skipped) {
    return {.graph = desc,
            .passes = input.passes,
            .shaders = shaders,
            .imports = input.imports,
            .profile = input.profile,
            .request = input.request,
            .limits = input.settings.limits.graph,
            .skipped_formats = skipped};
}

Result<ResolvedGraph> resolve_formats(const GraphDesc& desc, const ShaderCatalog& shaders,
                                      const LoadInput& input, const SkippedFormats& skipped,
                                      Diagnostics& warnings) {
    return resolve(resolve_input(desc, shaders, input, skipped), warnings);
}

ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input, Diagnostics& faults) {
    ShaderCatalog catalog;
    std::set<std::pair<std::string, ProgramKind>> known;
    shader::StageCompiler compiler(shader_roots(input, {}));
    // True after the error "no compiler" (X570) was reported once. It is not repeated for other shaders.
    bool no_compiler = false;
    for (const auto& [name, pass] : graph.passes) {
        const std::optional<ProgramKind> kind = program_kind(pass);
        if (!kind || pass.shader.empty() || !known.emplace(pass.shader, *kind).second) continue;
        const std::string& reference = pass.shader_folder.empty() ? pass.shader : pass.shader_in_folder;
        Result<ShaderProgram> program =
            compile_shader(reference, *kind, shader_roots(input, pass.shader_folder), compiler, input.memory);
        if (program) {
            catalog.emplace(pass.shader, std::move(*program));
            continue;
        }
        Diagnostics errors = program.take_errors();
        if (no_compiler) std::erase_if(errors, says_no_compiler);
        no_compiler = no_compiler || std::ranges::any_of(errors, says_no_compiler);
        locate(graph, pass, errors);
        append(faults, std::move(errors));
        catalog[pass.shader] = ShaderProgram{pass.shader, {}, {}, 0};
    }
    return catalog;
}

}  // namespace weft
