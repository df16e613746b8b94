// Purpose: prepares diagnostics for a terminal. Splits a diagnostic into pieces, so that each kind of piece
// can have its own colour, and replaces control characters that come from a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "weft/result.h"

namespace weft {

enum class TextStyle : uint8_t { plain, place, severity, code, gutter, caret, label };

// Replaces each byte that is not UTF-8 by '?'. Also replaces each character, except line feed, that moves the
// cursor, changes colours or reverses the direction of text, so that text of a file cannot control the
// terminal.
[[nodiscard]] std::string printable(std::string_view text);

// A part of a printed diagnostic whose characters all have one style. `text` has already passed through
// printable().
struct TextPiece {
    TextStyle style = TextStyle::plain;
    std::string text;
};

// Splits a diagnostic into pieces with one style each. The texts of all pieces, concatenated, equal
// to_text().
[[nodiscard]] std::vector<TextPiece> text_pieces(const Diagnostic& diagnostic);

}  // namespace weft
