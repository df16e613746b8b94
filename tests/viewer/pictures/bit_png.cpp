#include "tests/viewer/pictures/bit_png.h"

#include <array>

namespace weft::test {
namespace {

void append_big_endian(std::string& to, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        to += static_cast<char>(static_cast<uint8_t>(value >> shift));
}

constexpr std::array<uint32_t, 256> kCrcTable = [] {
    std::array<uint32_t, 256> table{};
    for (uint32_t i = 0; i < table.size(); ++i) {
        table[i] = i;
        for (int bit = 0; bit < 8; ++bit)
            table[i] = (table[i] >> 1) ^ ((table[i] & 1) != 0 ? 0xEDB88320u : 0);
    }
    return table;
}();

uint32_t crc32(const std::string& bytes) {
    uint32_t crc = 0xFFFFFFFFu;
    for (const char c : bytes) crc = (crc >> 8) ^ kCrcTable[(crc ^ static_cast<uint8_t>(c)) & 0xFF];
    return ~crc;
}

// Writes single bits into bytes. By RFC 1951, the highest bit of a Huffman code comes first, and the lowest
// bit of any other value comes first.
class BitWriter {
 public:
    void bits(uint32_t value, int count) {
        for (int i = 0; i < count; ++i) bit((value >> i) & 1);
    }
    void code(uint32_t value, int count) {
        for (int i = count; i-- > 0;) bit((value >> i) & 1);
    }
    std::string take() {
        while (used_ != 0) bit(0);
        return std::move(bytes_);
    }

 private:
    void bit(uint32_t b) {
        current_ |= b << used_;
        if (++used_ < 8) return;
        bytes_ += static_cast<char>(static_cast<uint8_t>(current_));
        current_ = 0;
        used_ = 0;
    }

    std::string bytes_;
    uint32_t current_ = 0;
    int used_ = 0;
};

// Returns `count` zero bytes as a zlib stream (RFC 1950): one literal zero, then commands that each copy 258
// bytes from distance 1. Literal zeros follow for the remaining bytes (fewer than 258).
std::string zeros(uint64_t count) {
    BitWriter out;
    // This bit marks the last block of the stream.
    out.bits(1, 1);
    // The value 1 selects fixed Huffman codes.
    out.bits(1, 2);
    const auto literal = [&] { out.code(0x30, 8); };
    uint64_t left = count;
    if (left > 0) literal(), --left;
    for (; left >= 258; left -= 258) {
        out.code(0xC0 + (285 - 280), 8);
        out.code(0, 5);
    }
    for (; left > 0; --left) literal();
    // Seven zero bits are the code for the end of the block.
    out.code(0, 7);
    std::string stream = "\x78\x9c" + out.take();
    // Adler-32 checksum of `count` zero bytes: the low half is 1, the high half is `count` modulo 65521.
    append_big_endian(stream, static_cast<uint32_t>(count % 65521) << 16 | 1);
    return stream;
}

}  // namespace

std::string png_chunk(std::string_view type, std::string_view data) {
    std::string text, checked(type);
    checked += data;
    append_big_endian(text, static_cast<uint32_t>(data.size()));
    text += checked;
    append_big_endian(text, crc32(checked));
    return text;
}

namespace {

std::string black_png_with(uint32_t width_px, uint32_t height_px, uint64_t data_bytes) {
    std::string header;
    append_big_endian(header, width_px);
    append_big_endian(header, height_px);
    // The five bytes mean: bit depth 1, greyscale, the only compression and filter methods, no interlacing.
    header += std::string("\1\0\0\0\0", 5);
    return std::string("\x89PNG\r\n\x1a\n") + png_chunk("IHDR", header) +
           png_chunk("IDAT", zeros(data_bytes)) + png_chunk("IEND", "");
}

}  // namespace

std::string black_png(uint32_t width_px, uint32_t height_px) {
    const uint64_t row_bytes = 1 + (uint64_t{width_px} + 7) / 8;
    return black_png_with(width_px, height_px, row_bytes * height_px);
}

std::string swollen_png(uint64_t data_bytes) {
    return black_png_with(1, 1, data_bytes);
}

}  // namespace weft::test
