// Purpose: a string value with the places of its characters in a file, so that a fault inside an expression
// or a reference is reported at its exact column.
#pragma once

#include <cstddef>
#include <string_view>

#include "weft/source.h"

namespace weft {

struct LocatedText {
    std::string_view text;  // without quotes, escapes decoded
    SourceLoc literal;      // location of the whole token, including quotes; default: not from a file

    // The place of text[offset, offset + length). An offset at the end is the closing quote. In a literal
    // with escapes, columns cannot be computed, so the place of the whole literal is returned.
    [[nodiscard]] SourceLoc at(size_t offset, size_t length) const {
        const bool quoted = literal.length == text.size() + 2;
        const bool bare = literal.length == text.size();
        if (literal.line == 0 || (!quoted && !bare)) return literal;
        SourceLoc loc = literal;
        loc.column += static_cast<uint32_t>(offset) + (quoted ? 1 : 0);
        loc.length = length == 0 ? 1 : static_cast<uint32_t>(length);
        return loc;
    }
};

}  // namespace weft
