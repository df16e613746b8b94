#include <cassert>
#include <cmath>

#include "graph/model/expr_op.h"
#include "graph/parse/expression.h"

namespace weft {
namespace {

// The result of one operation of an expression: its value, or a message about its operands, such as "division
// by zero".
struct Outcome {
    ExprValue value;
    const char* fault = nullptr;
    const char* help = nullptr;
};

bool is_operand(ExprOp op) {
    return op == ExprOp::number || op == ExprOp::name || op == ExprOp::mips_of;
}

const char* operand_fault(ExprOp op, const ExprValue& a, const ExprValue& b) {
    if ((op == ExprOp::div || op == ExprOp::mod) && (b.x == 0 || b.y == 0)) return "division by zero";
    if (op == ExprOp::log2 && (a.x <= 0 || a.y <= 0)) return "log2 of a number that is not positive";
    if (op == ExprOp::make_size && (a.is_size || b.is_size))
        return "width or height in [width, height] is itself a size, not a number";
    if ((op == ExprOp::select_x || op == ExprOp::select_y) && !a.is_size)
        return "a number has no .x and .y; only a size has them";
    return nullptr;
}

const char* operand_help(ExprOp op) {
    if (op == ExprOp::div || op == ExprOp::mod)
        return "make the divisor greater than zero, for example with max(…, 1)";
    if (op == ExprOp::log2) return "make the argument of log2 greater than zero, for example with max(…, 1)";
    if (op == ExprOp::make_size) return "append .x or .y to the size inside the brackets";
    return "remove .x or .y";
}

Outcome apply(ExprOp op, const ExprValue& a, const ExprValue& b) {
    if (const char* fault = operand_fault(op, a, b)) return {{}, fault, operand_help(op)};
    if (op == ExprOp::make_size) return {size_value(a.x, b.x)};
    if (op == ExprOp::select_x) return {number_value(a.x)};
    if (op == ExprOp::select_y) return {number_value(a.y)};
    return {{apply_op(op, a.x, b.x), apply_op(op, a.y, b.y), a.is_size || b.is_size}};
}

Diagnostic unknown(const ExprNode& node, const ExprNames& names, const SourceMap& sources) {
    const bool image = node.op == ExprOp::mips_of;
    Diagnostic error = sources.error(
        node.loc, "W107",
        std::string(image ? "unknown image \"" : "unknown name \"") + node.name + "\" in an expression");
    const std::vector<std::string> known = image ? names.known_resources() : names.known_names();
    const std::string near = did_you_mean_text(node.name, known);
    error.help.push_back(
        !near.empty() ? near
        : image       ? "give mips() the name of an image of \"resources\" or \"imports\""
                      : "use a name of \"params\", \"consts\" or \"sizes\", or a built-in name such as "
                        "\"output\"");
    return error;
}

std::optional<ExprValue> operand(const ExprNode& node, const ExprNames& names) {
    if (node.op == ExprOp::number) return number_value(node.number);
    if (node.op == ExprOp::name) return names.value(node.name);
    const std::optional<uint32_t> mips = names.mips(node.name);
    if (!mips) return std::nullopt;
    return number_value(*mips);
}

ExprValue pop(std::vector<ExprValue>& stack) {
    assert(!stack.empty());
    const ExprValue top = stack.back();
    stack.pop_back();
    return top;
}

Diagnostics unknown_names(const Expr& expression, const ExprNames& names, const SourceMap& sources) {
    Diagnostics errors;
    for (const ExprNode& node : expression.postfix)
        if (is_operand(node.op) && !operand(node, names)) errors.push_back(unknown(node, names, sources));
    return errors;
}

}  // namespace

Result<ExprValue> evaluate(const Expr& expression, const ExprNames& names, const SourceMap& sources) {
    assert(!expression.empty());
    Diagnostics errors = unknown_names(expression, names, sources);
    if (!errors.empty()) return errors;
    std::vector<ExprValue> stack;
    for (const ExprNode& node : expression.postfix) {
        if (is_operand(node.op)) {
            stack.push_back(*operand(node, names));
            continue;
        }
        const ExprValue second = is_binary(node.op) ? pop(stack) : ExprValue{};
        const Outcome outcome = apply(node.op, pop(stack), second);
        if (outcome.fault != nullptr) {
            Diagnostic error = sources.error(node.loc, "W106", outcome.fault);
            error.help.emplace_back(outcome.help);
            return error;
        }
        stack.push_back(outcome.value);
    }
    assert(stack.size() == 1);
    const ExprValue value = stack.back();
    if (!std::isfinite(value.x) || !std::isfinite(value.y)) {
        Diagnostic error =
            sources.error(expression.loc, "W106",
                          "\"" + expression.text + "\" has a result that is too large for a number");
        error.help.emplace_back("check the factors of the expression");
        return error;
    }
    return value;
}

}  // namespace weft
