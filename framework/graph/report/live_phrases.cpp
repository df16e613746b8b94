#include "graph/report/live_phrases.h"

#include <map>
#include <utility>

#include "graph/diagnostics/quantity_text.h"
#include "graph/model/expr_op.h"
#include "graph/plan/plan_names.h"

namespace weft {
namespace {

bool is_function(ExprOp op) {
    return op == ExprOp::min || op == ExprOp::max || op == ExprOp::ceil || op == ExprOp::floor ||
           op == ExprOp::log2;
}

std::string combined(ExprOp op, const std::string& a, const std::string& b) {
    const std::string name = enum_name(op);
    if (op == ExprOp::make_size) return a + "x" + b;
    if (op == ExprOp::select_x || op == ExprOp::select_y) return a + name;
    if (op == ExprOp::negate) return "-" + a;
    if (is_function(op)) return name + "(" + a + (is_binary(op) ? ", " + b : "") + ")";
    return "(" + a + " " + name + " " + b + ")";
}

std::string without_brackets(const std::string& text) {
    const size_t close = text.find(')');
    const bool whole = text.starts_with('(') && close == text.size() - 1;
    return whole ? text.substr(1, text.size() - 2) : text;
}

std::string expression_text(const ResolvedGraph& graph, const std::vector<LiveStep>& steps) {
    std::vector<std::string> stack;
    for (const LiveStep& step : steps) {
        if (step.op == ExprOp::number) {
            stack.push_back(number_text(step.number));
        } else if (step.op == ExprOp::name) {
            stack.push_back(live_name(graph, step.value));
        } else {
            std::string second;
            if (is_binary(step.op)) {
                second = std::move(stack.back());
                stack.pop_back();
            }
            const bool bracketed = is_function(step.op);
            stack.back() =
                combined(step.op, bracketed ? without_brackets(stack.back()) : stack.back(), second);
        }
    }
    return without_brackets(stack.back());
}

}  // namespace

std::string describe_live(const ResolvedGraph& graph, uint32_t value) {
    const LiveValue& live = graph.live_values[value];
    if (live.param != kNoId) return live.name;
    const std::string text = expression_text(graph, live.steps);
    return live.scale == kNoId ? text : text + " × " + live_name(graph, live.scale);
}

std::string live_name(const ResolvedGraph& graph, uint32_t value) {
    const std::string& name = graph.live_values[value].name;
    return name.empty() ? describe_live(graph, value) : name;
}

std::string describe_area(const ResolvedGraph& graph, const ResourceDecl& image) {
    const std::string name = graph.live_values[image.area].name;
    return (name.empty() ? "" : name + " = ") + describe_live(graph, image.area);
}

std::vector<std::string> list_areas(const ResolvedGraph& graph) {
    std::map<uint32_t, std::string> texts;
    for (const ResourceDecl& image : graph.resources) {
        if (image.area == kNoId) continue;
        const auto [text, is_new] = texts.try_emplace(image.area, describe_area(graph, image));
        text->second += (is_new ? ": " : ", ") + image.name;
    }
    std::vector<std::string> list;
    for (auto& [value, text] : texts) list.push_back(std::move(text));
    return list;
}

}  // namespace weft
