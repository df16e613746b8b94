#include "load/load_steps.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "graph/parse/debug_view.h"
#include "graph/parse/parse.h"
#include "graph/resolve/resolve.h"
#include "graph/syntax/merge.h"
#include "shader/compile/glsl_compile.h"

namespace weft {
namespace {

std::optional<ProgramKind> program_kind(const PassDesc& pass) {
    if (pass.type == "compute") return ProgramKind::compute;
    if (pass.type == "fullscreen") return ProgramKind::fullscreen;
    if (pass.type == "raster") return ProgramKind::raster;
    return std::nullopt;
}

// A missing shader is a fault of the graph, so the error points to the graph.
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

// Messages name files below the graph's folder in the same way as the graph's own path.
ShaderRoots shader_roots(const LoadInput& input) {
    return {{std::filesystem::path(input.path).parent_path(), input.shader_root},
            input.shader_root / "include",
            input.shader_cache,
            input.shader_worker,
            input.limits.shader,
            shader_target(input.profile)};
}

}  // namespace

void append(Diagnostics& to, Diagnostics from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

Result<GraphDesc> described(const JsonDoc& document, const LoadInput& input) {
    Result<JsonDoc> merged = merge(document, input.tier);
    if (!merged) return merged.take_errors();
    Result<GraphDesc> desc = parse(*merged, input.limits.graph);
    if (!desc) return desc;
    desc->tier = input.tier;
    if (input.debug.empty()) return desc;
    Status added = add_debug_view(*desc, input.imports, input.debug);
    return added ? std::move(desc) : added.take_errors();
}

Result<ResolvedGraph> resolved(const GraphDesc& desc, const ShaderCatalog& shaders, const LoadInput& input,
                               const SkippedFormats& skipped, Diagnostics& warnings) {
    return resolve({.graph = desc,
                    .passes = input.passes,
                    .shaders = shaders,
                    .imports = input.imports,
                    .profile = input.profile,
                    .params = input.params,
                    .output_extent = input.output_extent,
                    .observed = input.observed,
                    .limits = input.limits.graph,
                    .skipped_formats = skipped},
                   warnings);
}

ShaderCatalog compile_shaders(const GraphDesc& graph, const LoadInput& input, Diagnostics& faults) {
    const ShaderRoots roots = shader_roots(input);
    ShaderCatalog catalog;
    std::set<std::pair<std::string, ProgramKind>> known;
    shader::StageCompiler compiler(roots);
    bool no_compiler = false;  // true after the missing compiler was reported
    for (const auto& [name, pass] : graph.passes) {
        const std::optional<ProgramKind> kind = program_kind(pass);
        if (!kind || pass.shader.empty() || !known.emplace(pass.shader, *kind).second) continue;
        Result<ShaderProgram> program = compile_shader(pass.shader, *kind, roots, compiler, input.memory);
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
