// Purpose: the operations of the expressions in graphs.
#pragma once

#include <cstdint>

namespace weft {

enum class ExprOp : uint8_t {
    number,
    name,
    mips_of,
    select_x,
    select_y,
    add,
    sub,
    mul,
    div,
    mod,
    negate,
    min,
    max,
    ceil,
    floor,
    log2,
    make_size,  // Makes a size from two numbers, as in "size": [w, h].
};

}  // namespace weft
