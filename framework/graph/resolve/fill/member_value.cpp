#include "graph/resolve/fill/member_value.h"

#include <algorithm>
#include <string_view>

#include "graph/diagnostics/whole_number.h"
#include "graph/parse/module_scope.h"

namespace weft {
namespace {

constexpr std::string_view kDrawsSuffix = "Draws";
constexpr std::string_view kViewsSuffix = "Views";
constexpr std::string_view kTexturesSuffix = "Count";

// Returns true if the name stands for the number of draws in an imported draw list. Example: "opaqueDraws"
// for the list "opaque". Returns false if the graph defines a size with this name.
bool counts_draws(const GraphDesc& graph, std::string_view name) {
    if (!name.ends_with(kDrawsSuffix) || graph.sizes.contains(std::string(name))) return false;
    name.remove_suffix(kDrawsSuffix.size());
    const auto import = graph.imports.find(std::string(name));
    return import != graph.imports.end() && import->second.kind == import_kind_name(ImportKind::draw_list);
}

// Returns true if the name stands for the number of views in a list, for example "lampFacesViews".
bool counts_views(const Declared& declared, std::string_view name) {
    if (!name.ends_with(kViewsSuffix) || declared.input.graph.sizes.contains(std::string(name))) return false;
    name.remove_suffix(kViewsSuffix.size());
    const auto list = declared.values.views.find(name);
    return list != declared.values.views.end() && !list->second.single;
}

// Returns true if the name stands for the number of textures in a table, for example "materialTexturesCount".
bool counts_textures(const GraphDesc& graph, std::string_view name) {
    if (!name.ends_with(kTexturesSuffix) || graph.sizes.contains(std::string(name))) return false;
    name.remove_suffix(kTexturesSuffix.size());
    const auto import = graph.imports.find(std::string(name));
    if (import != graph.imports.end()) return import->second.kind == import_kind_name(ImportKind::textures);
    const auto resource = graph.resources.find(std::string(name));
    return resource != graph.resources.end() && !resource->second.textures.empty();
}

std::vector<double> evaluate_components(const ParamValueDesc& param, const Evaluator& evaluator) {
    std::vector<double> components;
    for (const Expr& component : param.components) {
        const std::optional<ExprValue> value = evaluator.value(component);
        if (!value) return {};
        components.push_back(value->x);
        if (value->is_size) components.push_back(value->y);
    }
    return components;
}

}  // namespace

std::optional<MemberValue> member_value(const Declared& declared, const PassDraft& draft,
                                        const Evaluator& evaluator, const std::string& member) {
    const auto param = std::ranges::find(draft.desc->params, member, &ParamValueDesc::name);
    if (param != draft.desc->params.end())
        return MemberValue{&*param, evaluate_components(*param, evaluator)};
    const GraphDesc& graph = declared.input.graph;
    const bool is_index = draft.indices.contains(member);
    const std::string name = is_index ? member : name_in_module(graph, draft.desc->module, member);
    const bool named = is_index || graph.params.contains(name) || graph.consts.contains(name) ||
                       counts_draws(graph, name) || counts_views(declared, name) ||
                       counts_textures(graph, name);
    if (!named) return std::nullopt;
    const std::optional<ExprValue> value = evaluator.find(name);
    if (!value) return std::nullopt;
    return MemberValue{nullptr, {value->x}};
}

bool fits_member(ScalarType scalar, double value) {
    if (scalar == ScalarType::f32) return fits_into_float(value);
    return scalar == ScalarType::boolean || fits_into<int32_t>(value) || fits_into<uint32_t>(value);
}

}  // namespace weft
