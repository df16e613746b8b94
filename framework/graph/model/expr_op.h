// Purpose: the arithmetic of expressions, for numbers. It is used when a graph is resolved. It is also used
// in each frame, for values that depend on image scales that may change in each frame (live scales).
#pragma once

#include "weft/expr_op.h"

namespace weft {

// Returns true if the operation has two operands.
[[nodiscard]] bool is_binary(ExprOp op);
// Returns the result of an operation on numbers, which can be infinite or NaN. `b` is the second operand of a
// binary operation. For operations that are not arithmetic, such as `name`, the result is `a`.
[[nodiscard]] double apply_op(ExprOp op, double a, double b);

}  // namespace weft
