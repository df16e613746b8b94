#include "scene/texture_build.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "scene/image_decode.h"
#include "scene/mip_chain.h"

namespace weft::scene::gltf {
namespace {

// What makes two uses of an image the same texture.
struct Use {
    uint32_t image = kNone;
    TexelMeaning meaning = TexelMeaning::linear_data;
    float alpha_cutoff = -1;

    friend bool operator<(const Use& a, const Use& b) {
        return std::tie(a.image, a.meaning, a.alpha_cutoff) < std::tie(b.image, b.meaning, b.alpha_cutoff);
    }
};

struct SlotUse {
    TextureSlot* slot = nullptr;
    Use use;
};

std::vector<SlotUse> slot_uses(const Document& document, std::vector<Material>& materials) {
    std::vector<SlotUse> uses;
    const auto add = [&](TextureSlot& slot, TexelMeaning meaning, float alpha_cutoff = -1) {
        if (slot.texture == kNone) return;
        const uint32_t image = document.texture_images[slot.texture];
        slot.texture = kNone;
        if (image != kNone) uses.push_back({&slot, {image, meaning, alpha_cutoff}});
    };
    for (Material& material : materials) {
        // The cutoff applies to the product of texture and factor.
        const bool mask = material.alpha_mode == AlphaMode::mask && material.base_color.a > 0;
        const float cutoff = mask ? material.alpha_cutoff / material.base_color.a : -1;
        add(material.base_color_texture, TexelMeaning::srgb_color, cutoff > 0 && cutoff <= 1 ? cutoff : -1);
        add(material.metallic_roughness_texture, TexelMeaning::linear_data);
        add(material.normal_texture, TexelMeaning::normal);
        add(material.occlusion_texture, TexelMeaning::linear_data);
        add(material.emissive_texture, TexelMeaning::srgb_color);
    }
    return uses;
}

std::span<const uint8_t> encoded_bytes(const Document& document, uint32_t image) {
    const EncodedImage& source = document.images[image];
    return source.view == kNone ? std::span<const uint8_t>(source.bytes) : view_bytes(document, source.view);
}

std::string image_pointer(uint32_t image) {
    return "/images/" + std::to_string(image);
}

void report_undecodable(Report& report, uint32_t image, const std::string& name, const std::string& why) {
    report.error("S112", image_pointer(image), "image \"" + name + "\" cannot be decoded: " + why,
                 "save it as PNG or JPEG again");
}

// True when every image and their sum stay within the limits; nothing is decoded.
bool sizes_within_limits(const Document& document, const std::map<Use, uint32_t>& uses,
                         const SceneLimits& limits, Report& report) {
    bool fine = true;
    uint64_t total_bytes = 0;
    uint32_t checked = kNone;
    std::optional<ImageSize> size;
    for (const auto& [use, texture] : uses) {
        const std::string& name = document.images[use.image].name;
        const bool first_use = use.image != checked;
        checked = use.image;
        if (first_use) size = read_image_size(encoded_bytes(document, use.image));
        if (!size) {
            if (first_use)
                report_undecodable(report, use.image, name, "it is neither PNG nor JPEG, or cut short");
            fine = false;
            continue;
        }
        const std::string measured = std::to_string(size->width_px) + "×" + std::to_string(size->height_px);
        if (std::max(size->width_px, size->height_px) > limits.image_side_px) {
            if (first_use) {
                report.error("S106", image_pointer(use.image),
                             "image \"" + name + "\" is " + measured + ", the limit is " +
                                 std::to_string(limits.image_side_px) + " a side",
                             "scale the image down");
            }
            fine = false;
            continue;
        }
        const uint64_t before = total_bytes;
        total_bytes += uint64_t{size->width_px} * size->height_px * 4;
        if (before > limits.decoded_image_bytes || total_bytes <= limits.decoded_image_bytes) continue;
        report.error("S106", image_pointer(use.image),
                     "image \"" + name + "\", " + measured + ", brings the decoded textures to " +
                         std::to_string(total_bytes) + " bytes, the limit is " +
                         std::to_string(limits.decoded_image_bytes),
                     "scale the images down");
        fine = false;
    }
    return fine;
}

Texture make_texture(const std::string& name, const ImageSize& size, std::vector<uint8_t> rgba,
                     const Use& use) {
    Texture texture;
    texture.name = name;
    texture.width_px = size.width_px;
    texture.height_px = size.height_px;
    texture.color_space = use.meaning == TexelMeaning::srgb_color ? ColorSpace::srgb : ColorSpace::linear;
    texture.mips =
        build_mip_chain(size.width_px, size.height_px, std::move(rgba), {use.meaning, use.alpha_cutoff});
    return texture;
}

}  // namespace

std::vector<Texture> build_textures(const Document& document, const SceneLimits& limits, Report& report,
                                    std::vector<Material>& materials) {
    std::vector<Texture> textures;
    const std::vector<SlotUse> slots = slot_uses(document, materials);
    std::map<Use, uint32_t> texture_of;
    for (const SlotUse& slot : slots) texture_of.emplace(slot.use, kNone);
    if (!sizes_within_limits(document, texture_of, limits, report)) return textures;
    // The map is ordered by image first, so each is decoded once and its pixels live no longer than needed.
    DecodedImage decoded;
    uint32_t decoded_image = kNone;
    for (auto it = texture_of.begin(); it != texture_of.end(); ++it) {
        const Use& use = it->first;
        const std::string& name = document.images[use.image].name;
        if (use.image != decoded_image) {
            decoded = decode_image(encoded_bytes(document, use.image));
            decoded_image = use.image;
            if (decoded.rgba.empty()) report_undecodable(report, use.image, name, decoded.error);
        }
        if (decoded.rgba.empty()) continue;
        const bool last_use = std::next(it) == texture_of.end() || std::next(it)->first.image != use.image;
        it->second = static_cast<uint32_t>(textures.size());
        textures.push_back(
            make_texture(name, decoded.size, last_use ? std::move(decoded.rgba) : decoded.rgba, use));
    }
    for (const SlotUse& slot : slots) slot.slot->texture = texture_of.at(slot.use);
    return textures;
}

}  // namespace weft::scene::gltf
