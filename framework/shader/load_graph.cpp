#include "shader/load_graph.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "graph/stages.h"
#include "shader/glsl_compile.h"

namespace weft {
namespace {

std::optional<ProgramKind> program_kind(const PassDesc& pass) {
    if (pass.type == "compute") return ProgramKind::compute;
    if (pass.type == "fullscreen") return ProgramKind::fullscreen;
    if (pass.type == "raster") return ProgramKind::raster;
    return std::nullopt;
}

void append(Diagnostics& to, Diagnostics from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

// A shader that cannot be found is the graph's fault: the error points there.
void locate(const GraphDesc& graph, const PassDesc& pass, Diagnostics& faults) {
    for (Diagnostic& fault : faults) {
        if (fault.code != "W201") continue;
        Diagnostic located = graph.sources.error(pass.shader_loc, fault.code, fault.message);
        located.pointer = "/passes/" + pass.name + "/shader";
        located.help = std::move(fault.help);
        fault = std::move(located);
    }
}

// Faults of meaning know their place in the text; this adds the place in the document as it is written, and
// the tier in which they are faults.
void complete(const JsonDoc& document, const LoadInput& input, Diagnostics& faults) {
    for (Diagnostic& fault : faults) {
        fault.tier = input.tier;
        if (fault.line == 0) continue;
        std::string pointer = pointer_at(document, fault.file, fault.line, fault.column);
        if (!pointer.empty()) fault.pointer = std::move(pointer);
    }
}

// Merged and parsed: what the author asks for in this tier.
Result<GraphDesc> described(const JsonDoc& document, const LoadInput& input) {
    Result<JsonDoc> merged = merge(document, input.tier);
    if (!merged) return merged.take_errors();
    Result<GraphDesc> desc = parse(*merged);
    if (desc) desc->tier = input.tier;
    return desc;
}

Result<ResolvedGraph> resolved(const GraphDesc& desc, const ShaderCatalog& shaders, const LoadInput& input,
                               Diagnostics& warnings) {
    return resolve({desc, input.passes, shaders, input.imports, input.profile, input.params,
                    input.output_extent, input.observed, input.limits.graph},
                   warnings);
}

bool says_no_compiler(const Diagnostic& fault) {
    return fault.code == "X570";
}

ShaderCatalog compile_shaders(const GraphDesc& graph, const ShaderRoots& roots, ShaderMemory* memory,
                              Diagnostics& faults) {
    ShaderCatalog catalog;
    shader::StageCompiler compiler(roots);
    bool no_compiler = false;  // said once
    for (const auto& [name, pass] : graph.passes) {
        const std::optional<ProgramKind> kind = program_kind(pass);
        if (!kind || pass.shader.empty() || catalog.contains(pass.shader)) continue;
        Result<ShaderProgram> program = compile_shader(pass.shader, *kind, roots, compiler, memory);
        if (program) {
            catalog.emplace(pass.shader, std::move(*program));
            continue;
        }
        Diagnostics errors = program.take_errors();
        if (no_compiler) std::erase_if(errors, says_no_compiler);
        no_compiler = no_compiler || std::ranges::any_of(errors, says_no_compiler);
        locate(graph, pass, errors);
        append(faults, std::move(errors));
        catalog.emplace(pass.shader, ShaderProgram{pass.shader, {}, {}, 0});
    }
    return catalog;
}

}  // namespace

Result<JsonDoc> read_graph(const LoadInput& input) {
    return read_graph(input.path, input.reader, {input.graph_root.string(), input.limits.graph});
}

Result<LoadedGraph> load_graph(const LoadInput& input, Diagnostics& warnings) {
    const Result<JsonDoc> document = read_graph(input);
    return document ? load_graph(*document, input, warnings) : document.errors();
}

Result<LoadedGraph> load_graph(const JsonDoc& document, const LoadInput& input, Diagnostics& warnings) {
    Result<GraphDesc> desc = described(document, input);
    if (!desc) {
        Diagnostics faults = desc.take_errors();
        complete(document, input, faults);
        return faults;
    }

    Diagnostics faults;
    const ShaderRoots roots{{std::filesystem::absolute(input.path).parent_path(), input.shader_root},
                            input.shader_root / "include",
                            input.shader_cache,
                            input.shader_worker,
                            input.limits.shader};
    ShaderCatalog shaders = compile_shaders(*desc, roots, input.memory, faults);
    Result<ResolvedGraph> graph = resolved(*desc, shaders, input, warnings);
    if (!graph) append(faults, graph.take_errors());
    complete(document, input, faults);
    complete(document, input, warnings);
    if (!faults.empty()) return faults;
    return LoadedGraph{std::move(*desc), std::move(shaders), std::move(*graph)};
}

Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                    Diagnostics& warnings) {
    return resolved(loaded.desc, loaded.shaders, input, warnings);
}

}  // namespace weft
