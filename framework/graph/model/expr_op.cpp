#include "graph/model/expr_op.h"

#include <cmath>

namespace weft {

bool is_binary(ExprOp op) {
    return op == ExprOp::add || op == ExprOp::sub || op == ExprOp::mul || op == ExprOp::div ||
           op == ExprOp::mod || op == ExprOp::min || op == ExprOp::max || op == ExprOp::make_size;
}

double apply_op(ExprOp op, double a, double b) {
    switch (op) {
        case ExprOp::add:
            return a + b;
        case ExprOp::sub:
            return a - b;
        case ExprOp::mul:
            return a * b;
        case ExprOp::div:
            return a / b;
        case ExprOp::mod:
            return a - b * std::floor(a / b);
        case ExprOp::min:
            return a < b ? a : b;
        case ExprOp::max:
            return a > b ? a : b;
        case ExprOp::negate:
            return -a;
        case ExprOp::ceil:
            return std::ceil(a);
        case ExprOp::floor:
            return std::floor(a);
        case ExprOp::log2:
            return std::log2(a);
        default:
            return a;
    }
}

}  // namespace weft
