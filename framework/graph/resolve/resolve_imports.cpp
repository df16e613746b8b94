// Imports: what the graph asks of the program around it, checked against what that offers.
#include <algorithm>
#include <cmath>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

bool draws_from(const ImportDesc& import) {
    return import.kind == import_kind_name(ImportKind::draw_list);
}

std::vector<std::string> offered_names(const ImportCatalog& catalog) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : catalog.imports) names.push_back(name);
    return names;
}

// Null: reported.
const ImportDecl* offered(ResolveState& state, const ImportDesc& desc) {
    const auto found = state.input.imports.imports.find(desc.name);
    if (found == state.input.imports.imports.end()) {
        Diagnostic& d = state.error(desc.loc, "W118", "nothing offers the import " + quoted(desc.name));
        const std::vector<std::string> names = offered_names(state.input.imports);
        const std::string near = did_you_mean_text(desc.name, names);
        add_help(d, near.empty() ? "offered are " + joined(names) : near);
        return nullptr;
    }
    const ImportDecl& import = found->second;
    if (desc.kind != import_kind_name(import.kind)) {
        Diagnostic& d = state.error(desc.loc, "W118",
                                    "import " + quoted(desc.name) + " is of kind " +
                                        quoted(import_kind_name(import.kind)) + ", not " + quoted(desc.kind));
        add_help(d, "write " + quoted(desc.name) + ": " + quoted(import_kind_name(import.kind)));
        return nullptr;
    }
    return &import;
}

bool has_content(const ResourceDecl& decl) {
    return decl.kind == ResourceKind::buffer || !decl.import ||
           decl.import->entry.layout != Layout::undefined;
}

void report_bad_list(ResolveState& state, PassId pass, const std::string& list, SourceLoc loc) {
    std::vector<std::string> lists;
    for (const auto& [name, import] : state.input.graph.imports) {
        if (draws_from(import)) lists.push_back(name);
    }
    const auto& imports = state.input.graph.imports;
    const bool wrong_kind = imports.contains(list);
    Diagnostic& d =
        state.pass_error(pass, loc, "W118",
                         "pass " + quoted(state.pass_name(pass)) + " draws " + quoted(list) +
                             (wrong_kind ? ", which is imported as " + quoted(imports.at(list).kind)
                                         : ", which is not imported"));
    const std::string near = did_you_mean_text(list, lists);
    const auto catalogued = state.input.imports.imports.find(list);
    if (catalogued != state.input.imports.imports.end() && !wrong_kind) {
        add_help(d, "add it to \"imports\": " + quoted(list) + ": \"drawlist\"");
    } else {
        add_help(d, near.empty() ? "imported draw lists are: " + joined(lists) : near);
    }
}

// Vertex inputs are bound by name to the streams that the list's meshes carry.
void check_vertex_inputs(ResolveState& state, PassId pass, const std::string& list) {
    const ShaderInterface* shader = state.passes[pass].shader;
    const auto import = state.input.imports.imports.find(list);
    if (!shader || import == state.input.imports.imports.end()) return;
    const std::vector<VertexAttribute>& offered_attributes = import->second.vertex_format.attributes;
    if (offered_attributes.empty()) return;
    std::vector<std::string> names;
    for (const VertexAttribute& attribute : offered_attributes) names.push_back(attribute.name);
    for (const StageVariable& input : shader->vertex_inputs) {
        if (std::ranges::find(names, input.name) != names.end()) continue;
        const PassDesc& desc = *state.passes[pass].desc;
        Diagnostic& d =
            state.pass_error(pass, desc.shader_loc, "W167",
                             "shader " + quoted(desc.shader) + " reads vertex input " + quoted(input.name) +
                                 ", which draw list " + quoted(list) + " lacks");
        add_help(d, did_you_mean_text(input.name, names));
        add_help(d, "it offers " + joined(names));
    }
}

