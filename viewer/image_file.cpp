#include "image_file.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wcast-qual"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb_image_write.h>
#pragma GCC diagnostic pop
#include <tinyexr.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "scene/mip_chain.h"

namespace weft::viewer {
namespace {

Diagnostic cannot_write(const std::string& path, const std::string& why) {
    Diagnostic d;
    d.code = "X512";
    d.file = path;
    d.message = "the picture cannot be written" + (why.empty() ? "" : ": " + why);
    d.help = {"check that its folder exists and has room"};
    return d;
}

Status write_pfm(const std::string& path, uint32_t width_px, uint32_t height_px,
                 std::span<const glm::vec4> texels) {
    std::ofstream out(path, std::ios::binary);
    // A negative scale says little endian.
    out << "PF\n" << width_px << " " << height_px << "\n-1.0\n";
    for (uint32_t y = height_px; y-- > 0;) {
        for (uint32_t x = 0; x < width_px; ++x) {
            const glm::vec4& t = texels[size_t{y} * width_px + x];
            const std::array<float, 3> rgb{t.r, t.g, t.b};
            std::array<char, sizeof rgb> bytes;
            std::memcpy(bytes.data(), rgb.data(), sizeof rgb);
            out.write(bytes.data(), bytes.size());
        }
    }
    out.close();
    if (!out) return cannot_write(path, "");
    return Unit{};
}

Status write_exr(const std::string& path, uint32_t width_px, uint32_t height_px,
                 std::span<const glm::vec4> texels) {
    const char* why = nullptr;
    const int status = SaveEXR(&texels[0].x, static_cast<int>(width_px), static_cast<int>(height_px), 4,
                               /*save_as_fp16=*/0, path.c_str(), &why);
    if (status == TINYEXR_SUCCESS) return Unit{};
    Diagnostic fault = cannot_write(path, why ? why : "");
    FreeEXRErrorMessage(why);
    return fault;
}

}  // namespace

Result<ImageFileKind> image_file_kind(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) { return c | 0x20; });
    if (extension == ".png") return ImageFileKind::png;
    if (extension == ".exr") return ImageFileKind::exr;
    if (extension == ".pfm") return ImageFileKind::pfm;
    Diagnostic d;
    d.code = "X511";
    d.file = path;
    d.message = "a picture's name ends in .png, .exr or .pfm, not in \"" + extension + "\"";
    d.help = {"--output frame.png for a display-encoded picture, .exr or .pfm for raw values"};
    return d;
}

Status write_png(const std::string& path, uint32_t width_px, uint32_t height_px,
                 std::span<const std::byte> rgba8) {
    const int width = static_cast<int>(width_px), height = static_cast<int>(height_px);
    if (stbi_write_png(path.c_str(), width, height, 4, rgba8.data(), width * 4) != 0) return Unit{};
    return cannot_write(path, "");
}

Status write_image(const std::string& path, uint32_t width_px, uint32_t height_px,
                   std::span<const glm::vec4> texels) {
    const Result<ImageFileKind> kind = image_file_kind(path);
    if (!kind) return kind.errors();
    if (*kind == ImageFileKind::pfm) return write_pfm(path, width_px, height_px, texels);
    if (*kind == ImageFileKind::exr) return write_exr(path, width_px, height_px, texels);
    std::vector<std::byte> bytes;
    bytes.reserve(texels.size() * 4);
    for (const glm::vec4& texel : texels) {
        for (int c = 0; c < 3; ++c)
            bytes.push_back(
                static_cast<std::byte>(scene::linear_to_srgb(glm::clamp(texel[c], 0.0f, 1.0f)) * 255 + .5f));
        bytes.push_back(std::byte{255});
    }
    return write_png(path, width_px, height_px, bytes);
}

}  // namespace weft::viewer
