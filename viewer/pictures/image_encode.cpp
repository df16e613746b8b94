#include "viewer/pictures/image_encode.h"

#include <tinyexr.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace weft::viewer {
namespace {

constexpr size_t kChannels = 4;

Diagnostic cannot_encode(const std::string& why) {
    Diagnostic d;
    d.code = "X510";
    d.message = "the picture cannot be encoded: " + why;
    d.help = {"use a smaller --size"};
    return d;
}

// Splits RGBA texels into one plane per channel. tinyexr expects the planes in the alphabetical order of
// their names: A, B, G, R.
std::array<std::vector<float>, kChannels> planes_abgr(std::span<const glm::vec4> texels) {
    std::array<std::vector<float>, kChannels> planes;
    for (size_t plane = 0; plane < kChannels; ++plane) {
        planes[plane].reserve(texels.size());
        const auto channel = static_cast<glm::length_t>(kChannels - 1 - plane);
        for (const glm::vec4& texel : texels) planes[plane].push_back(texel[channel]);
    }
    return planes;
}

}  // namespace

Result<std::string> encode_exr(uint32_t width_px, uint32_t height_px, std::span<const glm::vec4> texels) {
    std::array<std::vector<float>, kChannels> planes = planes_abgr(texels);
    std::array<unsigned char*, kChannels> images{};
    std::array<EXRChannelInfo, kChannels> channels{};
    std::array<int, kChannels> types{};
    types.fill(TINYEXR_PIXELTYPE_FLOAT);
    for (size_t i = 0; i < kChannels; ++i) {
        images[i] = reinterpret_cast<unsigned char*>(planes[i].data());
        channels[i].name[0] = "ABGR"[i];
    }
    EXRHeader header;
    InitEXRHeader(&header);
    const bool is_small = width_px < 16 && height_px < 16;
    header.compression_type = is_small ? TINYEXR_COMPRESSIONTYPE_NONE : TINYEXR_COMPRESSIONTYPE_ZIP;
    header.num_channels = kChannels;
    header.channels = channels.data();
    header.pixel_types = header.requested_pixel_types = types.data();
    EXRImage image;
    InitEXRImage(&image);
    image.num_channels = kChannels;
    image.images = images.data();
    image.width = static_cast<int>(width_px);
    image.height = static_cast<int>(height_px);
    unsigned char* memory = nullptr;
    const char* why = nullptr;
    const size_t length = SaveEXRImageToMemory(&image, &header, &memory, &why);
    const std::unique_ptr<unsigned char, decltype(&std::free)> bytes(memory, &std::free);
    if (length > 0) return std::string(reinterpret_cast<const char*>(bytes.get()), length);
    Diagnostic fault = cannot_encode(why ? why : "out of memory");
    FreeEXRErrorMessage(why);
    return fault;
}

Result<std::string> encode_pfm(uint32_t width_px, uint32_t height_px, std::span<const glm::vec4> texels) {
    // In the header of a PFM file, a negative scale means little endian.
    std::string out = "PF\n" + std::to_string(width_px) + " " + std::to_string(height_px) + "\n-1.0\n";
    out.reserve(out.size() + texels.size() * 3 * sizeof(float));
    for (uint32_t y = height_px; y-- > 0;) {
        for (const glm::vec4& t : texels.subspan(size_t{y} * width_px, width_px)) {
            const std::array<float, 3> rgb{t.r, t.g, t.b};
            std::array<char, sizeof rgb> bytes;
            std::memcpy(bytes.data(), rgb.data(), sizeof rgb);
            out.append(bytes.data(), bytes.size());
        }
    }
    return out;
}

}  // namespace weft::viewer
