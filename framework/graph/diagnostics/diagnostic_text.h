// Purpose: text for a terminal: splits a diagnostic into pieces, so that each kind of piece can have its own
// colour, and removes control characters from text of a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "weft/result.h"

namespace weft {

enum class TextStyle : uint8_t { plain, place, severity, code, gutter, caret, label };

// Replaces by '?' each byte that is not UTF-8 and each character, except line feed, that moves the cursor,
// changes colours or reverses the direction of text.
[[nodiscard]] std::string printable(std::string_view text);

// The text is already printable().
struct TextPiece {
    TextStyle style = TextStyle::plain;
    std::string text;
};

// The concatenated pieces equal to_text().
[[nodiscard]] std::vector<TextPiece> text_pieces(const Diagnostic& diagnostic);

}  // namespace weft
