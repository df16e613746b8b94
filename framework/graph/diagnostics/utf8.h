// Purpose: reads a text one code point at a time. File names and broken files can contain bytes that are not
// UTF-8.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
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

// Joins the texts that write(code point, its bytes) returns for all code points of `text`. For each byte that
// is not valid UTF-8, Utf8::length is 0.
template <class Write>
[[nodiscard]] std::string rewrite(std::string_view text, const Write& write) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Utf8 next = first_code_point(text);
        const size_t length = std::max<size_t>(1, next.length);
        out += write(next, text.substr(0, length));
        text.remove_prefix(length);
    }
    return out;
}

}  // namespace weft
