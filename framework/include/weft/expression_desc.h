// Purpose: describes the expressions, colours and references of a graph file, as the author wrote them. Part
// of graph_desc.h.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/access.h"
#include "weft/expr_op.h"
#include "weft/source.h"

namespace weft {

// The value of an expression is a number or a size (width and height). An expression is stored in postfix
// form: "half.x + 1" becomes half, .x, 1, +. Names are parameters, constants, sizes or indices of repeats;
// `.x`, `.y` and mips(res) are operations. evaluate() in framework/graph/parse/expression.h computes the
// value.
struct ExprNode {
    ExprOp op = ExprOp::number;
    double number = 0;
    // For the operation `name`: the name to look up. For `mips_of`: the name of the image. Else empty.
    std::string name;
    SourceLoc loc;  // Place of this token in the file.
};

struct Expr {
    // The operations in postfix order; empty if the graph does not give the expression.
    std::vector<ExprNode> postfix;
    std::string text;
    SourceLoc loc;

    [[nodiscard]] bool empty() const { return postfix.empty(); }
};

// A colour: one expression for each channel, in the order r, g, b, a.
struct ColorDesc {
    std::array<Expr, 4> channels;
};

// A reference to a resource or to a part of it: name@pass[-N].mip(a..b).layer(a..b).depth, or .range(a..b)
// for a buffer. Only the name is required. The square brackets are part of the text, as in "hdr[-1]".
struct RefDesc {
    std::string name;
    // The pass after which the resource is read, as in "hdr@lighting"; empty if the reference has no `@pass`.
    std::string pass;
    uint32_t history = 0;  // N of [-N]: the content at the end of the N-th previous frame; 0: of this frame.
    // The ranges of mips, of layers, and of the elements of a buffer, as in ".mip(a..b)". If only the first
    // bound is given, the range is this single mip, layer or element. If both bounds are absent, the range
    // contains all mips, layers or elements.
    std::optional<Expr> mip_first, mip_last;
    std::optional<Expr> layer_first, layer_last;      // The range of layers.
    std::optional<Expr> element_first, element_last;  // The range of elements of a buffer.
    AspectMask aspects = 0;  // The selected aspects, as in ".depth" or ".stencil"; 0: all aspects.
    std::string text;
    SourceLoc loc;
};

}  // namespace weft
