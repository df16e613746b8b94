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

std::string place(const std::string& file, uint32_t line, uint32_t column) {
    if (file.empty()) return "";
    if (line == 0) return file + ": ";
    return file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

// The length of the UTF-8 sequence at the start of `text`, and its code point; 0 when there is none.
struct Utf8 {
    size_t length = 0;
    uint32_t code_point = 0;
};

Utf8 first_code_point(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
    if (byte(0) < 0x80) return {1, byte(0)};
    const size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return {};
    uint32_t code_point = byte(0) & (0x7Fu >> length);
    for (size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code_point = code_point << 6 | (byte(i) & 0x3Fu);
    }
    const bool overlong = (length == 3 && code_point < 0x800) || (length == 4 && code_point < 0x10000);
    const bool surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
    return overlong || surrogate || code_point > 0x10FFFF ? Utf8{} : Utf8{length, code_point};
}

// Controls, and what turns the direction of the text around it (Boucher and Anderson, "Trojan Source", 2021).
bool steers_a_terminal(uint32_t c) {
    return (c < 0x20 && c != '\n') || (c >= 0x7F && c < 0xA0) || c == 0x061C || c == 0x200E || c == 0x200F ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

// A file under examination must not be able to end the text early, steer a terminal or make it undecodable.
std::string printable(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const Utf8 next = first_code_point(text);
        const bool good = next.length > 0 && !steers_a_terminal(next.code_point);
        if (good) {
            shown += text.substr(0, next.length);
        } else {
            shown += '?';
        }
        text.remove_prefix(std::max<size_t>(1, next.length));
    }
    return shown;
}

std::string excerpt(const Diagnostic& d) {
    if (d.source_line.empty() || d.line == 0) return "";
    const std::string number = std::to_string(d.line);
    const std::string gutter(number.size(), ' ');
    const size_t column = d.column > 0 ? d.column - 1 : 0;
    // A very long line is shown around the fault only.
    constexpr size_t kWidth = 120;
    const size_t start = column > kWidth ? column - kWidth / 2 : 0;
    std::string shown = d.source_line.substr(std::min(start, d.source_line.size()), kWidth);
    std::replace(shown.begin(), shown.end(), '\t', ' ');
    const size_t offset = std::min(column - start, shown.size());
    const size_t carets = std::max<size_t>(1, std::min<size_t>(d.length, shown.size() - offset));
    return "\n  " + number + " | " + shown + "\n  " + gutter + " | " + std::string(offset, ' ') +
           std::string(carets, '^');
}

}  // namespace

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string to_text(const Diagnostic& d) {
    std::string text = place(d.file, d.line, d.column);
    text += d.severity == Severity::error ? "error" : "warning";
    if (!d.code.empty()) text += "[" + d.code + "]";
    text += ": " + d.message;
    if (!d.tier.empty()) text += "  (tier \"" + d.tier + "\")";
    if (!d.pointer.empty()) text += "\n  at " + d.pointer;
    text += excerpt(d);
    for (const std::string& help : d.help) text += "\n  help: " + help;
    for (const Note& note : d.notes)
        text += "\n  note: " + place(note.file, note.line, note.column) + note.message;
    return printable(text);
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
