#include "shader/load_graph.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "graph/debug_view.h"
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
    if (!desc) return desc;
    desc->tier = input.tier;
    if (input.debug.empty()) return desc;
    Status added = add_debug_view(*desc, input.imports, input.debug);
    return added ? std::move(desc) : added.take_errors();
}

using SkippedFormats = std::map<std::string, size_t>;

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

bool says_no_compiler(const Diagnostic& fault) {
    return fault.code == "X570";
}

// A shader that passes of several types name is compiled for each: all but one of them get a message.
ShaderCatalog compile_shaders(const GraphDesc& graph, const ShaderRoots& roots, ShaderMemory* memory,
                              Diagnostics& faults) {
    ShaderCatalog catalog;
    std::set<std::pair<std::string, ProgramKind>> known;
    shader::StageCompiler compiler(roots);
    bool no_compiler = false;  // said once
    for (const auto& [name, pass] : graph.passes) {
        const std::optional<ProgramKind> kind = program_kind(pass);
        if (!kind || pass.shader.empty() || !known.emplace(pass.shader, *kind).second) continue;
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
        catalog[pass.shader] = ShaderProgram{pass.shader, {}, {}, 0};
    }
    return catalog;
}

ShaderRoots shader_roots(const LoadInput& input) {
    return {{std::filesystem::absolute(input.path).parent_path(), input.shader_root},
            input.shader_root / "include",
            input.shader_cache,
            input.shader_worker,
            input.limits.shader};
}

bool has_alternatives(const GraphDesc& desc) {
    return std::ranges::any_of(desc.resources, [](const auto& r) { return r.second.formats.size() > 1; });
}

// One tier of a graph, for what it does with its images.
struct Variant {
    GraphDesc desc;
    ShaderCatalog shaders;
};

// Of tiers with faults nothing is asked: whoever loads them hears of the faults.
std::vector<Variant> other_tiers(const JsonDoc& document, LoadInput input) {
    std::vector<Variant> others;
    std::vector<std::string> names = tier_names(document);
    names.emplace_back();
    std::erase(names, input.tier);
    input.debug.clear();
    for (const std::string& name : names) {
        input.tier = name;
        Result<GraphDesc> desc = described(document, input);
        if (!desc) continue;
        Diagnostics faults;
        ShaderCatalog shaders = compile_shaders(*desc, shader_roots(input), input.memory, faults);
        if (faults.empty()) others.push_back({std::move(*desc), std::move(shaders)});
    }
    return others;
}

// Raises `skipped` to the formats that were chosen; true when that changed anything.
bool raise(const GraphDesc& desc, const ResolvedGraph& graph, SkippedFormats& skipped) {
    bool changed = false;
    for (const auto& [name, resource] : desc.resources) {
        const ResourceDecl* decl = find_resource(graph, name);
        if (decl == nullptr || resource.formats.size() < 2) continue;
        const std::string chosen(format_info(decl->format).name);
        const auto at =
            static_cast<size_t>(std::ranges::find(resource.formats, chosen) - resource.formats.begin());
        size_t& least = skipped[name];
        changed = changed || at > least;
        least = std::max(least, at);
    }
    return changed;
}

// A format with alternatives is the first that the device supports for what any tier does with it: so images
// keep their contents from tier to tier.
SkippedFormats common_formats(const JsonDoc& document, const Variant& own, const LoadInput& input) {
    SkippedFormats skipped;
    if (tier_names(document).empty() || !has_alternatives(own.desc)) return skipped;
    const std::vector<Variant> others = other_tiers(document, input);
    LoadInput unobserved = input;
    unobserved.observed.clear();
    unobserved.params.clear();
    bool changed = true;
    while (changed) {
        changed = false;
        Diagnostics unheard;
        for (const Variant& variant : others) {
            const Result<ResolvedGraph> graph =
                resolved(variant.desc, variant.shaders, unobserved, skipped, unheard);
            if (graph) changed = raise(variant.desc, *graph, skipped) || changed;
        }
        const Result<ResolvedGraph> graph = resolved(own.desc, own.shaders, input, skipped, unheard);
        if (graph) changed = raise(own.desc, *graph, skipped) || changed;
    }
    return skipped;
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
    Variant own{std::move(*desc), {}};
    own.shaders = compile_shaders(own.desc, shader_roots(input), input.memory, faults);
    SkippedFormats skipped = faults.empty() ? common_formats(document, own, input) : SkippedFormats{};
    Result<ResolvedGraph> graph = resolved(own.desc, own.shaders, input, skipped, warnings);
    if (!graph) append(faults, graph.take_errors());
    complete(document, input, faults);
    complete(document, input, warnings);
    if (!faults.empty()) return faults;
    return LoadedGraph{std::move(own.desc), std::move(own.shaders), std::move(*graph), std::move(skipped)};
}

Result<ResolvedGraph> resolve_again(const LoadedGraph& loaded, const LoadInput& input,
                                    Diagnostics& warnings) {
    return resolved(loaded.desc, loaded.shaders, input, loaded.skipped_formats, warnings);
}

}  // namespace weft
