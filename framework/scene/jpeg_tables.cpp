#include "scene/jpeg_tables.h"

#include <cstddef>

namespace weft::scene {
namespace {

constexpr uint8_t kMark = 0xFF;
constexpr uint8_t kStartOfImage = 0xD8;
constexpr uint8_t kHuffmanTables = 0xC4;
constexpr uint32_t kMostCodes = 256;
constexpr size_t kLengths = 16;  // counts of codes of 1 to 16 bits

// Markers that stand alone: padding, restarts, the image's start and end.
bool has_length(uint8_t marker) {
    const bool alone = marker == 0x00 || marker == 0x01 || (marker >= 0xD0 && marker <= 0xD9);
    return !alone;
}

// Walks markers as stb does, so that every table that it would read is seen. Behind the end all bytes are 0.
class Walk {
 public:
    explicit Walk(std::span<const uint8_t> bytes) : bytes_(bytes) {}

    // The next marker, 0xFF bytes that fill up before it and whatever lies between segments skipped; 0xFF:
    // none.
    uint8_t marker() {
        while (at_ < bytes_.size() && bytes_[at_] != kMark) ++at_;
        while (at_ < bytes_.size() && bytes_[at_] == kMark) ++at_;
        return at_ < bytes_.size() ? bytes_[at_++] : kMark;
    }
    uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : uint8_t{0}; }
    // Of the segment from here on, its own two bytes among them.
    uint32_t length_bytes() {
        const uint32_t high = byte();
        return high << 8 | byte();
    }
    void skip(size_t bytes) { at_ += bytes; }

 private:
    std::span<const uint8_t> bytes_;
    size_t at_ = 0;
};

bool tables_fit(Walk& walk, int64_t left_bytes) {
    while (left_bytes > 0) {
        walk.skip(1);  // class and slot
        uint32_t codes = 0;
        for (size_t i = 0; i < kLengths; ++i) codes += walk.byte();
        if (codes > kMostCodes) return false;
        walk.skip(codes);
        left_bytes -= static_cast<int64_t>(1 + kLengths + codes);
    }
    return true;
}

}  // namespace

bool jpeg_tables_fit(std::span<const uint8_t> encoded) {
    if (encoded.size() < 2 || encoded[0] != kMark) return true;
    Walk walk(encoded);
    if (walk.marker() != kStartOfImage) return true;
    for (uint8_t marker = walk.marker(); marker != kMark; marker = walk.marker()) {
        if (!has_length(marker)) continue;
        const uint32_t length_bytes = walk.length_bytes();
        if (length_bytes < 2) return true;  // refused by every decoder
        if (marker == kHuffmanTables) {
            if (!tables_fit(walk, int64_t{length_bytes} - 2)) return false;
        } else {
            // What follows a scan's header has no marker but restarts and 0xFF00 in it.
            walk.skip(length_bytes - 2);
        }
    }
    return true;
}

}  // namespace weft::scene
