// Purpose: numbers and texts one after another, for cache files and for what the compiler's worker and its
// caller say to each other. Layout: u64 little-endian; a text is its length and its bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace weft::shader {

class PayloadWriter {
 public:
    void number(uint64_t value);
    void text(std::string_view value);
    [[nodiscard]] const std::string& payload() const { return payload_; }

 private:
    std::string payload_;
};

// Every read past the end fails, and so do all after it.
class PayloadReader {
 public:
    explicit PayloadReader(std::string_view payload) : rest_(payload) {}

    [[nodiscard]] std::optional<uint64_t> number();
    [[nodiscard]] std::optional<std::string_view> text();
    [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
    std::string_view rest_;
};

}  // namespace weft::shader
