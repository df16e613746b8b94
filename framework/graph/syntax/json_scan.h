// Purpose: the lexer of the JSON reader. Skips whitespace and comments, reads strings and numbers, and checks
// UTF-8. Tracks the line and column, so that every error has an exact place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "weft/source.h"

namespace weft {

struct JsonFault {
    std::string code;
    SourceLoc loc;
    std::string message;
    std::string help;
    std::optional<SourceLoc> note_loc;
    std::string note;
};

class JsonCursor {
 public:
    // `file` is the index into SourceMap::files for the places that the cursor reports.
    explicit JsonCursor(std::string_view text, uint32_t file = 0) : text_(text), file_(file) {}

    [[nodiscard]] bool at_end() const { return position_ >= text_.size(); }
    [[nodiscard]] char peek(size_t ahead = 0) const {
        return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
    }
    [[nodiscard]] bool starts_with(std::string_view text) const {
        return text_.substr(position_).starts_with(text);
    }
    [[nodiscard]] size_t position() const { return position_; }
    [[nodiscard]] std::string_view from(size_t begin) const { return text_.substr(begin, position_ - begin); }
    [[nodiscard]] SourceLoc here(uint32_t length = 1) const {
        return {file_, line_, static_cast<uint32_t>(position_ - line_start_) + 1, length};
    }
    void advance(size_t count = 1);
    // Moves over `count` characters, none of which is a line break.
    void advance_in_line(size_t count) { position_ += count; }
    [[nodiscard]] std::string_view rest() const { return text_.substr(position_); }

 private:
    std::string_view text_;
    size_t position_ = 0;
    size_t line_start_ = 0;
    uint32_t line_ = 1;
    uint32_t file_ = 0;
};

// Skips whitespace and comments. Returns the error if a comment is not closed, otherwise nullopt.
[[nodiscard]] std::optional<JsonFault> skip_blank(JsonCursor& cursor);
// Reads a string into `out`. The cursor must be at the opening quote and ends after the closing quote.
// Returns the error that stopped reading, or nullopt.
[[nodiscard]] std::optional<JsonFault> scan_string(JsonCursor& cursor, std::string& out);
// Reads a number, with the cursor at its first character. Stores its value in `number` and its text in
// `spelling`. Returns the error if the text is not a number or the number is out of range, otherwise nullopt.
[[nodiscard]] std::optional<JsonFault> scan_number(JsonCursor& cursor, double& number, std::string& spelling);
// Returns the error W005 for the first invalid byte, or nullopt if the whole text is UTF-8.
[[nodiscard]] std::optional<JsonFault> check_utf8(std::string_view text);

// Returns the character itself, or its byte value such as "0x07" if the character is not printable ASCII.
[[nodiscard]] std::string printable(char c);

}  // namespace weft
