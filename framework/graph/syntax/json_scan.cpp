#include "graph/syntax/json_scan.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>

namespace weft {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

JsonFault syntax(SourceLoc loc, std::string message, std::string help) {
    return {"W001", loc, std::move(message), std::move(help), std::nullopt, {}};
}

void append_utf8(uint32_t code, std::string& out) {
    const auto put = [&](uint32_t byte) { out.push_back(static_cast<char>(byte)); };
    const auto tail = [&](uint32_t shift) { put(0x80 | ((code >> shift) & 0x3F)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        tail(0);
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        tail(6);
        tail(0);
    } else {
        put(0xF0 | (code >> 18));
        tail(12);
        tail(6);
        tail(0);
    }
}

// Reads the four hexadecimal digits of an escape "\u", which begin `ahead` bytes after the cursor. Returns
// their value, or nullopt if they are not four hexadecimal digits. Does not move the cursor.
std::optional<uint32_t> hex4(const JsonCursor& cursor, size_t ahead) {
    uint32_t code = 0;
    for (size_t i = 0; i < 4; ++i) {
        const char c = cursor.peek(ahead + i);
        if (std::isxdigit(static_cast<unsigned char>(c)) == 0) return std::nullopt;
        const uint32_t digit =
            is_digit(c) ? static_cast<uint32_t>(c - '0')
                        : static_cast<uint32_t>(std::tolower(static_cast<unsigned char>(c)) - 'a') + 10;
        code = code * 16 + digit;
    }
    return code;
}

// Decodes an escape \uXXXX, with the cursor at its backslash. A character beyond U+FFFF is written as two
// escapes, a surrogate pair; half of a pair is an error.
std::optional<JsonFault> scan_unicode_escape(JsonCursor& cursor, std::string& out) {
    const SourceLoc loc = cursor.here(2);
    std::optional<uint32_t> code = hex4(cursor, 2);
    if (!code)
        return syntax(loc, "\\u must be followed by four hexadecimal digits",
                      "write for example \\u00e9, or the character itself");
    cursor.advance(6);
    if (*code >= 0xD800 && *code < 0xDC00 && cursor.peek() == '\\' && cursor.peek(1) == 'u') {
        const std::optional<uint32_t> low = hex4(cursor, 2);
        if (low && *low >= 0xDC00 && *low < 0xE000) {
            cursor.advance(6);
            code = 0x10000 + ((*code - 0xD800) << 10) + (*low - 0xDC00);
        }
    }
    if (*code >= 0xD800 && *code < 0xE000)
        return syntax(loc, "the \\u escape is only one half of a surrogate pair",
                      "write the character itself, or both halves");
    if (*code == 0) return syntax(loc, "a string must not contain the character \\u0000", "remove it");
    append_utf8(*code, out);
    return std::nullopt;
}

std::optional<JsonFault> scan_escape(JsonCursor& cursor, std::string& out) {
    constexpr std::string_view kLetters = "\"\\/bfnrt";
    constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
    const char c = cursor.peek(1);
    if (c == 'u') return scan_unicode_escape(cursor, out);
    const size_t index = c == '\0' ? std::string_view::npos : kLetters.find(c);
    if (index == std::string_view::npos)
        return syntax(cursor.here(2), "unknown escape \\" + printable(c), "write \\\\ for a backslash");
    out.push_back(kMeanings[index]);
    cursor.advance(2);
    return std::nullopt;
}

// Checks the spelling of a JSON number: optional minus, digits, optional fraction, optional exponent. Returns
// a help text for the first error, or nullptr if the spelling is right.
const char* number_fault(std::string_view s) {
    size_t i = 0;
    const auto digits = [&] {
        const size_t begin = i;
        while (i < s.size() && is_digit(s[i])) ++i;
        return i - begin;
    };
    if (!s.empty() && s[0] == '+') return "remove the '+'";
    if (i < s.size() && s[i] == '-') ++i;
    const size_t whole = i;
    const size_t count = digits();
    if (count == 0) return "write a digit before the decimal point";
    if (count > 1 && s[whole] == '0') return "remove the leading zeros; numbers are decimal";
    if (i < s.size() && s[i] == '.') {
        ++i;
        if (digits() == 0) return "write a digit after the decimal point";
    }
    if (i < s.size() && (s[i] == 'e' || s[i] == 'E')) {
        ++i;
        if (i < s.size() && (s[i] == '+' || s[i] == '-')) ++i;
        if (digits() == 0) return "write the digits of the exponent";
    }
    return i == s.size() ? nullptr : "write a decimal number, or put text in double quotes";
}

// Returns how many characters at the start of `text` stand for themselves in a string: no quote, no backslash
// and no control character.
size_t plain_length(std::string_view text) {
    size_t length = 0;
    while (length < text.size() && text[length] != '"' && text[length] != '\\' &&
           static_cast<unsigned char>(text[length]) >= 0x20)
        ++length;
    return length;
}

// Returns the length in bytes of the well-formed UTF-8 sequence at text[i], or 0 if the bytes there are not
// well-formed (Unicode 15, table 3-7).
size_t utf8_length(std::string_view text, size_t i) {
    const auto byte = [&](size_t k) -> uint32_t {
        return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0;
    };
    const auto tail = [&](size_t k) { return (byte(k) & 0xC0) == 0x80; };
    const uint32_t first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return tail(1) ? 2 : 0;
    if (first >= 0xE0 && first < 0xF0) {
        const bool overlong = first == 0xE0 && byte(1) < 0xA0;
        const bool surrogate = first == 0xED && byte(1) >= 0xA0;
        return tail(1) && tail(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0 && first < 0xF5) {
        const bool overlong = first == 0xF0 && byte(1) < 0x90;
        const bool beyond = first == 0xF4 && byte(1) >= 0x90;
        return tail(1) && tail(2) && tail(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

}  // namespace

void JsonCursor::advance(size_t count) {
    for (size_t i = 0; i < count && position_ < text_.size(); ++i) {
        if (text_[position_++] != '\n') continue;
        ++line_;
        line_start_ = position_;
    }
}

std::string printable(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) return std::string(1, c);
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "0x%02X", static_cast<unsigned>(byte));
    return text.data();
}

std::optional<JsonFault> skip_blank(JsonCursor& cursor) {
    for (;;) {
        const char c = cursor.peek();
        if (c == ' ' || c == '\t' || c == '\r') {
            cursor.advance_in_line(1);
        } else if (c == '\n') {
            cursor.advance();
        } else if (c == '/' && cursor.peek(1) == '/') {
            while (!cursor.at_end() && cursor.peek() != '\n') cursor.advance();
        } else if (c == '/' && cursor.peek(1) == '*') {
            const SourceLoc open = cursor.here(2);
            cursor.advance(2);
            while (!cursor.at_end() && (cursor.peek() != '*' || cursor.peek(1) != '/')) cursor.advance();
            if (cursor.at_end()) return syntax(open, "the comment has no end", "add the missing */");
            cursor.advance(2);
        } else {
            return std::nullopt;
        }
    }
}

std::optional<JsonFault> scan_string(JsonCursor& cursor, std::string& out) {
    const SourceLoc open = cursor.here();
    cursor.advance();
    out.clear();
    while (cursor.peek() != '"' || cursor.at_end()) {
        const char c = cursor.peek();
        if (cursor.at_end() || c == '\n' || c == '\r')
            return syntax(open, "the string has no closing quote on its line",
                          "add the closing quote; write \\n for a line break");
        if (static_cast<unsigned char>(c) < 0x20)
            return syntax(cursor.here(), "control character " + printable(c) + " in a string",
                          c == '\t' ? "write \\t" : "remove it");
        if (c == '\\') {
            if (auto fault = scan_escape(cursor, out)) return fault;
            continue;
        }
        const size_t plain = plain_length(cursor.rest());
        out.append(cursor.rest(), 0, plain);
        cursor.advance_in_line(plain);
    }
    cursor.advance();
    return std::nullopt;
}

std::optional<JsonFault> scan_number(JsonCursor& cursor, double& number, std::string& spelling) {
    SourceLoc loc = cursor.here();
    const size_t begin = cursor.position();
    const auto belongs = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.' ||
               c == '_';
    };
    while (!cursor.at_end() && belongs(cursor.peek())) cursor.advance();
    spelling = std::string(cursor.from(begin));
    loc.length = static_cast<uint32_t>(spelling.size());
    if (const char* help = number_fault(spelling))
        return syntax(loc, "\"" + spelling + "\" is not a number", help);
    const auto parsed = std::from_chars(spelling.data(), spelling.data() + spelling.size(), number);
    if (parsed.ec != std::errc{})
        return syntax(loc, "the number " + spelling + " is out of range",
                      "use 0, or a magnitude from 1e-307 to 1e308");
    return std::nullopt;
}

std::optional<JsonFault> check_utf8(std::string_view text) {
    size_t position = 0;
    while (position < text.size()) {
        if (static_cast<unsigned char>(text[position]) < 0x80) {
            ++position;
            continue;
        }
        const size_t length = utf8_length(text, position);
        if (length == 0) break;
        position += length;
    }
    if (position == text.size()) return std::nullopt;
    JsonCursor cursor(text);
    cursor.advance(position);
    return JsonFault{"W005",
                     cursor.here(),
                     "the file is not UTF-8: found the invalid byte " + printable(cursor.peek()),
                     "save the file as UTF-8",
                     std::nullopt,
                     {}};
}

}  // namespace weft
