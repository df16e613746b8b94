#include "viewer/options/numbers.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace weft::viewer {
namespace {

std::string short_text(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", number);
    return text;
}

std::string fault_of(const std::string& text, std::optional<double> number, const NumberRange& range,
                     const char* kind) {
    if (!number) return "\"" + text + "\" is not " + kind + "; wanted " + describe(range);
    if (*number >= range.least && *number <= range.most) return "";
    return "\"" + text + "\" is out of range; wanted " + describe(range);
}

}  // namespace

std::optional<double> finite_number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

std::optional<double> finite_fraction(std::string_view text) {
    const size_t slash = text.find('/');
    if (slash == std::string_view::npos) return finite_number(text);
    const std::optional<double> above = finite_number(text.substr(0, slash)),
                                below = finite_number(text.substr(slash + 1));
    if (!above || !below || !std::isfinite(*above / *below)) return std::nullopt;
    return *above / *below;
}

std::optional<uint64_t> whole_number(std::string_view text) {
    uint64_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::string number_fault(const std::string& text, const NumberRange& range) {
    return fault_of(text, finite_number(text), range, "a finite number");
}

std::string fraction_fault(const std::string& text, const NumberRange& range) {
    return fault_of(text, finite_fraction(text), range, "a finite number or a fraction such as 1/60");
}

std::string whole_number_fault(const std::string& text, uint64_t least, uint64_t most) {
    const std::optional<uint64_t> number = whole_number(text);
    if (number && *number >= least && *number <= most) return "";
    return "\"" + text + "\" is not a whole number of " + std::to_string(least) + " to " +
           std::to_string(most);
}

std::string decimal(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}

std::string describe(const NumberRange& range) {
    return short_text(range.least) + " to " + short_text(range.most) +
           (*range.unit == 0 ? "" : std::string(" ") + range.unit);
}

}  // namespace weft::viewer
