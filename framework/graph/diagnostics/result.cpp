#include "weft/result.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <string_view>

namespace weft {
namespace {

// did_you_mean() suggests nothing for a name that is longer than this, because misspelt names are rarely so
// long.
constexpr size_t kMostNameBytes = 64;
// did_you_mean() never suggests a known name that is longer than this.
constexpr size_t kMostKnownBytes = 2 * kMostNameBytes;
// Limits the cost of one search for similar names: the search stops after it has compared this many pairs of
// letters.
constexpr size_t kMostLetterPairs = 1u << 21;
constexpr size_t kMostSuggestions = 3;

// Returns the optimal string alignment distance of two names: each insertion, deletion, substitution and swap
// of neighbouring letters costs 1. Fills a table with one row per letter of `a` and one column per letter of
// `b`, but only near its diagonal, because distances up to `most` occur only there (Ukkonen 1985). Returns
// most + 1 for any greater distance. Adds the number of compared pairs of letters to `pairs`. Name b has at
// most kMostKnownBytes letters.
size_t edit_distance(std::string_view a, std::string_view b, size_t most, size_t& pairs) {
    const size_t far = most + 1;
    if (a.size() > b.size() + most || b.size() > a.size() + most) return far;
    std::array<std::array<size_t, kMostKnownBytes + 1>, 3> rows;
    for (auto& row : rows) std::fill_n(row.begin(), b.size() + 1, far);
    for (size_t j = 0; j <= std::min(b.size(), most); ++j) rows[0][j] = j;
    size_t least_before = 0;
    for (size_t i = 1; i <= a.size(); ++i) {
        const auto& before = rows[(i + 1) % 3];  // Row i - 2.
        const auto& row = rows[(i - 1) % 3];
        auto& next = rows[i % 3];
        const size_t begin = i > most ? i - most : 1;
        const size_t end = std::min(b.size(), i + most);
        next[begin - 1] = i <= most ? i : far;
        if (end < b.size()) next[end + 1] = far;
        size_t least = next[begin - 1];
        for (size_t j = begin; j <= end; ++j) {
            const size_t substitution = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            next[j] = std::min({row[j] + 1, next[j - 1] + 1, substitution, far});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) next[j] = std::min(next[j], before[j - 2] + 1);
            least = std::min(least, next[j]);
        }
        pairs += end + 1 - std::min(begin, end + 1);
        // A value of row i + 1 is at least the least value of row i or, after a swap, at least 1 more than
        // the least value of row i - 1. So if this condition holds, all following rows contain only `far`.
        if (least == far && least_before >= most) return far;
        least_before = least;
    }
    return std::min(rows[a.size() % 3][b.size()], far);
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
    if (name.size() > kMostNameBytes) return {};
    using Near = std::pair<size_t, std::string>;
    std::vector<Near> near;  // Sorted, the most similar first.
    size_t limit = std::max<size_t>(1, name.size() / 3);
    const std::string wanted = lower(name);
    size_t pairs = 0;
    for (const std::string& candidate : known) {
        if (candidate.size() > kMostKnownBytes) continue;
        if (pairs > kMostLetterPairs) break;
        const std::string offered = lower(candidate);
        size_t distance = edit_distance(wanted, offered, limit, pairs);
        const bool abbreviation = name.size() >= 3 && offered.find(wanted) != std::string::npos;
        pairs += offered.size();
        if (abbreviation) distance = std::min(distance, offered.size() - wanted.size());
        if (distance > limit && !abbreviation) continue;
        const Near found(distance, candidate);
        near.insert(std::ranges::lower_bound(near, found), found);
        if (near.size() > kMostSuggestions) near.pop_back();
        // If the list is full, a name that is less similar than the last one in the list is not suggested. So
        // the search may skip such names.
        if (near.size() == kMostSuggestions) limit = std::min(limit, near.back().first);
    }
    std::vector<std::string> names;
    for (Near& found : near) names.push_back(std::move(found.second));
    return names;
}

std::string did_you_mean_text(const std::string& name, const std::vector<std::string>& known) {
    return did_you_mean_text(did_you_mean(name, known));
}

std::string did_you_mean_text(const std::vector<std::string>& names) {
    if (names.empty()) return "";
    std::string text = "did you mean ";
    for (size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += "\"" + names[i] + "\"";
    }
    return text + "?";
}

}  // namespace weft
