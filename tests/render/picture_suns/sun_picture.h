// Purpose: pictures of the surroundings with suns of known direction, size and light, and a fixture that
// opens them as the program does for --env. Orientation of a picture: see weft/scene/environment.h.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_brdf.h"
#include "viewer/commands/scene_source.h"

namespace weft::test {

// Parameters of the graphs: only single reflections at microfacets, as in the BRDFs of papers. No test looks
// at the filtered mips of the surroundings, so they take one sample.
inline const render::ParameterValues kSunParameters{{"multipleScattering", 0}, {"environmentSamples", 1}};

// A disc of uniform radiance in a picture.
struct DrawnSun {
    glm::dvec3 to_sun{0, 1, 0};
    double radius_rad = 0;
    glm::dvec3 radiance{0};
    // Returns the illuminance on a plane that faces the sun.
    [[nodiscard]] glm::dvec3 illuminance_lx() const {
        return radiance * (kPi * std::sin(radius_rad) * std::sin(radius_rad));
    }
};

using Sky = std::function<glm::dvec3(const glm::dvec3&)>;

// Returns a direction. Azimuth 0 is the middle column of a picture, 180 its left and right edge.
inline glm::dvec3 towards(double azimuth_deg, double height_deg) {
    const double a = glm::radians(azimuth_deg), h = glm::radians(height_deg);
    return {std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)};
}

// A Radiance picture with twice as many columns as rows.
class SunPicture {
 public:
    SunPicture(uint32_t height_px, const Sky& sky, std::span<const DrawnSun> suns) : height_(height_px) {
        for (uint32_t y = 0; y < height_; ++y)
            for (uint32_t x = 0; x < 2 * height_; ++x) add_texel(mean_of(x, y, sky, suns));
    }

    // The bytes of the file.
    [[nodiscard]] std::string file() const {
        return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height_) + " +X " +
               std::to_string(2 * height_) + "\n" + bytes_;
    }
    // The radiance of each texel as the file stores it.
    [[nodiscard]] const std::vector<glm::dvec3>& texels() const { return texels_; }
    [[nodiscard]] uint32_t height() const { return height_; }

    // Returns the irradiance of all texels on a plane with the normal n.
    [[nodiscard]] glm::dvec3 irradiance(const glm::dvec3& n) const {
        constexpr int kParts = 2;
        glm::dvec3 sum(0);
        for (uint32_t y = 0; y < height_; ++y)
            for (int j = 0; j < kParts; ++j) {
                const double top = y + double(j) / kParts, bottom = y + double(j + 1) / kParts;
                const double angle = (std::cos(kPi * top / height_) - std::cos(kPi * bottom / height_)) *
                                     kPi / height_ / kParts;
                for (uint32_t x = 0; x < 2 * height_ * kParts; ++x) {
                    const glm::dvec3 d = direction((x + 0.5) / kParts, (top + bottom) / 2);
                    sum += texels_[size_t{y} * 2 * height_ + x / kParts] *
                           (angle * std::max(0.0, glm::dot(n, d)));
                }
            }
        return sum;
    }

 private:
    [[nodiscard]] glm::dvec3 direction(double x, double y) const {
        const double azimuth = (x / height_ - 1) * kPi, polar = y / height_ * kPi;
        return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
    }
    // Returns the mean radiance over the solid angle of a texel.
    [[nodiscard]] glm::dvec3 mean_of(uint32_t x, uint32_t y, const Sky& sky,
                                     std::span<const DrawnSun> suns) const {
        constexpr int kSide = 32;
        const glm::dvec3 middle = direction(x + 0.5, y + 0.5);
        glm::dvec3 mean = sky(middle);
        for (const DrawnSun& sun : suns) {
            if (glm::dot(middle, sun.to_sun) < std::cos(sun.radius_rad + 2 * kPi / height_)) continue;
            double inside = 0, all = 0;
            for (int i = 0; i < kSide * kSide; ++i) {
                const double row = y + (i / kSide + 0.5) / kSide, weight = std::sin(row / height_ * kPi);
                const glm::dvec3 d = direction(x + (i % kSide + 0.5) / kSide, row);
                inside += glm::dot(d, sun.to_sun) > std::cos(sun.radius_rad) ? weight : 0;
                all += weight;
            }
            mean += (sun.radiance - sky(middle)) * (inside / all);
        }
        return mean;
    }
    // Stores a texel as three mantissas and a shared exponent.
    void add_texel(const glm::dvec3& radiance) {
        int exponent = 0;
        (void)std::frexp(std::max({radiance.r, radiance.g, radiance.b, 1e-30}) * 256.0 / 255.5, &exponent);
        glm::dvec3 stored(0);
        for (int c = 0; c < 3; ++c) {
            const double mantissa = std::min(255.0, std::round(std::ldexp(radiance[c], 8 - exponent)));
            bytes_ += static_cast<char>(static_cast<uint8_t>(mantissa));
            stored[c] = std::ldexp(mantissa, exponent - 8);
        }
        bytes_ += static_cast<char>(static_cast<uint8_t>(exponent + 128));
        texels_.push_back(stored);
    }

    uint32_t height_;
    std::string bytes_;
    std::vector<glm::dvec3> texels_;
};

// Opens pictures in the way of the program: it writes a file, loads it, and adds lights for its suns to the
// scene.
class PictureSuns : public SessionTest {
 protected:
    // Returns a scene that has no objects, the surroundings of the picture, and the lights of its suns.
    scene::Scene surrounded_by(const SunPicture& picture) {
        const std::filesystem::path file =
            std::filesystem::path(testing::TempDir()) / ("weft_suns_" + std::to_string(::getpid()) + ".hdr");
        std::ofstream(file, std::ios::binary) << picture.file();
        Result<scene::Scene> opened =
            viewer::open_scene({.name = "builtin:spheres", .env = file.string()}, SceneLimits{}, warnings_);
        std::filesystem::remove(file);
        scene::Scene scene;
        if (!opened) {
            ADD_FAILURE() << to_text(opened.errors());
            return scene;
        }
        scene.environment = std::move(opened->environment);
        for (scene::Light& light : opened->lights)
            if (light.name.starts_with(scene.environment.name + " sun"))
                scene.lights.push_back(std::move(light));
        return scene;
    }
};

}  // namespace weft::test
