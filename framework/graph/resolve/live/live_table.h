// Purpose: makes the list of values that follow live scales (ResolvedGraph::live_values) from the expressions
// of a graph. Equal expressions have one entry, so two images with the same entry always have the same area.
// Private to follow_areas().
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graph/resolve/declared.h"

namespace weft {

// The values of the indices of a repeat, by name.
using Indices = std::map<std::string, double>;

class LiveTable {
 public:
    // Keeps references to all arguments.
    LiveTable(const Declared& declared, Reporter& reporter) : declared_(declared), reporter_(reporter) {}

    // Returns the entry of an expression. Adds the entry if the list does not contain it yet. Returns nullopt
    // if the expression depends on no scale.
    [[nodiscard]] std::optional<uint32_t> find(const Expr& expression, const Indices& indices);
    // Returns false if a name in the expression has no value, because of an error that was reported.
    [[nodiscard]] bool is_known(const Expr& expression, const Indices& indices) const;
    // Returns the entry of any expression. Adds the entry if the list does not contain it yet. All names in
    // the expression must be known.
    [[nodiscard]] uint32_t entry(const Expr& expression, const Indices& indices) {
        return add_steps(steps_of(expression, indices), "");
    }
    // Returns the entry of one side of the size in entry `size`. `side` is ExprOp::select_x (width) or
    // ExprOp::select_y (height).
    [[nodiscard]] uint32_t side_of(uint32_t size, ExprOp side);
    [[nodiscard]] std::vector<LiveValue> take() { return std::move(values_); }

 private:
    // fixed: the value is the same in all frames. param: the value depends on a parameter, but on no scale.
    // scaled: the value depends on a scale.
    enum class Kind : uint8_t { fixed, param, scaled };

    [[nodiscard]] Kind kind_of(const Expr& expression, const Indices& indices);
    [[nodiscard]] Kind kind_of_name(const std::string& name);
    // Returns the parameter with the scale of a size; null if the name is no live size.
    [[nodiscard]] const std::string* scale_of(const std::string& name) const;
    [[nodiscard]] const Expr* expression_of(const std::string& name) const;
    void add_fixed(const ExprValue& value, std::vector<LiveStep>& steps) const;
    [[nodiscard]] std::vector<LiveStep> steps_of(const Expr& expression, const Indices& indices);
    [[nodiscard]] uint32_t add_param(const std::string& name);
    [[nodiscard]] uint32_t add_name(const std::string& name);
    [[nodiscard]] uint32_t add_steps(std::vector<LiveStep> steps, const std::string& name);

    const Declared& declared_;
    Reporter& reporter_;
    std::vector<LiveValue> values_;
    std::map<std::string, Kind> kinds_;
    std::map<std::string, uint32_t> named_;
    std::map<std::vector<LiveStep>, uint32_t> by_steps_;
};

}  // namespace weft
