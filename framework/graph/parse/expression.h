// Purpose: the expression language of graphs, for sizes, counts, mips, ranges and parameters: + - * / % ( )
// min max ceil floor log2 mips(resource) .x .y, names and numbers. A value is a number or a size (two
// numbers). Operators apply to sizes component by component; a number combined with a size applies to both
// components. a % b has the sign of b. Results are not rounded: callers that need an integer convert the
// result explicitly. Errors: W106 bad expression, W107 unknown name. The location of an error is the token
// that causes it, or the whole expression.
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
    // The height of a size. For a number, y is equal to x.
    double y = 0;
    bool is_size = false;

    bool operator==(const ExprValue&) const = default;
};

[[nodiscard]] constexpr ExprValue number_value(double x) {
    return {x, x, false};
}
[[nodiscard]] constexpr ExprValue size_value(double x, double y) {
    return {x, y, true};
}

// Interface through which evaluate() looks up the values of the names in an expression. value() and mips()
// return nullopt for unknown names. mips() returns the number of mips of an image.
class ExprNames {
 public:
    virtual ~ExprNames() = default;
    [[nodiscard]] virtual std::optional<ExprValue> value(const std::string& name) const = 0;
    [[nodiscard]] virtual std::optional<uint32_t> mips(const std::string& resource) const = 0;
    // Returns all names that have a value, to suggest a similar name ("did you mean") for a misspelt name.
    [[nodiscard]] virtual std::vector<std::string> known_names() const = 0;
    [[nodiscard]] virtual std::vector<std::string> known_resources() const = 0;
};

// Parses a text that must consist of exactly one expression.
[[nodiscard]] Result<Expr> parse_expression(const LocatedText& text, const SourceMap& sources);
// Parses one expression that begins at `position`, and moves `position` behind it. Used if the text contains
// more than an expression, for example in references and in the ranges of "repeat".
[[nodiscard]] Result<Expr> parse_expression_at(const LocatedText& text, size_t& position,
                                               const SourceMap& sources);
[[nodiscard]] Expr number_expression(double number, SourceLoc loc);
[[nodiscard]] Expr name_expression(const std::string& name, SourceLoc loc);
// Returns the expression [width, height], whose value is a size of two numbers.
[[nodiscard]] Expr size_expression(const Expr& width, const Expr& height, SourceLoc loc);

// Computes the value of an expression, which must not be empty. Reports every unknown name, but only the
// first error of any other kind. The result is finite.
[[nodiscard]] Result<ExprValue> evaluate(const Expr& expression, const ExprNames& names,
                                         const SourceMap& sources);

// Returns true for words that must not name a parameter, constant or size: the names of functions, and the
// built-in size "output".
[[nodiscard]] bool is_reserved_word(std::string_view name);
// Returns true if the name has the form [A-Za-z_][A-Za-z0-9_]*.
[[nodiscard]] bool is_identifier(std::string_view name);

}  // namespace weft
