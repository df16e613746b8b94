// What a decoder says of pictures that are none.
#include "scene/image_decode.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "scene/jpeg_tables.h"

namespace weft::scene {
namespace {

std::span<const uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::string chunk(std::string_view name, std::string_view data) {
    std::string text(3, '\0');
    text += static_cast<char>(data.size());
    return text.append(name).append(data).append("CRC ");  // which stb doesn't check
}

// Of 6x3 pixels.
DecodedImage decode_with(const std::string& chunk_behind_header) {
    using namespace std::literals;
    const std::string header = chunk("IHDR", "\0\0\0\6\0\0\0\3\x08\6\0\0\0"sv);
    const std::string file = "\x89PNG\r\n\x1a\n" + header + chunk_behind_header + chunk("IEND", "");
    return decode_image(bytes_of(file));
}

TEST(ImageDecode, AChunkOfNoKnownKindIsNamedOnlyWhereItsNameIsText) {
    EXPECT_EQ(decode_with(chunk("WEFT", "data")).error, "WEFT PNG chunk not known");
    for (const std::string_view name : {std::string_view("\0\0\0T", 4), std::string_view("\x1b[2J", 4)}) {
        const DecodedImage image = decode_with(chunk(name, "data"));
        EXPECT_TRUE(image.rgba.empty());
        EXPECT_EQ(image.error, "a chunk has no name that PNG knows");
    }
}

TEST(ImageDecode, APngWithoutDataIsRefused) {
    for (const std::string& data : {std::string(), chunk("IDAT", "")})
        EXPECT_EQ(decode_with(data).error, "no IDAT");
}

// A table of so many codes, half of them of 9 and half of 10 bits: one length has 255 at most.
std::string jpeg_with_codes(uint32_t codes) {
    using namespace std::literals;
    std::string counts(16, '\0');
    counts[8] = static_cast<char>(codes / 2);
    counts[9] = static_cast<char>(codes - codes / 2);
    const auto length = static_cast<uint16_t>(2 + 17 + codes);
    std::string file = "\xff\xd8\xff\xe0\0\4\xff\xc4\xff\xff\xc4"s;  // FFC4 within a segment is no table
    file += static_cast<char>(length >> 8);
    file += static_cast<char>(length & 0xFF);
    return file + '\0' + counts + std::string(codes, '\1');
}

TEST(ImageDecode, AHuffmanTableOfMoreThan256CodesNeverReachesTheDecoder) {
    EXPECT_TRUE(jpeg_tables_fit(bytes_of(jpeg_with_codes(256))));
    EXPECT_FALSE(jpeg_tables_fit(bytes_of(jpeg_with_codes(257))));
    const std::string file = jpeg_with_codes(400);
    EXPECT_EQ(decode_image(bytes_of(file)).error, "a Huffman table has more than 256 codes");
    EXPECT_FALSE(read_image_size(bytes_of(file)));
    // Cut anywhere, it is still no picture.
    for (size_t length = 0; length < file.size(); ++length)
        EXPECT_TRUE(decode_image(bytes_of(std::string_view(file).substr(0, length))).rgba.empty());
}

// Memory that the decoder gets next.
void leave_behind(uint8_t value) {
    const std::vector<uint8_t> block(64 << 10, value);
    EXPECT_EQ(block.back(), value);
}

// The scan names Huffman tables that the file never defines.
TEST(ImageDecode, WhatMemoryHeldBeforeIsNoHuffmanTable) {
    std::ifstream stream(WEFT_SOURCE_DIR "/tests/fuzz/corpus/image/no_such_table.jpg", std::ios::binary);
    const std::string file{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_FALSE(file.empty());
    leave_behind(0);
    const DecodedImage clean = decode_image(bytes_of(file));
    for (const uint8_t value : {uint8_t{1}, uint8_t{9}, uint8_t{200}}) {
        leave_behind(value);
        const DecodedImage again = decode_image(bytes_of(file));
        EXPECT_EQ(again.error, clean.error);
        EXPECT_TRUE(again.rgba == clean.rgba);
    }
}

}  // namespace
}  // namespace weft::scene
