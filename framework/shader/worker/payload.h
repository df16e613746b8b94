// Purpose: serialises numbers and texts, for cache files and for messages between the shader worker and its
// caller. A number is stored as u64, little-endian. A text is stored as its length followed by its bytes.
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

// Reads numbers and texts from a payload. After an attempt to read past the end, all further reads fail.
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
