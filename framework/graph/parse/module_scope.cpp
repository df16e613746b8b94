#include "graph/parse/module_scope.h"

#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

constexpr const char* kRenderName = "render";
constexpr std::string_view kViewCount = "Views";

bool declares_value(const GraphDesc& graph, const std::string& name) {
    if (graph.params.contains(name) || graph.consts.contains(name) || graph.sizes.contains(name)) return true;
    return name.ends_with(kViewCount) &&
           graph.views.contains(name.substr(0, name.size() - kViewCount.size()));
}

}  // namespace

std::string_view module_of(const GraphDesc& graph, std::string_view part) {
    if (graph.modules.empty()) return {};
    for (size_t end = part.rfind(kInGroup); end != std::string_view::npos && end > 0;
         end = part.rfind(kInGroup, end - 1))
        if (graph.modules.contains(std::string(part.substr(0, end)))) return part.substr(0, end);
    return {};
}

std::string name_in_module(const GraphDesc& graph, std::string_view module, const std::string& name) {
    if (module.empty()) return name;
    const ModuleDesc& owner = graph.modules.at(std::string(module));
    if (const auto port = owner.values.find(name); port != owner.values.end()) return port->second;
    std::string full = name_in_group(module, name);
    if (declares_value(graph, full)) return full;
    if (name == kRenderName) return name_in_module(graph, owner.parent, name);
    return declares_value(graph, name) ? full : name;
}

std::string render_size_name(const GraphDesc& graph, std::string_view resource) {
    return name_in_module(graph, module_of(graph, resource), kRenderName);
}

}  // namespace weft
