// Purpose: the lexical half of the JSON reader: blanks and comments, strings, numbers, UTF-8. It knows where
// it stands, so that every fault is at its very character.
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
    // `file`: index into SourceMap::files, for the places it reports.
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

 private:
    std::string_view text_;
    size_t position_ = 0;
    size_t line_start_ = 0;
    uint32_t line_ = 1;
    uint32_t file_ = 0;
};

// Each returns the fault that stopped it, or nothing.
[[nodiscard]] std::optional<JsonFault> skip_blank(JsonCursor& cursor);
// At the opening quote; ends behind the closing one.
[[nodiscard]] std::optional<JsonFault> scan_string(JsonCursor& cursor, std::string& out);
// At the first character of something that may be a number.
[[nodiscard]] std::optional<JsonFault> scan_number(JsonCursor& cursor, double& number, std::string& spelling);
[[nodiscard]] std::optional<JsonFault> check_utf8(std::string_view text);

// 'x', or its byte when it can't be printed.
[[nodiscard]] std::string printable(char c);

}  // namespace weft
