// Purpose: iterates over the code points of a text. File names and broken files may contain bytes that are
// not UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace weft {

// `length` in bytes; 0 if there is no valid code point.
struct Utf8 {
    size_t length = 0;
    uint32_t code_point = 0;
};

// The UTF-8 sequence at the start of `text`, which must not be empty. Overlong sequences and surrogates are
// invalid.
[[nodiscard]] Utf8 first_code_point(std::string_view text);

}  // namespace weft
