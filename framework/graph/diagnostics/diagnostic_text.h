// Purpose: text for a terminal: a diagnostic in pieces, so that each kind can get a colour of its own, and
// words of a file without the characters that steer a terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "weft/result.h"

namespace weft {

enum class TextStyle : uint8_t { plain, place, severity, code, gutter, caret, label };

// A '?' stands for each byte that is not UTF-8 and for each character, other than a line feed, that moves the
// cursor, changes colours or turns the direction of text.
[[nodiscard]] std::string printable(std::string_view text);

// Printable.
struct TextPiece {
    TextStyle style = TextStyle::plain;
    std::string text;
};

// Joined, they are to_text().
[[nodiscard]] std::vector<TextPiece> text_pieces(const Diagnostic& diagnostic);

}  // namespace weft
