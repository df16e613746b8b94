// Purpose: reads a text one code point at a time. File names and broken files can contain bytes that are not
// UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace weft {

// A decoded code point. `length` is the number of bytes that encode it, or 0 if the bytes are not valid
// UTF-8.
struct Utf8 {
    size_t length = 0;
    uint32_t code_point = 0;
};

// Decodes the UTF-8 sequence at the start of `text`, which must not be empty. Overlong sequences and
// surrogates are invalid.
[[nodiscard]] Utf8 first_code_point(std::string_view text);

}  // namespace weft
