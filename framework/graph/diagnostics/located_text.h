// Purpose: a string value of a graph file together with its location, so that an error inside an expression
// or a reference is reported at its exact column.
#pragma once

#include <cstddef>
#include <string_view>

#include "weft/source.h"

namespace weft {

struct LocatedText {
    // The value of the string, without quotes and with escapes decoded.
    std::string_view text;
    // Location of the whole token in the file, including its quotes if it has any. The default value means
    // that the text does not come from a file.
    SourceLoc literal;

    // Returns the location of text[offset, offset + length) in the file. An `offset` equal to the size of the
    // text means the closing quote. If the string contains escapes, columns cannot be computed, so the
    // location of the whole token is returned.
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
