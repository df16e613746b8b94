#include "scene/gltf/texture_build.h"

#include <algorithm>
#include <map>
#include <new>
#include <optional>
#include <tuple>

#include "scene/loading/worker_threads.h"
#include "scene/pictures/mip_chain.h"
#include "weft/limits.h"
#include "weft/scene/image_decode.h"

namespace weft::scene::gltf {
namespace {

// A way to use an image. Two uses share one texture if all members of Use are equal.
struct Use {
    uint32_t image = kNone;
    TexelMeaning meaning = TexelMeaning::linear_data;
    float alpha_cutoff = -1;  // The mask shows a texel if its alpha is at least this cutoff. -1: no mask.

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
        // The shader multiplies the alpha of the texture by the factor base_color.a, and compares the product
        // with the cutoff of the material. So the cutoff for the alpha of the texture alone is the cutoff of
        // the material divided by the factor.
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

std::string size_text(const ImageSize& size) {
    return std::to_string(size.width_px) + "×" + std::to_string(size.height_px);
}

void report_undecodable(Report& report, uint32_t image, const std::string& name, const std::string& why) {
    report.error("S112", image_pointer(image), "image \"" + shortened(name) + "\" cannot be decoded: " + why,
                 "save the image as PNG or JPEG again");
}

// Returns the size of the full mip chain in bytes, at four bytes per texel.
uint64_t mip_bytes(ImageSize size) {
    uint64_t bytes = 0;
    for (;; size = {std::max(1u, size.width_px / 2), std::max(1u, size.height_px / 2), 0}) {
        bytes = saturating_add(bytes, saturating_mul(size.texels(), 4));
        if (size.width_px <= 1 && size.height_px <= 1) return bytes;
    }
}

// Returns the temporary memory in bytes while one texture is made: the memory of the decoder, and the memory
// of mips 1 and 2 as floats (about 6 bytes per texel of mip 0).
uint64_t scratch_bytes(const ImageSize& size) {
    return saturating_add(size.decoder_bytes, saturating_mul(size.texels(), 6));
}

// Limit in bytes of the temporary memory of all threads together. A single image that needs more may exceed
// the limit.
constexpr uint64_t kInHandBytes = 64ull << 20;

// Computes the peak memory of all textures. First all textures are decoded. Then they are uploaded one at a
// time, and the decoded texture is freed after its upload. So at most one texture exists three times:
// decoded, in the staging buffer, and on the GPU.
class TextureMemory {
 public:
    void add(const ImageSize& size, size_t name_bytes) {
        const uint64_t mips = mip_bytes(size), scratch = scratch_bytes(size);
        kept_bytes_ = saturating_add(kept_bytes_, saturating_add(mips, sizeof(Texture) + 1024 + name_bytes));
        largest_bytes_ = std::max(largest_bytes_, mips);
        scratch_bytes_ = saturating_add(scratch_bytes_, scratch);
        largest_scratch_bytes_ = std::max(largest_scratch_bytes_, scratch);
    }
    [[nodiscard]] uint64_t most_bytes() const {
        const uint64_t in_hand = std::max(largest_scratch_bytes_, std::min(scratch_bytes_, kInHandBytes));
        return saturating_add(kept_bytes_, std::max(in_hand, saturating_mul(largest_bytes_, 2)));
    }

 private:
    uint64_t kept_bytes_ = 0, largest_bytes_ = 0, scratch_bytes_ = 0, largest_scratch_bytes_ = 0;
};

// Reads the size of each image, at most once per image. The size is nullopt if the image cannot be decoded or
// exceeds a limit.
class ImageSizes {
 public:
    ImageSizes(const Document& document, const SceneLimits& limits, Report& report)
        : document_(document), limits_(limits), report_(report) {}

    const std::optional<ImageSize>& of(uint32_t image) {
        const auto [found, is_new] = sizes_.try_emplace(image);
        if (is_new) found->second = measured(image);
        return found->second;
    }

