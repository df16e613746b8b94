// Purpose: tests the messages of the image decoders for broken pictures, and the memory and time that they
// need.
#include "weft/scene/image_decode.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/scene/measured_child.h"
#include "tests/viewer/pictures/bit_png.h"

namespace weft::scene {
namespace {

using test::png_chunk;

constexpr uint64_t kMiB = 1 << 20;

std::span<const uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::string corpus(const std::string& name) {
    std::ifstream stream(WEFT_SOURCE_DIR "/tests/fuzz/corpus/image/" + name, std::ios::binary);
    std::string file{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_FALSE(file.empty()) << name;
    return file;
}

// Decodes a PNG of 6 × 3 pixels that has the given chunk between its header and its end.
DecodedImage decode_with(const std::string& chunk_behind_header) {
    using namespace std::literals;
    const std::string header = png_chunk("IHDR", "\0\0\0\6\0\0\0\3\x08\6\0\0\0"sv);
    const std::string file = "\x89PNG\r\n\x1a\n" + header + chunk_behind_header + png_chunk("IEND", "");
    return decode_image(bytes_of(file));
}

TEST(ImageDecode, MessagesArePrintable) {
    for (const std::string_view name :
         {std::string_view("WEFT"), std::string_view("\0\0\0T", 4), std::string_view("\x1b[2J", 4)}) {
        const DecodedImage image = decode_with(png_chunk(name, "data"));
        EXPECT_TRUE(image.rgba.empty());
        EXPECT_FALSE(image.error.empty());
        for (const char c : image.error) EXPECT_TRUE(c >= ' ' && c <= '~') << image.error;
    }
}

TEST(ImageDecode, APngWithoutDataIsRefused) {
    for (const std::string& data : {std::string(), png_chunk("IDAT", "")})
        EXPECT_FALSE(decode_with(data).error.empty());
}

TEST(ImageDecode, ADamagedPngIsRefused) {
    std::string file = corpus("rgba8.png");
    file[file.find("IDAT") + 6] ^= 1;
    EXPECT_TRUE(decode_image(bytes_of(file)).rgba.empty());
    EXPECT_FALSE(decode_image(bytes_of(file)).error.empty());
}

// The PNG has one texel, but its data inflate to 100 MB. The decoder must refuse the file before it inflates
// the data.
TEST(ImageDecode, APngOfMoreDataThanItsSizeNeedsIsRefusedBeforeItIsInflated) {
    const std::string file = test::swollen_png(100'000'000);
    ASSERT_LT(file.size(), kMiB);
    const test::Cost cost = test::cost_of([&] {
        const DecodedImage image = decode_image(bytes_of(file));
        return image.rgba.empty() && image.error.find("more data") != std::string::npos ? 0 : 1;
    });
    EXPECT_EQ(cost.answer, 0);
    EXPECT_LE(cost.grown_bytes, 4 * kMiB);
    EXPECT_LE(cost.cpu_s, 0.05);
    // A file whose data inflate to only 64 KB is accepted, although one texel needs much less. The decoder
    // inflates one row and ignores the rest.
    EXPECT_EQ(decode_image(bytes_of(test::swollen_png(64'000))).rgba.size(), 4u);
}

// Text chunks and colour profiles may inflate to 8 MB each, and a file may contain thousands of them. So the
// decoder must not inflate them.
TEST(ImageDecode, TextsAndProfilesAreNotInflated) {
    const std::string stream = test::swollen_png(8'000'000);
    const size_t begin = stream.find("IDAT") + 4, end = stream.find("IEND") - 8;
    const std::string text = png_chunk("zTXt", std::string("a\0\0", 3) + stream.substr(begin, end - begin));
    std::string file = test::black_png(4, 4);
    std::string texts;
    for (int i = 0; i < 40; ++i) texts += text;
    file.insert(file.find("IDAT") - 4, texts);
    const test::Cost cost =
        test::cost_of([&] { return decode_image(bytes_of(file)).rgba.size() == 64 ? 0 : 1; });
    EXPECT_EQ(cost.answer, 0);
    EXPECT_LE(cost.grown_bytes, 4 * kMiB);
}

// Each listed file is decoded as a whole, and also truncated to every smaller length. Decoding must need at
// most the memory that read_image_size() computes from the header, plus 2 MiB.
TEST(ImageDecode, TakesNoMoreThanTheHeaderSays) {
    for (const char* name : {"rgba8.png", "rgba16.png", "interlaced.png", "palette4.png", "base.jpg",
                             "prog.jpg", "progressive.jpg", "cmyk.jpg", "gray.jpg", "sub.jpg"}) {
        const std::string file = corpus(name);
        const std::optional<ImageSize> size = read_image_size(bytes_of(file));
        ASSERT_TRUE(size) << name;
        EXPECT_LE(size->decoder_bytes, 4 * kMiB) << name;
        const test::Cost cost = test::cost_of([&] {
            for (size_t length = 0; length < file.size(); ++length)
                (void)decode_image(bytes_of(std::string_view(file).substr(0, length)));
            return decode_image(bytes_of(file)).rgba.size() == size->texels() * 4 ? 0 : 1;
        });
        EXPECT_EQ(cost.answer, 0) << name;
        EXPECT_LE(cost.grown_bytes, size->texels() * 4 + size->decoder_bytes + 2 * kMiB) << name;
    }
}

// Returns a JPEG file in which the size in the frame header is changed.
std::string with_jpeg_size(std::string file, char frame, uint16_t width_px, uint16_t height_px) {
    const size_t at = file.find(std::string("\xff") + frame);
    EXPECT_NE(at, std::string::npos);
    for (size_t i = 0; i < 2; ++i) {
        file[at + 5 + i] = static_cast<char>(height_px >> (8 - 8 * i));
        file[at + 7 + i] = static_cast<char>(width_px >> (8 - 8 * i));
    }
    return file;
}

// A progressive JPEG needs memory for the coefficients of the whole picture. The size in its header
// determines how much.
TEST(ImageDecode, AProgressiveJpegCountsItsCoefficients) {
    const std::string file = with_jpeg_size(corpus("progressive.jpg"), '\xc2', 4096, 2048);
    const std::optional<ImageSize> size = read_image_size(bytes_of(file));
    ASSERT_TRUE(size);
    EXPECT_EQ(size->texels(), 4096u * 2048);
    EXPECT_GE(size->decoder_bytes, 4096u * 2048 * 6);
    const test::Cost cost = test::cost_of([&] { return decode_image(bytes_of(file)).rgba.empty() ? 0 : 1; });
    EXPECT_TRUE(cost.finished);
    EXPECT_LE(cost.grown_bytes, size->texels() * 4 + size->decoder_bytes + 2 * kMiB);
}

// Each scan of a progressive JPEG processes the whole picture. With very many scans, a small file could take
// hours to decode.
TEST(ImageDecode, AJpegOfManyScansIsRefused) {
    const std::string file = corpus("progressive.jpg");
    const size_t last = file.rfind("\xff\xda"), end = file.rfind("\xff\xd9");
    ASSERT_LT(last, end);
    std::string many = file.substr(0, end);
    for (int i = 0; i < 3000; ++i) many += file.substr(last, end - last);
    many = with_jpeg_size(many + file.substr(end), '\xc2', 2048, 2048);
    const test::Cost cost = test::cost_of([&] {
        const DecodedImage image = decode_image(bytes_of(many));
        return image.error.find("scans") != std::string::npos ? 0 : 1;
    });
    EXPECT_EQ(cost.answer, 0);
    EXPECT_LE(cost.cpu_s, 5);
}

TEST(ImageDecode, BrokenHuffmanTablesAreRefused) {
    for (const char* name : {"long_table.jpg", "no_such_table.jpg"}) {
        const DecodedImage image = decode_image(bytes_of(corpus(name)));
        EXPECT_TRUE(image.rgba.empty()) << name;
        EXPECT_FALSE(image.error.empty()) << name;
    }
}

}  // namespace
}  // namespace weft::scene
