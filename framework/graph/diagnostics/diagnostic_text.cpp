#include "graph/diagnostics/diagnostic_text.h"

#include <algorithm>

#include "graph/diagnostics/utf8.h"

namespace weft {
namespace {

std::string place(const std::string& file, uint32_t line, uint32_t column) {
    if (file.empty()) return "";
    if (line == 0) return file + ": ";
    return file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

// Returns true for characters that could mislead a reader of the terminal: control characters except line
// feed, the line separators of Unicode, and characters that change the direction of text (Boucher and
// Anderson, "Trojan Source", 2021).
bool steers_a_terminal(uint32_t c) {
    return (c < 0x20 && c != '\n') || (c >= 0x7F && c < 0xA0) || c == 0x061C || c == 0x200E || c == 0x200F ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

void add_excerpt(const Diagnostic& d, std::vector<TextPiece>& pieces) {
    if (d.source_line.empty() || d.line == 0) return;
    const std::string number = std::to_string(d.line);
    const std::string gutter(number.size(), ' ');
    const size_t column = d.column > 0 ? d.column - 1 : 0;
    // At most 120 bytes of the source line are shown, around the column of the error, because a minified file
    // can be one very long line.
    constexpr size_t kWidth = 120;
    const size_t start = column > kWidth ? column - kWidth / 2 : 0;
    std::string shown = d.source_line.substr(std::min(start, d.source_line.size()), kWidth);
    std::replace(shown.begin(), shown.end(), '\t', ' ');
    const size_t offset = std::min(column - start, shown.size());
    const size_t carets = std::max<size_t>(1, std::min<size_t>(d.length, shown.size() - offset));
    pieces.push_back({TextStyle::gutter, "\n  " + number + " | "});
    pieces.push_back({TextStyle::plain, shown});
    pieces.push_back({TextStyle::gutter, "\n  " + gutter + " | "});
    pieces.push_back({TextStyle::caret, std::string(offset, ' ') + std::string(carets, '^')});
}

}  // namespace

std::string printable(std::string_view text) {
    return rewrite(text, [](const Utf8& next, std::string_view bytes) {
        return next.length > 0 && !steers_a_terminal(next.code_point) ? bytes : "?";
    });
}

std::vector<TextPiece> text_pieces(const Diagnostic& d) {
    std::vector<TextPiece> pieces{{TextStyle::place, place(d.file, d.line, d.column)},
                                  {TextStyle::severity, d.severity == Severity::error ? "error" : "warning"}};
    if (!d.code.empty()) pieces.push_back({TextStyle::code, "[" + d.code + "]"});
    pieces.push_back({TextStyle::plain, ": " + d.message});
    if (!d.tier.empty()) pieces.push_back({TextStyle::plain, "  (tier \"" + d.tier + "\")"});
    if (!d.pointer.empty()) pieces.push_back({TextStyle::gutter, "\n  at " + d.pointer});
    add_excerpt(d, pieces);
    for (const std::string& help : d.help) {
        pieces.push_back({TextStyle::label, "\n  help: "});
        pieces.push_back({TextStyle::plain, help});
    }
    for (const Note& note : d.notes) {
        pieces.push_back({TextStyle::label, "\n  note: "});
        pieces.push_back({TextStyle::place, place(note.file, note.line, note.column)});
        pieces.push_back({TextStyle::plain, note.message});
    }
    for (TextPiece& piece : pieces) piece.text = printable(piece.text);
    return pieces;
}

std::string to_text(const Diagnostic& diagnostic) {
    std::string text;
    for (const TextPiece& piece : text_pieces(diagnostic)) text += piece.text;
    return text;
}

}  // namespace weft
