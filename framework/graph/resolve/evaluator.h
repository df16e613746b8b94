// Purpose: evaluates the expressions of a graph and reports their errors. Reports nothing about an expression
// that contains a name whose own error was already reported.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "graph/resolve/evaluate.h"
#include "graph/resolve/shape_resources.h"

namespace weft {

class Evaluator {
 public:
    // Makes an evaluator that knows parameters, constants and sizes. Keeps references to all arguments.
    Evaluator(const Values& values, Reporter& reporter) : values_(&values), reporter_(&reporter) {}
    // Makes an evaluator that also knows the mip counts of resources, for the function mips().
    Evaluator(const Values& values, const Shapes& shapes, const Suspects& suspects, Reporter& reporter)
        : values_(&values), shapes_(&shapes), suspects_(&suspects), reporter_(&reporter) {}
    // Returns the same evaluator for a pass of a repeat, with the values of the repeat's indices. Keeps a
    // reference to `indices`. `is_later` is true for all passes of the repeat except the first. Later passes
    // often have the same errors as the first pass, so an error that is already known is not reported again.
    [[nodiscard]] Evaluator in_repeat(const std::map<std::string, double>& indices, bool is_later) const;

    // Returns the value of an expression, or nullopt after reporting an error.
    [[nodiscard]] std::optional<ExprValue> value(const Expr& expression) const;
    // Returns a number between `least` and `most`, which must be an integer if `whole` is true. Returns
    // nullopt after reporting an error. `what` names the number in the message, for example "the history of
    // \"color\"".
    [[nodiscard]] std::optional<double> number(const Expr& expression, const std::string& what, double least,
                                               double most, bool whole = true) const;
    // Returns the value of a colour. Reports each channel that has an error, and gives it the value 0.
    [[nodiscard]] std::array<float, 4> color(const ColorDesc& color) const;
    // Returns the value of a name, or nullopt if the name has no value.
    [[nodiscard]] std::optional<ExprValue> find(const std::string& name) const;

 private:
    [[nodiscard]] bool names_suspect(const Expr& expression) const;
    void report(Diagnostic fault) const;

    const Values* values_;
    const Shapes* shapes_ = nullptr;
    const Suspects* suspects_ = nullptr;
    Reporter* reporter_;
    const std::map<std::string, double>* indices_ = nullptr;
    bool is_later_ = false;
};

}  // namespace weft
