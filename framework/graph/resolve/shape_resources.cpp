#include "graph/resolve/shape_resources.h"

#include <algorithm>

#include "graph/parse/reference.h"
#include "graph/resolve/evaluator.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/rings.h"
#include "graph/resolve/shape/shape_imports.h"
#include "graph/resolve/shape/shape_resource.h"

namespace weft {
namespace {

bool uses_mips_of(const ResourceDesc& desc) {
    const auto asks = [](const Expr& e) {
        return std::ranges::any_of(e.postfix, [](const ExprNode& n) { return n.op == ExprOp::mips_of; });
    };
    return asks(desc.size) || asks(desc.mips) || asks(desc.layers) || asks(desc.count);
}

// Returns true if an import is an image or buffer. Draw lists, lists of views and turns (lists of the rounds
// that a group runs) are imports, but not resources.
bool becomes_resource(const ImportDesc& import) {
    return !is_draw_list(import) && !is_view_list(import) && !is_turns(import);
}

// Returns the number of earlier frames that the resource keeps.
uint32_t count_history(const ResourceDesc& desc, const Evaluator& evaluator, Shapes& shapes) {
    if (desc.history.empty()) return 0;
    const std::optional<double> frames =
        evaluator.number(desc.history, "the history of " + quote(desc.name), 0, kMaxHistory);
    const auto copies = static_cast<uint32_t>(frames.value_or(0));
    if (copies > 0) shapes.histories.emplace(desc.name, copies);
    if (!frames) shapes.suspect_histories.insert(desc.name);
    return copies;
}

// One ResourceDecl to be made: an import, a resource, or an earlier frame of a resource with history.
struct Role {
    // The description in the graph file; null for an import.
    const ResourceDesc* desc = nullptr;
    uint32_t age = 0;  // 0: this frame; n: n frames ago.
};

// Lists everything that becomes a ResourceDecl, by name: imports, resources, and the earlier frames of
// resources with history, such as "color[-1]".
std::map<std::string, Role> find_roles(const ResolveInput& input, const Evaluator& evaluator, Shapes& shapes,
                                       Reporter& reporter) {
    std::map<std::string, Role> roles;
    for (const auto& [name, import] : input.graph.imports) {
        if (becomes_resource(import)) roles[name] = {};
    }
    for (const auto& [name, desc] : input.graph.resources) {
        if (input.graph.imports.contains(name)) {
            Diagnostic& d = reporter.error(desc.loc, "W118",
                                           quote(name) + " is the name of both an import and a resource");
            add_help(d, "rename one of the two");
        }
        roles[name] = {&desc, 0};
        const uint32_t copies = count_history(desc, evaluator, shapes);
        for (uint32_t age = 1; age <= copies; ++age) roles[role_name(name, age)] = {&desc, age};
    }
    return roles;
}

void report_too_many(const ResolveInput& input, size_t count, Reporter& reporter) {
    const std::map<std::string, ResourceDesc>& described = input.graph.resources;
    Diagnostic& d = reporter.error(described.empty() ? SourceLoc{} : described.begin()->second.loc, "W125",
                                   "the graph has " + std::to_string(count) +
                                       " resources, where each copy for a history counts; the limit is " +
                                       std::to_string(input.limits.resources));
    add_help(d, "use layers or mips of fewer images, " + raise_limit_text("graph.resources"));
}

void name_resources(const ResolveInput& input, const Evaluator& evaluator, Shapes& shapes,
                    Reporter& reporter) {
    const std::map<std::string, Role> roles = find_roles(input, evaluator, shapes, reporter);
    if (roles.size() > input.limits.resources) {
        shapes.too_large = true;
        report_too_many(input, roles.size(), reporter);
    }
    for (const auto& [name, role] : roles) {
        ResourceDecl decl;
        decl.name = name;
        decl.age = role.age;
        decl.loc = role.desc ? role.desc->loc : input.graph.imports.at(name).loc;
        shapes.resources.push_back(std::move(decl));
        const bool has_file = role.desc && (!role.desc->file.name.empty() || !role.desc->textures.empty());
        shapes.origins.push_back({.desc = role.desc, .has_content = has_file});
    }
    shapes.suspects.shapes.resize(roles.size());
    shapes.suspects.writers.resize(roles.size());
}

// Returns the names of the resources that a readback of the request or a debug view shows, or that the
// program uses between frames.
std::set<std::string> observed_names(const ResolveInput& input) {
    std::set<std::string> names;
    for (const auto& [name, unused] : input.request.exports) names.insert(name);
    for (const std::string& reference : input.request.observed)
        names.insert(reference.substr(0, reference.find_first_of("@[.")));
    for (const auto& [unused, pass] : input.graph.passes)
        for (const PortDesc& port : pass.in)
            if (pass.observes) names.insert(port.ref.name);
    return names;
}

// Makes resources with "history" or "keep" persistent, and links each earlier frame to the resource of the
// current frame (age 0). Also makes the observed resources of groups persistent, because they can be shown
// before a round has run. Called after all resources have their ids.
void tie_rings(const ResolveInput& input, const Evaluator& evaluator, Shapes& shapes) {
    const std::set<std::string> shown = observed_names(input);
    for (ResourceId id(0); id < shapes.resources.size(); ++id) {
        const ResourceDesc* desc = shapes.origins[id].desc;
        if (!desc) continue;
        const auto history = shapes.histories.find(desc->name);
        const uint32_t copies = history != shapes.histories.end() ? history->second : 0;
        const bool observed = !desc->group.empty() && shown.contains(desc->name);
        if (copies == 0 && desc->keep == KeepMode::none && !observed) continue;
        ResourceDecl& decl = shapes.resources[id];
        decl.lifetime = ResourceLifetime::persistent;
        decl.history = copies;
        decl.ring = resource_id(shapes.resources, desc->name);
        if (desc->first_frame && decl.age == 0) decl.first_frame = evaluator.color(*desc->first_frame);
        decl.on_resize = desc->on_resize;
        decl.shared = desc->keep == KeepMode::shared && copies == 0;
        const bool keeps = desc->keep != KeepMode::none;
        shapes.origins[id].has_content = (decl.age > 0 || copies == 0 || keeps) && !observed;
    }
}

void shape_all_imports(const ResolveInput& input, Shapes& shapes, Reporter& reporter) {
    for (ResourceId id(0); id < shapes.resources.size(); ++id) {
        ResourceDecl& decl = shapes.resources[id];
        if (shapes.origins[id].desc) continue;
        shape_import(input, input.graph.imports.at(decl.name), id, shapes, reporter);
        if (decl.lifetime == ResourceLifetime::imported && decl.kind == ResourceKind::image)
            shapes.mip_counts[decl.name] = decl.mips;
    }
}

void check_exports(const ResolveInput& input, Reporter& reporter) {
    for (const auto& [name, unused] : input.request.exports) {
        if (input.graph.resources.contains(name)) continue;
        const bool import = input.graph.imports.contains(name);
        Diagnostic& d = reporter.error(SourceLoc{}, "W243",
                                       "the program exports " + quote(name) +
                                           (import ? ", which is an import: the program has it already"
                                                   : ", which the graph does not have"));
        std::vector<std::string> names;
        for (const auto& [resource, desc] : input.graph.resources) names.push_back(resource);
        const std::string near = did_you_mean_text(name, names);
        add_help(d, near.empty() ? "the resources of the graph are " + quote_all(names) : near);
    }
}

ResourceId find_output(const ResolveInput& input, const Shapes& shapes) {
    const auto output = std::ranges::find_if(input.graph.imports, [](const auto& import) {
        return import.second.kind == import_kind_name(ImportKind::output);
    });
    return output == input.graph.imports.end() ? kNoId : resource_id(shapes.resources, output->first);
}

}  // namespace

Shapes shape_resources(const ResolveInput& input, const Values& values, Reporter& reporter) {
    Shapes shapes;
    const Evaluator evaluator(values, shapes, shapes.suspects, reporter);
    name_resources(input, evaluator, shapes, reporter);
    tie_rings(input, evaluator, shapes);
    check_list_imports(input, reporter);
    check_exports(input, reporter);
    shape_all_imports(input, shapes, reporter);
    // The first iteration handles the resources that do not use mips(); the second handles those whose size
    // depends on the mip count of another resource.
    for (const bool second : {false, true}) {
        for (ResourceId id(0); id < shapes.resources.size(); ++id) {
            const ResourceDesc* desc = shapes.origins[id].desc;
            if (!desc || shapes.resources[id].age > 0) continue;
            if (uses_mips_of(*desc) == second) shape_resource(input, values, id, shapes, reporter);
        }
    }
    spread_over_rings(shapes.resources, shapes.suspects);
    shapes.output = find_output(input, shapes);
    return shapes;
}

ResourceId resource_id(const std::vector<ResourceDecl>& resources, std::string_view name) {
    const auto it =
        std::lower_bound(resources.begin(), resources.end(), name,
                         [](const ResourceDecl& resource, std::string_view n) { return resource.name < n; });
    if (it == resources.end() || it->name != name) return kNoId;
    return static_cast<ResourceId>(it - resources.begin());
}

std::vector<std::string> resource_names(const std::vector<ResourceDecl>& resources) {
    std::vector<std::string> known;
    for (const ResourceDecl& resource : resources) {
        if (resource.age == 0) known.push_back(resource.name);
    }
    return known;
}

}  // namespace weft
