#include "scene/pictures/load_environment.h"

#include <algorithm>
#include <limits>

#include "scene/loading/memory_budget.h"
#include "scene/loading/rooted_folder.h"
#include "scene/pictures/extract_suns.h"
#include "scene/pictures/light_picture.h"
#include "scene/pictures/radiance_picture.h"

namespace weft::scene {
namespace {

// Peak memory while loading, in bytes per texel of the picture:
// 24 for two decoded pictures, one with the suns and one without them (three floats each: 2 * 12),
// 6 for two mip levels as floats (each has at most a quarter of the texels: 2 * 12 / 4),
// 6 for the packed texels of all mips (4 bytes * 4 / 3, rounded up).
// Finding the suns needs at most 9 bytes, before the mips are made.
// Copies in staging memory and on the GPU do not count, because the decoded picture is freed before they are
// made.
constexpr uint64_t kBytesPerTexel = 2 * sizeof(glm::vec3) + 2 * sizeof(glm::vec3) / 4 + 6;

// Peak memory for the small picture for lighting, in bytes per texel of the small picture: two levels as
// floats, and 6 for the packed texels of all mips.
constexpr uint64_t kLightBytesPerTexel = 2 * sizeof(glm::vec3) + 6;

Diagnostic fault(const char* code, const std::filesystem::path& file, std::string message, std::string help) {
    Diagnostic d;
    d.code = code;
    d.file = file.string();
    d.message = std::move(message);
    d.help = {std::move(help)};
    return d;
}

}  // namespace

Result<Environment> load_environment(const std::filesystem::path& file, const SceneLimits& limits,
                                     float gain) {
    const FileBytes read = read_plain_file(file, std::min(limits.resource_bytes, limits.memory_bytes));
    if (read.fault)
        return fault("S180", file, "the environment cannot be read: " + read.message,
                     "use --env with a Radiance picture (.hdr), sky or none");
    const RadianceHeader header = read_radiance_header(read.bytes);
    if (!header.error.empty())
        return fault("S180", file, "the file is not a Radiance picture: " + header.error,
                     "save the picture as equirectangular Radiance HDR (32-bit_rle_rgbe)");
    const uint64_t texels = uint64_t{header.width_px} * header.height_px;
    const uint64_t light_texels = uint64_t{std::min(header.width_px, kMostLightWidth_px)} *
                                  std::min(header.height_px, kMostLightHeight_px);
    const uint64_t bytes = saturating_add(saturating_mul(texels, kBytesPerTexel),
                                          light_texels * kLightBytesPerTexel + read.bytes.size());
    const bool large = header.width_px > limits.image_side_px || header.height_px > limits.image_side_px;
    if (large || bytes > limits.memory_bytes)
        return fault(
            "S181", file,
            "the environment is " + std::to_string(header.width_px) + "x" + std::to_string(header.height_px) +
                (large
                     ? "; a side may have at most " + std::to_string(limits.image_side_px) + " px"
                     : " and needs " + std::to_string(bytes) + " bytes; beside the scene, the limit leaves " +
                           std::to_string(limits.memory_bytes) + " bytes"),
            "scale the picture down (2048x1024 is usually enough), " +
                raise_limit_text(large ? "scene.imageSidePx" : "scene.memoryBytes"));
    RadiancePicture picture = decode_radiance(header, read.bytes);
    if (!picture.error.empty())
        return fault("S180", file, "the environment cannot be decoded: " + picture.error,
                     "save the picture again");
    for (glm::vec3& texel : picture.texels)
        texel = glm::min(texel * gain, glm::vec3(std::numeric_limits<float>::max()));
    std::vector<glm::vec3> without_suns = picture.texels;
    std::vector<PictureSun> suns = extract_suns(header.width_px, header.height_px, without_suns);
    Environment environment =
        build_environment(header.width_px, header.height_px, picture.texels, without_suns);
    environment.suns = std::move(suns);
    environment.name = file.stem().string();
    return environment;
}

}  // namespace weft::scene
