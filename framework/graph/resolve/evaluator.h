// Purpose: evaluates expressions at one place of the graph and reports their faults. Reports nothing about an
// expression with a name whose fault was already reported.
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
    // For parameters, constants and sizes. Keeps references to all arguments.
    Evaluator(const Values& values, Reporter& reporter) : values_(&values), reporter_(&reporter) {}
    // Also for the mips of resources.
    Evaluator(const Values& values, const Shapes& shapes, const Suspects& suspects, Reporter& reporter)
        : values_(&values), shapes_(&shapes), suspects_(&suspects), reporter_(&reporter) {}
    // The same for a pass with these indices of its repeat. A later pass of a repeat finds the faults that
    // the first one found; they are reported once.
    [[nodiscard]] Evaluator in_repeat(const std::map<std::string, double>& indices, bool is_later) const;

    // nullopt: reported.
    [[nodiscard]] std::optional<ExprValue> value(const Expr& expression) const;
    // A number within bounds; nullopt: reported. `what` names it: "the history of \"color\"".
    [[nodiscard]] std::optional<double> number(const Expr& expression, const std::string& what, double least,
                                               double most, bool whole = true) const;
    // A faulty channel is reported, and its value is 0.
    [[nodiscard]] std::array<float, 4> color(const ColorDesc& color) const;
    // The value of a name; nullopt: it has none.
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
