#include "scene/load_environment.h"

#include "scene/radiance_picture.h"
#include "scene/rooted_folder.h"

namespace weft::scene {
namespace {

constexpr uint64_t kBytesPerTexel = sizeof(glm::vec3);
constexpr uint64_t kMaxFileBytes = 1ull << 30;

Diagnostic fault(const char* code, const std::filesystem::path& file, std::string message, std::string help) {
    Diagnostic d;
    d.code = code;
    d.file = file.string();
    d.message = std::move(message);
    d.help = {std::move(help)};
    return d;
}

}  // namespace

Result<Environment> load_environment(const std::filesystem::path& file, const SceneLimits& limits) {
    const FileBytes read = read_plain_file(file, kMaxFileBytes);
    if (read.fault)
        return fault("S180", file, "the environment can't be read: " + read.message,
                     "--env takes a Radiance picture (.hdr), sky or none");
    const RadianceHeader header = read_radiance_header(read.bytes);
    if (!header.error.empty())
        return fault("S180", file, "this is not a Radiance picture: " + header.error,
                     "save it as equirectangular Radiance HDR (32-bit_rle_rgbe)");
    const uint64_t texels = uint64_t{header.width_px} * header.height_px;
    if (header.width_px > limits.image_side_px || header.height_px > limits.image_side_px ||
        texels > limits.decoded_image_bytes / kBytesPerTexel)
        return fault("S181", file,
                     "the environment is " + std::to_string(header.width_px) + "x" +
                         std::to_string(header.height_px) + "; a side has at most " +
                         std::to_string(limits.image_side_px) + " px, and all take at most " +
                         std::to_string(limits.decoded_image_bytes) + " bytes at 12 a texel",
                     "scale it down: 2048x1024 shows no less in most pictures");
    const RadiancePicture picture = decode_radiance(header, read.bytes);
    if (!picture.error.empty())
        return fault("S180", file, "the environment can't be decoded: " + picture.error, "save it again");
    Environment environment = build_environment(header.width_px, header.height_px, picture.texels);
    environment.name = file.stem().string();
    return environment;
}

}  // namespace weft::scene
