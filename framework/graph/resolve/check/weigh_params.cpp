// Finds how much work a change of each parameter causes, from the places in the graph that use the parameter
// directly or through constants and sizes.
#include <algorithm>

#include "graph/parse/module_scope.h"
#include "graph/resolve/check/resource_names.h"
#include "graph/resolve/checks.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

class ParamCosts {
 public:
    explicit ParamCosts(const ResolveInput& input) : input_(input), graph_(input.graph) {}

    void gather() {
        for (const auto& [name, resource] : graph_.resources) add_resource(resource);
        for (const auto& [name, pass] : graph_.passes) add_pass(pass);
        for (const auto& [name, group] : graph_.groups)
            for (const Expr* expression : {&group.per_frame, &group.warm_up, &group.settle})
                add(*expression, ParamCost::graph);
        for (const auto& [name, list] : graph_.views) add_view_list(list);
        for (const auto& [name, view] : graph_.debug) add_view(view);
        add(graph_.frames, ParamCost::live);
    }

    // Returns the cost of a change of the parameter. A live size is a size that is multiplied by a parameter,
    // its scale. For such a scale, the cost is at most ParamCost::live, because the plan is made with the
    // value 1 for all scales.
    ParamCost cost_of(const std::string& name) const {
        const auto found = costs_.find(name);
        if (found == costs_.end()) return ParamCost::nothing;
        const bool scales = std::ranges::any_of(graph_.size_scales,
                                                [&](const auto& size) { return size.second.param == name; });
        return scales ? std::min(found->second, ParamCost::live) : found->second;
    }

    // Warns about names that nothing uses. Gives no warnings if an error may hide a use, and none for names
    // that an included file declares.
    void warn(Reporter& reporter) const {
        if (is_unknown_ || reporter.has_errors()) return;
        for (const auto& [name, param] : graph_.params)
            if (!costs_.contains(name) && !is_included(graph_.sources, param.loc))
                reporter.warn(
                    param.loc, "W132", "no pass or expression uses parameter " + quote(name),
                    unused_help(name,
                                "remove the parameter, or use it in an expression or in Params of a shader"));
        for (const auto* named : {&graph_.consts, &graph_.sizes})
            for (const auto& [name, expression] : *named)
                if (!costs_.contains(name) && !is_included(graph_.sources, expression.loc))
                    reporter.warn(expression.loc, "W133",
                                  "no expression uses " +
                                      std::string(named == &graph_.consts ? "constant " : "size ") +
                                      quote(name),
                                  unused_help(name, "remove this line, or use the name in an expression"));
        const ResourceNames named = named_resources();
        // An output import that no pass writes is an error, W184, so it needs no warning.
        const char* output = import_kind_name(ImportKind::output);
        for (const auto& [name, import] : graph_.imports)
            if (import.kind != output && !named.contains(name) && !costs_.contains(name + "Draws") &&
                !costs_.contains(name + "Views") && !costs_.contains(name + "Count") &&
                !is_included(graph_.sources, import.loc))
                reporter.warn(import.loc, "W134",
                              (import.kind == "turns" ? "no group" : "no pass") +
                                  std::string(" uses the import ") + quote(name),
                              import.kind == "turns" ? "remove the import, or use it in \"turns\" of a group"
                              : import.kind == import_kind_name(ImportKind::views)
                                  ? "remove the import, or use it in \"view\" or \"views\" of a pass"
                                  : "remove the import, or use it in a port or in \"draws\"");
    }

 private:
    // Returns the help for a name that nothing uses. If the name belongs to a module, it may be the misspelt
    // name of a part that this module declares.
    std::string unused_help(const std::string& name, const std::string& usual) const {
        if (name.find(kInGroup) == std::string::npos) return usual;
        std::vector<std::string> used;
        for (const auto& [other, cost] : costs_)
            if (other != name && other.find(kInGroup) != std::string::npos) used.push_back(other);
        const std::string near = did_you_mean_text(name, used);
        return near.empty() ? usual : near;
    }

    // Records that `name` is used at a place where a change has the given cost. If `name` is a constant or
    // size, the same holds for all names in its definition.
    void add_name(const std::string& name, ParamCost cost) {
        const auto [known, is_new] = costs_.try_emplace(name, cost);
        if (!is_new && known->second >= cost) return;
        known->second = cost;
        const auto constant = graph_.consts.find(name);
        if (constant != graph_.consts.end()) add(constant->second, cost);
        const auto size = graph_.sizes.find(name);
        if (size != graph_.sizes.end()) add(size->second, cost);
        const auto scale = graph_.size_scales.find(name);
        if (scale != graph_.size_scales.end()) add_name(scale->second.param, ParamCost::live);
    }

    void add(const Expr& expression, ParamCost cost) {
        for (const ExprNode& node : expression.postfix)
            if (node.op == ExprOp::name) add_name(node.name, cost);
    }

    void add(const std::optional<ColorDesc>& color) {
        if (!color) return;
        for (const Expr& channel : color->channels) add(channel, ParamCost::graph);
    }

    void add(const RefDesc& ref) {
        for (const std::optional<Expr>* bound : {&ref.mip_first, &ref.mip_last, &ref.layer_first,
                                                 &ref.layer_last, &ref.element_first, &ref.element_last})
            if (*bound) add(**bound, ParamCost::graph);
    }

