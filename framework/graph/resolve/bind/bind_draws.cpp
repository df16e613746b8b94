#include <algorithm>
#include <cmath>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/shape/shape_imports.h"

namespace weft {
namespace {

void report_bad_list(PassBinding& pass, const std::string& list, SourceLoc loc) {
    std::vector<std::string> lists;
    for (const auto& [name, import] : pass.declared.input.graph.imports) {
        if (is_draw_list(import)) lists.push_back(name);
    }
    const auto& imports = pass.declared.input.graph.imports;
    const bool wrong_kind = imports.contains(list);
    Diagnostic& d = pass.error(loc, "W118",
                               "pass " + quote(pass.draft.decl.name) + " draws " + quote(list) +
                                   (wrong_kind ? ", which is imported as " + quote(imports.at(list).kind)
                                               : ", which is not imported"));
    const std::string near = did_you_mean_text(list, lists);
    const auto catalogued = pass.declared.input.imports.imports.find(list);
    if (catalogued != pass.declared.input.imports.imports.end() && !wrong_kind) {
        add_help(d, "add the draw list to \"imports\": " + quote(list) + ": \"drawlist\"");
    } else {
        add_help(d, near.empty() ? "the imported draw lists are " + quote_all(lists) : near);
    }
}

// Returns true if the numeric class (float, signed or unsigned integer) of the shader input differs from that
// of the vertex attribute.
bool has_other_class(const StageVariable& input, Format format) {
    if (format == Format::undefined) return false;
    switch (format_info(format).numeric) {
        case NumericClass::sint:
            return input.scalar != ScalarType::i32;
        case NumericClass::uint:
            return input.scalar != ScalarType::u32;
        default:
            return input.scalar != ScalarType::f32;
    }
}

void report_other_class(PassBinding& pass, const std::string& list, const StageVariable& input,
                        const VertexAttribute& offered) {
    const auto type = [](ScalarType scalar) {
        return scalar == ScalarType::i32 ? "int" : scalar == ScalarType::u32 ? "uint" : "float";
    };
    const PassDesc& desc = *pass.draft.desc;
    Diagnostic& d = pass.error(desc.shader_loc, "W167",
                               "shader " + quote(desc.shader) + " reads vertex input " + quote(input.name) +
                                   " as " + type(input.scalar) + ", but in draw list " + quote(list) +
                                   " it has the format " + std::string(format_info(offered.format).name));
    add_help(d, "give the input of the shader the type of the format: float, uint or int, or a vector of it");
}

// Checks that the meshes of a draw list have each vertex input of the shader. Vertex inputs are bound by
// name.
void check_vertex_inputs(PassBinding& pass, const std::string& list) {
    const ShaderInterface* shader = pass.draft.shader;
    const auto import = pass.declared.input.imports.imports.find(list);
    if (!shader || import == pass.declared.input.imports.imports.end()) return;
    const std::vector<VertexAttribute>& offered_attributes = import->second.vertex_format.attributes;
    if (offered_attributes.empty()) return;
    std::vector<std::string> names;
    for (const VertexAttribute& attribute : offered_attributes) names.push_back(attribute.name);
    for (const StageVariable& input : shader->vertex_inputs) {
        const PassDesc& desc = *pass.draft.desc;
        const auto offered = std::ranges::find(offered_attributes, input.name, &VertexAttribute::name);
        if (offered != offered_attributes.end()) {
            if (has_other_class(input, offered->format)) report_other_class(pass, list, input, *offered);
            continue;
        }
        Diagnostic& d =
            pass.error(desc.shader_loc, "W167",
                       "shader " + quote(desc.shader) + " reads vertex input " + quote(input.name) +
                           ", but draw list " + quote(list) + " does not contain it");
        add_help(d, did_you_mean_text(input.name, names));
        add_help(d, "the vertex inputs of the draw list are " + quote_all(names));
    }
}

// Checks the shader of a draw without a draw list. Such a draw has no vertex buffers, and neither descriptor
// set 2 (material) nor descriptor set 3 (instance data). So the shader must not read any of them.
void check_procedural_shader(PassBinding& pass) {
    const ShaderInterface* shader = pass.draft.shader;
    if (!shader) return;
    const PassDesc& desc = *pass.draft.desc;
    const std::string reads = "shader " + quote(desc.shader) + " reads ";
    std::string what;
    if (!shader->vertex_inputs.empty()) what = "vertex input " + quote(shader->vertex_inputs.front().name);
    for (const ShaderBinding& binding : shader->bindings)
        if (what.empty() && binding.set >= 2) what = "descriptor set " + std::to_string(binding.set);
    if (what.empty()) return;
    Diagnostic& d =
        pass.error(desc.shader_loc, "W167",
                   reads + what + ", but \"draws\" of this pass names no draw list, so it has no such input");
    add_help(d,
             "compute vertices from gl_VertexIndex and gl_InstanceIndex, or list draw lists in \"draws\", "
             "for example \"draws\": [\"opaque\"]");
}

// Evaluates the numbers of vertices and instances of a draw without a draw list.
void count_vertices(PassBinding& pass) {
    constexpr double kMost = 1 << 24;
    const PassDesc& desc = *pass.draft.desc;
    const auto count = [&](const Expr& expression, const char* what) -> uint32_t {
        if (expression.empty()) return 1;
        const std::optional<ExprValue> value = pass.evaluator.value(expression);
        if (!value) return 1;
        const double whole = std::ceil(value->x);
        if (!value->is_size && whole >= 1 && whole <= kMost) return static_cast<uint32_t>(whole);
        Diagnostic& d = pass.error(expression.loc, "W114",
                                   "pass " + quote(pass.draft.decl.name) + " would draw " +
                                       (value->is_size ? "a size" : number_text(whole)) + " " + what);
        add_help(d, value->is_size ? "use .x or .y of the size" : "choose a whole number from 1 to 16777216");
        return 1;
    };
    pass.bound.vertices = count(desc.vertices, "vertices");
    pass.bound.instances = count(desc.instances, "instances");
    check_procedural_shader(pass);
}

}  // namespace

void bind_draws(PassBinding& pass) {
    const PassDesc& desc = *pass.draft.desc;
    if (!desc.vertices.empty()) {
        count_vertices(pass);
    } else if (desc.draws_without_list()) {
        check_procedural_shader(pass);
    } else if (desc.draws.empty()) {
        Diagnostic& d = pass.error(desc.loc, "W118", "raster pass " + quote(desc.name) + " draws nothing");
        add_help(d, "name the draw lists: \"draws\": [\"opaque\"]");
    }
    for (size_t i = 0; i < desc.draws.size(); ++i) {
        const std::string& list = desc.draws[i];
        const auto import = pass.declared.input.graph.imports.find(list);
        if (import == pass.declared.input.graph.imports.end() || !is_draw_list(import->second)) {
            report_bad_list(pass, list, i < desc.draw_locs.size() ? desc.draw_locs[i] : desc.loc);
            continue;
        }
        check_vertex_inputs(pass, list);
        pass.bound.draw_lists.push_back(list);
    }
}

}  // namespace weft
