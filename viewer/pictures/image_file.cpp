#include "viewer/pictures/image_file.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "file/write_file.h"
#include "scene/pictures/mip_chain.h"
#include "scene/pictures/png_encode.h"
#include "viewer/pictures/image_encode.h"

namespace weft::viewer {
namespace {

Status write_encoded(const std::string& path, Result<std::string> bytes) {
    if (bytes) return write_file(path, *bytes);
    Diagnostics errors = bytes.take_errors();
    for (Diagnostic& error : errors) error.file = path;
    return errors;
}

std::vector<std::byte> display_encoded(std::span<const glm::vec4> texels) {
    std::vector<std::byte> bytes;
    bytes.reserve(texels.size() * 4);
    for (const glm::vec4& texel : texels) {
        for (int c = 0; c < 3; ++c)
            bytes.push_back(
                static_cast<std::byte>(scene::linear_to_srgb(glm::clamp(texel[c], 0.0f, 1.0f)) * 255 + .5f));
        bytes.push_back(std::byte{255});
    }
    return bytes;
}

}  // namespace

Result<ImageFileKind> image_file_kind(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) { return c | 0x20; });
    if (extension == ".png") return ImageFileKind::png;
    if (extension == ".exr") return ImageFileKind::exr;
    if (extension == ".pfm") return ImageFileKind::pfm;
    if (extension.empty() && is_stream(path)) return ImageFileKind::png;
    Diagnostic d;
    d.code = "X511";
    d.file = path;
    d.message = "the name of the picture ends in \"" + extension + "\"; wanted .png, .exr or .pfm";
    d.help = {"choose .png for a picture that is encoded for the display, .exr or .pfm for raw values"};
    return d;
}

Status write_png(const std::string& path, uint32_t width_px, uint32_t height_px,
                 std::span<const std::byte> rgba8) {
    return write_encoded(path, scene::encode_png(width_px, height_px, rgba8));
}

Status write_image(const std::string& path, uint32_t width_px, uint32_t height_px,
                   std::span<const glm::vec4> texels) {
    const Result<ImageFileKind> kind = image_file_kind(path);
    if (!kind) return kind.errors();
    if (*kind == ImageFileKind::pfm) return write_encoded(path, encode_pfm(width_px, height_px, texels));
    if (*kind == ImageFileKind::exr) return write_encoded(path, encode_exr(width_px, height_px, texels));
    return write_png(path, width_px, height_px, display_encoded(texels));
}

}  // namespace weft::viewer
