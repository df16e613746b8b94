// Purpose: the expression language of graphs, for sizes, counts, mips, ranges and parameters: + - * / % ( )
// min max ceil floor log2 mips(resource) .x .y, names and numbers. A value is a number or a size (two
// numbers). Operators apply to sizes component by component; a number combined with a size applies to both
// components. a % b has the sign of b. Results are not rounded; callers that need an integer must convert
// explicitly. Errors: W106 bad expression, W107 unknown name; both at the token.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/diagnostics/located_text.h"
#include "weft/graph_desc.h"
#include "weft/result.h"

namespace weft {

inline constexpr size_t kMaxExpressionNodes = 1024;

struct ExprValue {
    double x = 0;
    double y = 0;  // equals x if the value is a number
    bool is_size = false;

    bool operator==(const ExprValue&) const = default;
};

[[nodiscard]] constexpr ExprValue number_value(double x) {
    return {x, x, false};
}
[[nodiscard]] constexpr ExprValue size_value(double x, double y) {
    return {x, y, true};
}

// Gives the values of names in an expression.
class ExprNames {
 public:
    virtual ~ExprNames() = default;
    [[nodiscard]] virtual std::optional<ExprValue> value(const std::string& name) const = 0;
    [[nodiscard]] virtual std::optional<uint32_t> mips(const std::string& resource) const = 0;
    // Used for "did you mean".
    [[nodiscard]] virtual std::vector<std::string> known_names() const = 0;
    [[nodiscard]] virtual std::vector<std::string> known_resources() const = 0;
};

// The whole text must be one expression.
[[nodiscard]] Result<Expr> parse_expression(const LocatedText& text, const SourceMap& sources);
// Parses the expression at `position` and moves `position` behind it: references contain several expressions.
[[nodiscard]] Result<Expr> parse_expression_at(const LocatedText& text, size_t& position,
                                               const SourceMap& sources);
[[nodiscard]] Expr number_expression(double number, SourceLoc loc);
// [width, height]: one size of two numbers.
[[nodiscard]] Expr size_expression(const Expr& width, const Expr& height, SourceLoc loc);

// Reports every unknown name, but only the first of other faults. The result is finite. Asserts that
// `expression` is not empty.
[[nodiscard]] Result<ExprValue> evaluate(const Expr& expression, const ExprNames& names,
                                         const SourceMap& sources);

// Words that cannot be names of parameters, constants or sizes: functions, and the built-in size "output".
[[nodiscard]] bool is_reserved_word(std::string_view name);
// [A-Za-z_][A-Za-z0-9_]*
[[nodiscard]] bool is_identifier(std::string_view name);

}  // namespace weft
