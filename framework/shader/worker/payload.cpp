#include "shader/worker/payload.h"

namespace weft::shader {

void PayloadWriter::number(uint64_t value) {
    for (uint32_t i = 0; i < 8; ++i) payload_ += static_cast<char>(static_cast<uint8_t>(value >> (8 * i)));
}

void PayloadWriter::text(std::string_view value) {
    number(value.size());
    payload_ += value;
}

std::optional<uint64_t> PayloadReader::number() {
    if (rest_.size() < 8) {
        rest_ = {};
        return std::nullopt;
    }
    uint64_t value = 0;
    for (uint32_t i = 0; i < 8; ++i) value |= uint64_t{static_cast<uint8_t>(rest_[i])} << (8 * i);
    rest_.remove_prefix(8);
    return value;
}

std::optional<std::string_view> PayloadReader::text() {
    const auto length = number();
    if (!length || *length > rest_.size()) {
        rest_ = {};
        return std::nullopt;
    }
    const std::string_view value = rest_.substr(0, *length);
    rest_.remove_prefix(*length);
    return value;
}

}  // namespace weft::shader
