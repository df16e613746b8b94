#include "weft/result.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string_view>

namespace weft {
namespace {

// Optimal string alignment distance: insertions, deletions, substitutions and swaps of neighbours cost 1
// each.
size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t substitution = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            next[j] = std::min({row[j] + 1, next[j - 1] + 1, substitution});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) next[j] = std::min(next[j], before[j - 2] + 1);
        }
        before = std::exchange(row, next);
    }
    return row[b.size()];
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string to_text(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics) {
        if (!text.empty()) text += "\n";
        text += to_text(d);
    }
    return text;
}

std::vector<std::string> did_you_mean(const std::string& name, const std::vector<std::string>& known) {
    std::vector<std::pair<size_t, std::string>> near;
    const size_t limit = std::max<size_t>(1, name.size() / 3);
    for (const std::string& candidate : known) {
        const size_t distance = edit_distance(lower(name), lower(candidate));
        const bool abbreviation = name.size() >= 3 && lower(candidate).find(lower(name)) != std::string::npos;
        if (distance <= limit || abbreviation) near.emplace_back(distance, candidate);
    }
    std::sort(near.begin(), near.end());
    std::vector<std::string> names;
    for (size_t i = 0; i < std::min<size_t>(3, near.size()); ++i) names.push_back(near[i].second);
    return names;
}

std::string did_you_mean_text(const std::string& name, const std::vector<std::string>& known) {
    const std::vector<std::string> names = did_you_mean(name, known);
    if (names.empty()) return "";
    std::string text = "did you mean ";
    for (size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += "\"" + names[i] + "\"";
    }
    return text + "?";
}

}  // namespace weft
