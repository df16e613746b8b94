#include "graph/resolve/evaluator.h"

#include <cmath>
#include <limits>

#include "graph/diagnostics/quantity_text.h"

namespace weft {
namespace {

template <class T>
void append_keys(const std::map<std::string, T>& map, std::vector<std::string>& keys) {
    for (const auto& [key, unused] : map) keys.push_back(key);
}

class Names final : public ExprNames {
 public:
    Names(const Values& values, const Shapes* shapes, const std::map<std::string, double>* indices)
        : values_(values), shapes_(shapes), indices_(indices) {}

    [[nodiscard]] std::optional<ExprValue> value(const std::string& name) const override {
        if (indices_) {
            const auto index = indices_->find(name);
            if (index != indices_->end()) return number_value(index->second);
        }
        const auto it = values_.by_name.find(name);
        if (it == values_.by_name.end()) return std::nullopt;
        return it->second;
    }

    [[nodiscard]] std::optional<uint32_t> mips(const std::string& resource) const override {
        if (!shapes_) return std::nullopt;
        const auto it = shapes_->mip_counts.find(resource);
        if (it == shapes_->mip_counts.end()) return std::nullopt;
        return it->second;
    }

    [[nodiscard]] std::vector<std::string> known_names() const override {
        std::vector<std::string> known;
        append_keys(values_.by_name, known);
        if (indices_) append_keys(*indices_, known);
        return known;
    }

    [[nodiscard]] std::vector<std::string> known_resources() const override {
        std::vector<std::string> known;
        if (shapes_) append_keys(shapes_->mip_counts, known);
        return known;
    }

 private:
    const Values& values_;
    const Shapes* shapes_;
    const std::map<std::string, double>* indices_;
};

}  // namespace

Evaluator Evaluator::in_repeat(const std::map<std::string, double>& indices, bool is_later) const {
    Evaluator evaluator = *this;
    evaluator.indices_ = &indices;
    evaluator.is_later_ = is_later;
    return evaluator;
}

std::optional<ExprValue> Evaluator::value(const Expr& expression) const {
    reporter_->spend(expression.postfix.size(), expression.loc);
    if (names_suspect(expression)) return std::nullopt;
    Result<ExprValue> value = evaluate(expression, Names(*values_, shapes_, indices_), reporter_->sources());
    if (value) return *value;
    for (Diagnostic& fault : value.take_errors()) report(std::move(fault));
    return std::nullopt;
}

std::optional<double> Evaluator::number(const Expr& expression, const std::string& what, double least,
                                        double most, bool whole) const {
    const std::optional<ExprValue> found = value(expression);
    if (!found) return std::nullopt;
    const auto refuse = [&](std::string code, const std::string& message, std::string help) {
        Diagnostic fault = reporter_->sources().error(expression.loc, std::move(code), what + message);
        fault.help.push_back(std::move(help));
        report(std::move(fault));
        return std::nullopt;
    };
    if (found->is_size)
        return refuse("W106", " is a size (width and height), but must be a number",
                      "use .x or .y of the size");
    const bool fits = found->x >= least && found->x <= most && (!whole || found->x == std::floor(found->x));
    if (fits) return found->x;
    std::string fault = ", but must be a whole number";
    if (found->x < least) fault = ", but the smallest possible value is " + number_text(least);
    if (found->x > most) fault = ", but the largest possible value is " + number_text(most);
    return refuse("W109", " is " + number_text(found->x) + fault,
                  (whole ? "write a whole number from " : "write a number from ") + number_text(least) +
                      " to " + number_text(most));
}

std::array<float, 4> Evaluator::color(const ColorDesc& color) const {
    constexpr double kMost = std::numeric_limits<float>::max();
    std::array<float, 4> channels{};
    for (size_t i = 0; i < channels.size(); ++i)
        channels[i] = static_cast<float>(
            number(color.channels[i], "a channel of the colour", -kMost, kMost, false).value_or(0));
    return channels;
}

std::optional<ExprValue> Evaluator::find(const std::string& name) const {
    return Names(*values_, shapes_, indices_).value(name);
}

bool Evaluator::names_suspect(const Expr& expression) const {
    for (const ExprNode& node : expression.postfix) {
        if (!node.name.empty() && values_->faulty.contains(node.name)) return true;
        if (node.op != ExprOp::mips_of || !shapes_) continue;
        const ResourceId resource = resource_id(shapes_->resources, node.name);
        if (resource != kNoId && suspects_->shapes[resource]) return true;
    }
    return false;
}

void Evaluator::report(Diagnostic fault) const {
    if (is_later_)
        reporter_->add_once(std::move(fault));
    else
        reporter_->add(std::move(fault));
}

}  // namespace weft