 private:
    std::optional<ImageSize> measured(uint32_t image) {
        const std::string& name = document_.images[image].name;
        std::optional<ImageSize> size = read_image_size(encoded_bytes(document_, image));
        if (!size) {
            report_undecodable(report_, image, name, "the file is neither PNG nor JPEG, or is truncated");
            return std::nullopt;
        }
        if (std::max(size->width_px, size->height_px) <= limits_.image_side_px) return size;
        report_.error("S106", image_pointer(image),
                      "image \"" + shortened(name) + "\" is " + size_text(*size) + ", the limit is " +
                          std::to_string(limits_.image_side_px) + " px per side",
                      "scale the image down, " + raise_limit_text("scene.imageSidePx"));
        return std::nullopt;
    }

    const Document& document_;
    const SceneLimits& limits_;
    Report& report_;
    std::map<uint32_t, std::optional<ImageSize>> sizes_;
};

// Returns true when every image and the total memory stay within the limits. Then the memory is taken from
// the budget. No image is decoded here.
bool sizes_within_limits(const Document& document, const std::map<Use, uint32_t>& uses,
                         const SceneLimits& limits, MemoryBudget& memory, Report& report) {
    bool fine = true;
    ImageSizes sizes(document, limits, report);
    TextureMemory textures;
    for (const auto& [use, texture] : uses) {
        const std::optional<ImageSize>& size = sizes.of(use.image);
        fine &= size.has_value();
        if (!size) continue;
        const std::string& name = document.images[use.image].name;
        textures.add(*size, name.size());
        if (textures.most_bytes() <= memory.left_bytes()) continue;
        return take_memory(memory,
                           {textures.most_bytes(), "S106", image_pointer(use.image),
                            "image \"" + shortened(name) + "\" (" + size_text(*size) + ") and its mips",
                            "scale the images down"},
                           report);
    }
    return fine && memory.take(textures.most_bytes());
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

// A job for one thread: one image and all textures that are made from the image.
struct ImageJob {
    uint32_t image = kNone;
    std::vector<Use> uses;
    size_t first_texture = 0;  // Index of the texture for uses[0]; the textures for the other uses follow.
    // Text of the fault, empty after success. Only the thread that runs the job writes this and the next
    // member.
    std::string error;
    bool is_out_of_memory = false;
};

// Makes one job per image, in the order of the file. Stores in `texture_of` the index that the texture of
// each use will have.
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
        const ByteBudget::Share share(in_hand, scratch_bytes(size));
        DecodedImage decoded = decode_image(encoded);
        job.error = decoded.error;
        for (size_t i = 0; i < job.uses.size() && !decoded.rgba.empty(); ++i) {
            const bool last_use = i + 1 == job.uses.size();
            textures[job.first_texture + i] =
                make_texture(document.images[job.image].name, decoded.size,
                             last_use ? std::move(decoded.rgba) : decoded.rgba, job.uses[i]);
        }
    } catch (const std::bad_alloc&) {
        // std::bad_alloc must not leave the job, because jobs run on other threads. No other exception is
        // possible here.
        job.is_out_of_memory = true;
    }
}

}  // namespace

std::vector<Texture> build_textures(const Document& document, const SceneLimits& limits,
                                    const LoadOptions& options, MemoryBudget& memory, Report& report,
                                    std::vector<Material>& materials, std::vector<LightFunction>& functions) {
    const std::vector<SlotUse> slots = slot_uses(document, materials, functions);
    std::map<Use, uint32_t> texture_of;
    for (const SlotUse& slot : slots) texture_of.emplace(slot.use, kNone);
    if (!sizes_within_limits(document, texture_of, limits, memory, report)) return {};
    std::vector<ImageJob> jobs = jobs_for(texture_of);
    std::vector<Texture> textures(texture_of.size());
    ByteBudget in_hand(kInHandBytes);
    StageProgress progress(options, "textures", jobs.size());
    run_on_threads(jobs.size(), options.threads, [&](size_t i) {
        decode(document, in_hand, jobs[i], textures);
        progress.step();
    });
    for (const ImageJob& job : jobs) {
        if (job.is_out_of_memory)
            report.error("X571", image_pointer(job.image), "memory ran out while the image was decoded",
                         "close other programs, or scale the images down");
        if (!job.error.empty())
            report_undecodable(report, job.image, document.images[job.image].name, job.error);
    }
    for (const SlotUse& slot : slots) *slot.texture = texture_of.at(slot.use);
    return textures;
}

}  // namespace weft::scene::gltf
