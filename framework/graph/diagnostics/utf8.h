// Purpose: text one code point at a time. Bytes that are no UTF-8 can come from file names and broken files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace weft {

// `length` in bytes; 0 where there is no code point.
struct Utf8 {
    size_t length = 0;
    uint32_t code_point = 0;
};

// The UTF-8 sequence that `text`, which is not empty, starts with: no overlong ones, no surrogates.
[[nodiscard]] Utf8 first_code_point(std::string_view text);

}  // namespace weft
