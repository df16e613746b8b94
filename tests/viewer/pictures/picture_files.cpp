#include "tests/viewer/pictures/picture_files.h"

#include <algorithm>
#include <cstring>

#include "tests/scene/gltf/gltf_fixture.h"

namespace weft::test {
namespace {

template <class T>
void put(std::string& out, T value) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof value);
    out.append(bytes.data(), bytes.size());
}

void put_name(std::string& out, const std::string& name) {
    out += name;
    out += '\0';
}

void put_attribute(std::string& out, const std::string& name, const std::string& type,
                   const std::string& value) {
    put_name(out, name);
    put_name(out, type);
    put(out, static_cast<int32_t>(value.size()));
    out += value;
}

template <class... T>
std::string packed(T... values) {
    std::string out;
    (put(out, values), ...);
    return out;
}

std::string exr_header(uint32_t width_px, uint32_t height_px) {
    std::string channels;
    for (const char* name : {"B", "G", "R"}) {
        put_name(channels, name);
        // The fields mean: 32-bit float (2), no flags, and no subsampling in x and y.
        channels += packed(int32_t{2}, int32_t{0}, int32_t{1}, int32_t{1});
    }
    channels += '\0';
    const std::string window = packed(int32_t{0}, int32_t{0}, static_cast<int32_t>(width_px) - 1,
                                      static_cast<int32_t>(height_px) - 1);
    std::string out = packed(int32_t{20000630}, int32_t{2});
    put_attribute(out, "channels", "chlist", channels);
    put_attribute(out, "compression", "compression", packed(char{0}));
    put_attribute(out, "dataWindow", "box2i", window);
    put_attribute(out, "displayWindow", "box2i", window);
    put_attribute(out, "lineOrder", "lineOrder", packed(char{0}));
    put_attribute(out, "pixelAspectRatio", "float", packed(1.0f));
    put_attribute(out, "screenWindowCenter", "v2f", packed(0.0f, 0.0f));
    put_attribute(out, "screenWindowWidth", "float", packed(1.0f));
    out += '\0';
    return out;
}

}  // namespace

std::string pfm_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels, bool big_endian) {
    std::string out = "PF\n" + std::to_string(width_px) + " " + std::to_string(height_px) +
                      (big_endian ? "\n1.0\n" : "\n-1.0\n");
    for (uint32_t y = height_px; y-- > 0;)
        for (const Texel& texel : texels.subspan(size_t{y} * width_px, width_px))
            for (const float value : texel) {
                std::string bytes = packed(value);
                if (big_endian) std::reverse(bytes.begin(), bytes.end());
                out += bytes;
            }
    return out;
}

std::string exr_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels) {
    std::string out = exr_header(width_px, height_px);
    const uint32_t line_bytes = width_px * 3 * 4;
    const uint64_t first = out.size() + uint64_t{height_px} * 8;
    for (uint32_t y = 0; y < height_px; ++y) put(out, first + uint64_t{y} * (line_bytes + 8));
    for (uint32_t y = 0; y < height_px; ++y) {
        put(out, y);
        put(out, line_bytes);
        for (const size_t channel : {2, 1, 0})
            for (uint32_t x = 0; x < width_px; ++x) put(out, texels[size_t{y} * width_px + x][channel]);
    }
    return out;
}

std::string png_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels) {
    scene::test::Bytes rgba;
    for (const Texel& texel : texels) {
        for (const float value : texel) rgba.push_back(static_cast<uint8_t>(value));
        rgba.push_back(255);
    }
    const scene::test::Bytes bytes = scene::test::png(width_px, height_px, rgba);
    return {bytes.begin(), bytes.end()};
}

}  // namespace weft::test
