#include "graph/resolve/live/live_table.h"

#include <algorithm>

namespace weft {

std::optional<uint32_t> LiveTable::find(const Expr& expression, const Indices& indices) {
    reporter_.spend(expression.postfix.size(), expression.loc);
    if (!is_known(expression, indices) || kind_of(expression, indices) != Kind::scaled) return std::nullopt;
    return entry(expression, indices);
}

bool LiveTable::is_known(const Expr& expression, const Indices& indices) const {
    return std::ranges::all_of(expression.postfix, [&](const ExprNode& node) {
        if (node.op == ExprOp::mips_of) return declared_.shapes.mip_counts.contains(node.name);
        if (node.op != ExprOp::name || indices.contains(node.name)) return true;
        return declared_.values.by_name.contains(node.name) && !declared_.values.faulty.contains(node.name);
    });
}

uint32_t LiveTable::side_of(uint32_t size, ExprOp side) {
    return add_steps({{ExprOp::name, 0, size}, {side}}, "");
}

LiveTable::Kind LiveTable::kind_of(const Expr& expression, const Indices& indices) {
    Kind kind = Kind::fixed;
    for (const ExprNode& node : expression.postfix)
        if (node.op == ExprOp::name && !indices.contains(node.name))
            kind = std::max(kind, kind_of_name(node.name));
    return kind;
}

LiveTable::Kind LiveTable::kind_of_name(const std::string& name) {
    const GraphDesc& graph = declared_.input.graph;
    if (const auto known = kinds_.find(name); known != kinds_.end()) return known->second;
    Kind kind = Kind::fixed;
    if (graph.params.contains(name))
        kind = declared_.values.scales.contains(name) ? Kind::scaled : Kind::param;
    if (const Expr* expression = expression_of(name))
        kind = scale_of(name) != nullptr ? Kind::scaled : kind_of(*expression, {});
    kinds_.emplace(name, kind);
    return kind;
}

const std::string* LiveTable::scale_of(const std::string& name) const {
    const auto& scales = declared_.input.graph.size_scales;
    const auto found = scales.find(name);
    const bool usable = found != scales.end() && declared_.values.scales.contains(found->second.param);
    return usable ? &found->second.param : nullptr;
}

// Returns the expression of a constant or size, or null if the name is neither.
const Expr* LiveTable::expression_of(const std::string& name) const {
    const GraphDesc& graph = declared_.input.graph;
    const auto constant = graph.consts.find(name);
    if (constant != graph.consts.end()) return &constant->second;
    const auto size = graph.sizes.find(name);
    return size != graph.sizes.end() ? &size->second : nullptr;
}

void LiveTable::add_fixed(const ExprValue& value, std::vector<LiveStep>& steps) const {
    steps.push_back({ExprOp::number, value.x});
    if (!value.is_size) return;
    steps.push_back({ExprOp::number, value.y});
    steps.push_back({ExprOp::make_size});
}

std::vector<LiveStep> LiveTable::steps_of(const Expr& expression, const Indices& indices) {
    std::vector<LiveStep> steps;
    for (const ExprNode& node : expression.postfix) {
        const auto index = indices.find(node.name);
        if (node.op == ExprOp::number)
            steps.push_back({ExprOp::number, node.number});
        else if (node.op == ExprOp::mips_of)
            steps.push_back({ExprOp::number, static_cast<double>(declared_.shapes.mip_counts.at(node.name))});
        else if (node.op != ExprOp::name)
            steps.push_back({node.op});
        else if (index != indices.end())
            steps.push_back({ExprOp::number, index->second});
        else if (kind_of_name(node.name) == Kind::fixed)
            add_fixed(declared_.values.by_name.at(node.name), steps);
        else
            steps.push_back({ExprOp::name, 0, add_name(node.name)});
    }
    return steps;
}

uint32_t LiveTable::add_param(const std::string& name) {
    const std::vector<GraphParam>& params = declared_.values.params;
    LiveValue value;
    value.name = name;
    value.param = static_cast<uint32_t>(std::ranges::find(params, name, &GraphParam::name) - params.begin());
    if (declared_.values.scales.contains(name)) {
        const ParamDesc& desc = declared_.input.graph.params.at(name);
        value.least = (*desc.range)[0];
        value.most = (*desc.range)[1];
    }
    values_.push_back(std::move(value));
    return static_cast<uint32_t>(values_.size() - 1);
}

uint32_t LiveTable::add_name(const std::string& name) {
    if (const auto known = named_.find(name); known != named_.end()) return known->second;
    const GraphDesc& graph = declared_.input.graph;
    const std::string* scale = scale_of(name);
    uint32_t index = 0;
    if (graph.params.contains(name)) {
        index = add_param(name);
    } else if (scale != nullptr) {
        LiveValue value;
        value.name = name;
        value.steps = steps_of(*expression_of(name), {});
        value.scale = add_name(*scale);
        values_.push_back(std::move(value));
        index = static_cast<uint32_t>(values_.size() - 1);
    } else {
        index = add_steps(steps_of(*expression_of(name), {}), name);
    }
    named_.emplace(name, index);
    return index;
}

uint32_t LiveTable::add_steps(std::vector<LiveStep> steps, const std::string& name) {
    if (steps.size() == 1 && steps[0].op == ExprOp::name) return steps[0].value;
    const auto [known, is_new] = by_steps_.try_emplace(steps, static_cast<uint32_t>(values_.size()));
    if (is_new) {
        LiveValue value;
        value.name = name;
        value.steps = std::move(steps);
        values_.push_back(std::move(value));
    }
    return known->second;
}

}  // namespace weft