    void add_resource(const ResourceDesc& resource) {
        for (const Expr* expression : {&resource.size, &resource.mips, &resource.layers, &resource.samples,
                                       &resource.count, &resource.history})
            add(*expression, ParamCost::graph);
        if (resource.size.empty() && !resource.is_buffer)
            add_name(render_size_name(graph_, resource.name), ParamCost::graph);
        add(resource.clear);
        add(resource.first_frame);
    }

    void add_pass(const PassDesc& pass) {
        for (const PortDesc& port : pass.in) add_port(port);
        for (const PortDesc* port : written_ports(pass)) add_port(*port);
        if (pass.indirect) add_port(*pass.indirect);
        if (pass.draw_count) add_port(*pass.draw_count);
        for (const Expr* expression : {&pass.condition, &pass.per_frame, &pass.vertices, &pass.instances})
            add(*expression, ParamCost::graph);
        add(pass.view_number, ParamCost::graph);
        add(pass.flops, ParamCost::live);
        if (!pass.switch_param.empty()) add_name(pass.switch_param, ParamCost::live);
        for (const RepeatDesc& repeat : pass.repeat)
            for (const Expr* expression : {&repeat.first, &repeat.last, &repeat.step})
                add(*expression, ParamCost::graph);
        for (const std::vector<Expr>* counts : {&pass.groups, &pass.threads})
            for (const Expr& count : *counts) add(count, ParamCost::graph);
        for (const StateNumberDesc& number : pass.state_numbers) add(number.value, ParamCost::graph);
        add(pass.clear);
        for (const auto& [port, color] : pass.clear_ports) add(color);
        add_values(pass.params, ParamCost::live);
        add_values(pass.constants, ParamCost::pipeline);
        add_shader(pass);
    }

    void add_port(const PortDesc& port) {
        add(port.ref);
        if (port.otherwise) add(*port.otherwise);
    }

    void add_values(const std::vector<ParamValueDesc>& values, ParamCost cost) {
        for (const ParamValueDesc& value : values)
            for (const Expr& component : value.components) add(component, cost);
    }

    // Adds the names of the parameters of a C++ pass, or the names of the `Params` members and specialisation
    // constants of a shader. Skips the names in the shader to which the pass itself gives a value.
    void add_shader(const PassDesc& pass) {
        const auto custom = input_.passes.find(pass.type);
        if (custom != input_.passes.end())
            for (const ParamDecl& param : custom->second.params)
                add_name(name_in_module(graph_, pass.module, std::string(param.name)), ParamCost::live);
        const auto shader = input_.shaders.find(pass.shader);
        if (shader == input_.shaders.end()) return;
        if (shader->second.modules.empty()) is_unknown_ = true;
        const auto given = [](const std::vector<ParamValueDesc>& values, const std::string& name) {
            return std::ranges::find(values, name, &ParamValueDesc::name) != values.end();
        };
        for (const BlockMember& member : shader->second.interface.params.members)
            if (!given(pass.params, member.name))
                add_name(name_in_module(graph_, pass.module, member.name), ParamCost::live);
        for (const SpecConstant& constant : shader->second.interface.spec_constants)
            if (!given(pass.constants, constant.name))
                add_name(name_in_module(graph_, pass.module, constant.name), ParamCost::pipeline);
    }

    void add_view_list(const ViewListDesc& list) {
        for (const Expr* expression : {&list.first, &list.count, &list.near_m})
            add(*expression, ParamCost::graph);
        const auto add_all = [&](const auto& expressions) {
            if (!expressions) return;
            for (const Expr& expression : *expressions) add(expression, ParamCost::graph);
        };
        add_all(list.plane);
        add_all(list.at);
        add_all(list.rect);
    }

    void add_view(const DebugViewDesc& view) {
        add(view.show);
        if (!view.range) return;
        for (const Expr& bound : *view.range) add(bound, ParamCost::live);
    }

    // Returns the names of all resources, draw lists, lists of views and turns (imported lists of rounds)
    // that passes, groups, debug views or tests use. This includes passes that do not run.
    ResourceNames named_resources() const {
        ResourceNames named = watched_resources(graph_);
        const auto add_named = [&](const PortDesc& port) {
            named.insert(port.ref.name);
            if (port.otherwise) named.insert(port.otherwise->name);
        };
        for (const auto& [name, pass] : graph_.passes) {
            for (const PortDesc& port : pass.in) add_named(port);
            for (const PortDesc* port : written_ports(pass)) add_named(*port);
            if (pass.indirect) add_named(*pass.indirect);
            if (pass.draw_count) add_named(*pass.draw_count);
            named.insert(pass.draws.begin(), pass.draws.end());
            named.insert(pass.view);
        }
        for (const auto& [name, list] : graph_.views) {
            named.insert(list.of);
            if (list.buffer) add_named(*list.buffer);
        }
        for (const auto& [name, group] : graph_.groups) named.insert(group.turns);
        return named;
    }

    const ResolveInput& input_;
    const GraphDesc& graph_;
    // For each name that is used, such as a parameter, a constant or a size: the greatest cost that a change
    // of the name causes at any place of use.
    std::map<std::string, ParamCost> costs_;
    // True if a shader failed to compile, so that it is unknown which parameters the shader uses.
    bool is_unknown_ = false;
};

}  // namespace

std::vector<GraphParam> weigh_params(const ResolveInput& input, std::vector<GraphParam> params,
                                     Reporter& reporter) {
    ParamCosts costs(input);
    costs.gather();
    for (GraphParam& param : params) param.cost = costs.cost_of(param.name);
    costs.warn(reporter);
    return params;
}

}  // namespace weft
