// Purpose: a diagnostic as pieces of text, so that whoever prints it can give each kind a colour of its own.
#pragma once

#include <string>
#include <vector>

#include "weft/result.h"

namespace weft {

enum class TextStyle : uint8_t { plain, place, severity, code, gutter, caret, label };

// Printable: nothing in it steers a terminal.
struct TextPiece {
    TextStyle style = TextStyle::plain;
    std::string text;
};

// Joined, they are to_text().
[[nodiscard]] std::vector<TextPiece> text_pieces(const Diagnostic& diagnostic);

}  // namespace weft
