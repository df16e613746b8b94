#include "weft/load/resource_content.h"

#include <new>
#include <utility>

#include "load/data_file.h"
#include "load/picture_file.h"
#include "load/texel_encode.h"
#include "scene/pictures/mip_chain.h"
#include "shader/compile/content_hash.h"

namespace weft {
namespace {

Diagnostic unusable(const ResolvedGraph& graph, const ResourceDecl& resource, const std::string& fault,
                    const std::string& help) {
    return unusable_file(graph.sources, resource.loc, resource.file, resource.name, fault, help);
}

std::vector<std::byte> bytes_of_text(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

// Splits raw texels into the mips of the image.
std::vector<std::vector<std::byte>> split_mips(const ResourceDecl& image, std::string_view bytes) {
    std::vector<std::vector<std::byte>> levels;
    for (uint32_t mip = 0; mip < image.mips; ++mip) {
        const Extent3D e = mip_extent(image.extent, mip);
        const uint64_t level_bytes =
            uint64_t{e.width} * e.height * e.depth * image.layers * format_info(image.format).bytes_per_texel;
        levels.push_back(bytes_of_text(bytes.substr(0, level_bytes)));
        bytes.remove_prefix(level_bytes);
    }
    return levels;
}

// Converts a picture to the format of the image and makes its mips. Mips of sRGB formats are means in linear
// light.
std::vector<std::vector<std::byte>> convert(const ResourceDecl& image, PictureTexels picture) {
    const bool is_srgb = format_info(image.format).srgb;
    const bool is_encoded = is_srgb && picture.whole > 0;
    std::vector<std::vector<std::byte>> levels;
    levels.push_back(encode_texels(image.format, picture.values, {picture.whole, is_encoded}));
    if (is_encoded && image.mips > 1)
        for (glm::vec4& value : picture.values)
            for (int c = 0; c < 3; ++c) value[c] = scene::srgb_to_linear(value[c]);
    for (uint32_t mip = 1; mip < image.mips; ++mip) {
        const Extent3D e = mip_extent(image.extent, mip - 1);
        picture.values = halve(picture.values, e.width, e.height);
        levels.push_back(encode_texels(image.format, picture.values, {picture.whole, false}));
    }
    return levels;
}

Result<ResourceContent> read_content(const ResolvedGraph& graph, const ResourceDecl& resource,
                                     const LoadSettings& settings) {
    constexpr const char* kAgain = "load the graph again, because the file has changed";
    const DataFile file = read_data_file(resource.file_path, settings);
    if (!file.fault.empty()) return unusable(graph, resource, file.fault, file.help);
    ResourceContent content;
    content.hash = shader::hash_of(file.bytes);
    if (resource.kind == ResourceKind::buffer) {
        if (file.bytes.size() < resource.size_bytes)
            return unusable(graph, resource, "the file has become shorter", kAgain);
        content.levels.push_back(bytes_of_text(std::string_view(file.bytes).substr(0, resource.size_bytes)));
        return content;
    }
    const PictureHeader header = read_picture_header(file.bytes);
    const bool same_size =
        header.width_px == resource.extent.width && header.height_px == resource.extent.height;
    if (header.width_px == 0 && header.fault.empty() && file.bytes.size() == content_bytes(resource)) {
        content.levels = split_mips(resource, file.bytes);
        return content;
    }
    if (!same_size || decoding_bytes(header) > settings.limits.graph.file_bytes)
        return unusable(graph, resource, header.fault.empty() ? "its size has changed" : header.fault,
                        kAgain);
    PictureTexels picture = decode_picture(file.bytes);
    if (!picture.fault.empty())
        return unusable(graph, resource, picture.fault, "save the picture again with another program");
    if (picture.values.size() != uint64_t{resource.extent.width} * resource.extent.height)
        return unusable(graph, resource, "the data contradict the header",
                        "save the picture again with another program");
    content.levels = convert(resource, std::move(picture));
    return content;
}

}  // namespace

Result<ResourceContent> read_resource_content(const ResolvedGraph& graph, const ResourceDecl& resource,
                                              const LoadSettings& settings) {
    try {
        return read_content(graph, resource, settings);
    } catch (const std::bad_alloc&) {
        Diagnostic d =
            unusable(graph, resource, "memory ran out", "close other programs, or use a smaller file");
        d.code = "X571";
        return d;
    }
}

}  // namespace weft
