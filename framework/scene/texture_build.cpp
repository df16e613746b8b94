#include "scene/texture_build.h"

#include <algorithm>
#include <exception>
#include <map>
#include <tuple>

#include "scene/image_decode.h"
#include "scene/mip_chain.h"
#include "scene/worker_threads.h"

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
    uint32_t* texture = nullptr;
    Use use;
};

std::vector<SlotUse> slot_uses(const Document& document, std::vector<Material>& materials,
                               std::vector<LightFunction>& functions) {
    std::vector<SlotUse> uses;
    const auto add_texture = [&](uint32_t& texture, TexelMeaning meaning, float alpha_cutoff = -1) {
        if (texture == kNone) return;
        const uint32_t image = document.texture_images[texture];
        texture = kNone;
        if (image != kNone) uses.push_back({&texture, {image, meaning, alpha_cutoff}});
    };
    const auto add = [&](TextureSlot& slot, TexelMeaning meaning, float alpha_cutoff = -1) {
        add_texture(slot.texture, meaning, alpha_cutoff);
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
        add(material.anisotropy_texture, TexelMeaning::linear_data);
    }
    for (LightFunction& function : functions) add_texture(function.picture, TexelMeaning::srgb_color);
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

// Beside what is decoded already, so much is decoded at a time, unless one image is larger.
constexpr uint64_t kDecodedInHandBytes = 128ull << 20;

// One image and the textures it becomes.
struct ImageJob {
    uint32_t image = kNone;
    std::vector<Use> uses;
    size_t first_texture = 0;
    std::string error;  // filled by the job
};

// By image, in the file's order; `texture_of` gets the index that each use will have.
std::vector<ImageJob> jobs_for(std::map<Use, uint32_t>& texture_of) {
    std::vector<ImageJob> jobs;
    uint32_t textures = 0;
    for (auto& [use, texture] : texture_of) {
        if (jobs.empty() || jobs.back().image != use.image) jobs.push_back({use.image, {}, textures, {}});
        jobs.back().uses.push_back(use);
        texture = textures++;
    }
    return jobs;
}

void decode(const Document& document, ByteBudget& in_hand, ImageJob& job, std::vector<Texture>& textures) {
    try {
        const std::span<const uint8_t> encoded = encoded_bytes(document, job.image);
        const ImageSize size = read_image_size(encoded).value_or(ImageSize{});
        const ByteBudget::Share share(in_hand, uint64_t{size.width_px} * size.height_px * 4);
        DecodedImage decoded = decode_image(encoded);
        job.error = decoded.error;
        for (size_t i = 0; i < job.uses.size() && !decoded.rgba.empty(); ++i) {
            const bool last_use = i + 1 == job.uses.size();
            textures[job.first_texture + i] =
                make_texture(document.images[job.image].name, decoded.size,
                             last_use ? std::move(decoded.rgba) : decoded.rgba, job.uses[i]);
        }
    } catch (const std::exception& fault) {
        job.error = fault.what();  // out of memory: nothing else throws here
    }
}

}  // namespace

std::vector<Texture> build_textures(const Document& document, const SceneLimits& limits,
                                    const LoadOptions& options, Report& report,
                                    std::vector<Material>& materials, std::vector<LightFunction>& functions) {
    const std::vector<SlotUse> slots = slot_uses(document, materials, functions);
    std::map<Use, uint32_t> texture_of;
    for (const SlotUse& slot : slots) texture_of.emplace(slot.use, kNone);
    if (!sizes_within_limits(document, texture_of, limits, report)) return {};
    std::vector<ImageJob> jobs = jobs_for(texture_of);
    std::vector<Texture> textures(texture_of.size());
    ByteBudget in_hand(kDecodedInHandBytes);
    StageProgress progress(options, "textures", jobs.size());
    run_on_threads(jobs.size(), options.threads, [&](size_t i) {
        decode(document, in_hand, jobs[i], textures);
        progress.step();
    });
    for (const ImageJob& job : jobs) {
        if (!job.error.empty())
            report_undecodable(report, job.image, document.images[job.image].name, job.error);
    }
    for (const SlotUse& slot : slots) *slot.texture = texture_of.at(slot.use);
    return textures;
}

}  // namespace weft::scene::gltf
