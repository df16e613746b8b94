// Purpose: serialises numbers and texts, for cache files and for the messages between compiler worker and
// caller. Layout: numbers are u64 little-endian; a text is its length followed by its bytes.
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

// After a read past the end, that read and all later ones fail.
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