// What only a draw list brings: meshes, materials and instances.
void check_procedural_shader(ResolveState& state, PassId pass) {
    const ShaderInterface* shader = state.passes[pass].shader;
    if (!shader) return;
    const PassDesc& desc = *state.passes[pass].desc;
    const std::string reads = "shader " + quoted(desc.shader) + " reads ";
    std::string what;
    if (!shader->vertex_inputs.empty()) what = "vertex input " + quoted(shader->vertex_inputs.front().name);
    for (const ShaderBinding& binding : shader->bindings)
        if (what.empty() && binding.set >= 2) what = "descriptor set " + std::to_string(binding.set);
    if (what.empty()) return;
    Diagnostic& d =
        state.pass_error(pass, desc.shader_loc, "W167", reads + what + ", which draws without a list lack");
    add_help(d, "place vertices by gl_VertexIndex and gl_InstanceIndex, or name a draw list");
}

// So many vertices and instances in place of lists.
void count_vertices(ResolveState& state, PassId pass) {
    constexpr double kMost = 1 << 24;
    const PassDesc& desc = *state.passes[pass].desc;
    PassDecl& decl = state.graph.passes[pass];
    const auto counted = [&](const Expr& count, const char* what) -> uint32_t {
        if (count.empty()) return 1;
        const std::optional<ExprValue> value = state.evaluate_here(count);
        if (!value) return 1;
        const double whole = std::ceil(value->x);
        if (!value->is_size && whole >= 1 && whole <= kMost) return static_cast<uint32_t>(whole);
        Diagnostic& d = state.pass_error(pass, count.loc, "W114",
                                         "pass " + quoted(decl.name) + " would draw " +
                                             (value->is_size ? "a size" : number_text(whole)) + " " + what);
        add_help(d, value->is_size ? "use .x or .y of it" : "1 to 16777216 are possible");
        return 1;
    };
    decl.vertices = counted(desc.vertices, "vertices");
    decl.instances = counted(desc.instances, "instances");
    check_procedural_shader(state, pass);
}

}  // namespace

void resolve_import(ResolveState& state, const ImportDesc& desc, ResourceDecl& decl, ResourceWork& work) {
    const ImportDecl* import = offered(state, desc);
    if (!import) {
        work.suspect_shape = work.suspect_writers = true;
        return;
    }
    decl = import->resource;
    decl.name = desc.name;
    decl.loc = desc.loc;
    decl.lifetime = ResourceLifetime::imported;
    if (!decl.import) decl.import = ImportState{};
    if (import->kind == ImportKind::output) decl.extent = state.input.output_extent;
    if (decl.kind == ResourceKind::image) {
        const FormatInfo& format = format_info(decl.format);
        decl.aspects = static_cast<AspectMask>((format.depth ? aspect::kDepth : 0) |
                                               (format.stencil ? aspect::kStencil : 0));
        if (decl.aspects == 0) decl.aspects = aspect::kColor;
    }
    work.has_content = has_content(decl);
}

void check_draw_list_imports(ResolveState& state) {
    for (const auto& [name, import] : state.input.graph.imports) {
        if (draws_from(import)) offered(state, import);
    }
}

void check_draws(ResolveState& state, PassId pass) {
    const PassDesc& desc = *state.passes[pass].desc;
    PassDecl& decl = state.graph.passes[pass];
    if (!desc.vertices.empty()) {
        count_vertices(state, pass);
    } else if (desc.draws.empty()) {
        Diagnostic& d =
            state.pass_error(pass, desc.loc, "W118", "raster pass " + quoted(desc.name) + " draws nothing");
        add_help(d, "name the draw lists: \"draws\": [\"opaque\"]");
    }
    for (size_t i = 0; i < desc.draws.size(); ++i) {
        const std::string& list = desc.draws[i];
        const auto import = state.input.graph.imports.find(list);
        if (import == state.input.graph.imports.end() || !draws_from(import->second)) {
            report_bad_list(state, pass, list, i < desc.draw_locs.size() ? desc.draw_locs[i] : desc.loc);
            continue;
        }
        check_vertex_inputs(state, pass, list);
        decl.draw_lists.push_back(list);
    }
}

}  // namespace weft
