#include "scene/procedural/procedural_texture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/pictures/mip_chain.h"

namespace weft::scene {
namespace {

using Bytes = std::vector<uint8_t>;

uint8_t to_byte(float x) {
    return static_cast<uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

Texture blank_texture(std::string name, uint32_t width_px, uint32_t height_px, ColorSpace space) {
    Texture texture;
    texture.name = std::move(name);
    texture.width_px = width_px;
    texture.height_px = height_px;
    texture.color_space = space;
    texture.mips.emplace_back(static_cast<size_t>(width_px) * height_px * 4, static_cast<uint8_t>(255));
    return texture;
}

void build_mips(Texture& texture, const MipOptions& options) {
    texture.mips = build_mip_chain(texture.width_px, texture.height_px, std::move(texture.mips[0]), options);
}

uint32_t push_texture(Scene& scene, Texture texture) {
    scene.textures.push_back(std::move(texture));
    return static_cast<uint32_t>(scene.textures.size() - 1);
}

void write_normals(const Surface& surface, Bytes& out) {
    const uint32_t mask = surface.size_px - 1;
    const float slope_scale = static_cast<float>(surface.size_px) / (2 * surface.period_m);
    for (uint32_t y = 0; y < surface.size_px; ++y) {
        for (uint32_t x = 0; x < surface.size_px; ++x) {
            const auto height = [&](uint32_t px, uint32_t py) {
                return surface.at(px & mask, py & mask).height_m;
            };
            const float right = (height(x + 1, y) - height(x + mask, y)) * slope_scale;
            const float down = (height(x, y + 1) - height(x, y + mask)) * slope_scale;
            const glm::vec3 normal = glm::normalize(glm::vec3(-right, down, 1));
            uint8_t* texel = &out[(static_cast<size_t>(y) * surface.size_px + x) * 4];
            for (int c = 0; c < 3; ++c) texel[c] = to_byte(normal[c] * 0.5f + 0.5f);
        }
    }
}

}  // namespace

Surface make_surface(uint32_t size_px, float period_m,
                     const std::function<Texel(uint32_t, uint32_t)>& recipe) {
    Surface surface{size_px, period_m, std::vector<Texel>(static_cast<size_t>(size_px) * size_px)};
    for (uint32_t y = 0; y < size_px; ++y) {
        for (uint32_t x = 0; x < size_px; ++x) surface.at(x, y) = recipe(x, y);
    }
    return surface;
}

SurfaceTextures add_surface(Scene& scene, const std::string& name, const Surface& surface,
                            bool keep_coverage) {
    Texture color = blank_texture(name + "_color", surface.size_px, surface.size_px, ColorSpace::srgb);
    Texture mr =
        blank_texture(name + "_metallic_roughness", surface.size_px, surface.size_px, ColorSpace::linear);
    Texture normal = blank_texture(name + "_normal", surface.size_px, surface.size_px, ColorSpace::linear);
    for (size_t i = 0; i < surface.texels.size(); ++i) {
        const Texel& texel = surface.texels[i];
        for (int c = 0; c < 3; ++c)
            color.mips[0][i * 4 + static_cast<size_t>(c)] = to_byte(texel.color_srgb[c]);
        color.mips[0][i * 4 + 3] = to_byte(texel.alpha);
        mr.mips[0][i * 4 + 1] = to_byte(texel.roughness);
        mr.mips[0][i * 4 + 2] = to_byte(texel.metalness);
    }
    write_normals(surface, normal.mips[0]);
    build_mips(color, {TexelMeaning::srgb_color, keep_coverage ? 0.5f : -1.0f});
    build_mips(mr, {TexelMeaning::linear_data, -1});
    build_mips(normal, {TexelMeaning::normal, -1});
    SurfaceTextures result;
    result.color = push_texture(scene, std::move(color));
    result.metallic_roughness = push_texture(scene, std::move(mr));
    result.normal = push_texture(scene, std::move(normal));
    return result;
}

uint32_t add_gray_texture(Scene& scene, const std::string& name, uint32_t width_px, uint32_t height_px,
                          const std::vector<float>& values) {
    Texture texture = blank_texture(name, width_px, height_px, ColorSpace::linear);
    for (size_t i = 0; i < values.size(); ++i) {
        for (size_t c = 0; c < 3; ++c) texture.mips[0][i * 4 + c] = to_byte(values[i]);
    }
    build_mips(texture, {TexelMeaning::linear_data, -1});
    return push_texture(scene, std::move(texture));
}

uint32_t add_color_texture(Scene& scene, const std::string& name, uint32_t size_px,
                           const std::vector<glm::vec3>& srgb) {
    Texture texture = blank_texture(name, size_px, size_px, ColorSpace::srgb);
    for (size_t i = 0; i < srgb.size(); ++i) {
        for (int c = 0; c < 3; ++c) texture.mips[0][i * 4 + static_cast<size_t>(c)] = to_byte(srgb[i][c]);
    }
    build_mips(texture, {TexelMeaning::srgb_color, -1});
    return push_texture(scene, std::move(texture));
}

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

glm::vec3 rgb(uint32_t hex) {
    return glm::vec3(hex >> 16 & 255U, hex >> 8 & 255U, hex & 255U) / 255.0f;
}

}  // namespace weft::scene
