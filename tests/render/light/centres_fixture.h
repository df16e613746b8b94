// Purpose: test fixture that compares the light of the surroundings, as the GPU computes it, with sums over
// many directions. It compares at the middles of the 1,536 texels of a cube.
#pragma once

#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {

inline constexpr size_t kCentres = 1536;
inline constexpr std::array kCentreRoughness{0.2, 0.4, 0.6, 0.8, 1.0};

// Direction of a column of the picture `centres`, as in look_centres.comp.
inline glm::dvec3 direction_of_centre(size_t i) {
    const int face = int(i / 256), axis = face / 2;
    glm::dvec3 d;
    d[axis] = face % 2 == 0 ? 1 : -1;
    d[(axis + 1) % 3] = (double(i % 16) * 2 + 1) / 16 - 1;
    d[(axis + 2) % 3] = (double(i / 16 % 16) * 2 + 1) / 16 - 1;
    return glm::normalize(d);
}

// The light at all centres, for each roughness of kCentreRoughness.
using CentreLight = std::array<std::vector<double>, kCentreRoughness.size()>;

// The root of the mean square and the largest magnitude of the errors, in percent.
struct CentreErrors {
    double rms = 0, most = 0;
};

// The errors in percent of `scale`.
inline CentreErrors centre_errors(const std::vector<double>& found, const std::vector<double>& expected,
                                  double scale) {
    CentreErrors errors;
    for (size_t i = 0; i < expected.size(); ++i) {
        const double error = 100 * std::abs(found[i] - expected[i]) / scale;
        errors.rms += error * error / double(expected.size());
        errors.most = std::max(errors.most, error);
    }
    errors.rms = std::sqrt(errors.rms);
    return errors;
}
inline double root_mean_square(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value / double(values.size());
    return std::sqrt(sum);
}
inline double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value / double(values.size());
    return sum;
}

// How the module environment.json runs. `lod_bias` is a constant of the file.
struct FilterSettings {
    const char* lod_bias = "-0.5";
    // Values of the parameter environmentSamples. The light of each roughness comes from the run whose index
    // is in `run_of_roughness`.
    std::vector<int> samples{32};
    std::array<size_t, kCentreRoughness.size()> run_of_roughness{};
};

class CentreTest : public AmbientLight {
 protected:
    static std::vector<double> reference(const CubeSum& cube, double roughness) {
        std::vector<double> light;
        for (size_t i = 0; i < kCentres; ++i)
            light.push_back(filtered(cube, direction_of_centre(i), roughness));
        return light;
    }
    static CentreLight references(const Surroundings& light) {
        const CubeSum cube = cube_sum(light);
        CentreLight all;
        for (size_t i = 0; i < all.size(); ++i) all[i] = reference(cube, kCentreRoughness[i]);
        return all;
    }
    // Filters a picture on the GPU.
    CentreLight filter(const scene::Environment& picture, const FilterSettings& settings = {}) {
        scene::Scene scene;
        scene.environment = picture;
        const FileReader reader = [settings](const std::string& path) {
            std::optional<std::string> text = read_text(path);
            if (text && path.ends_with("modules/environment.json")) {
                replace(*text, "LodBias\": -0.5", std::string("LodBias\": ") + settings.lod_bias);
            }
            return text;
        };
        const std::unique_ptr<render::Session> session =
            start(scene, scene::Camera{}, kAmbientGraph, {16, 16, 1}, {"centres"}, 0, reader);
        CentreLight light;
        for (size_t run = 0; session && run < settings.samples.size(); ++run) {
            frame_of(*session).parameters["environmentSamples"] = settings.samples[run];
            EXPECT_TRUE(draw_frame(*session) && session->finish());
            for (const vk::ReadbackData& data : session->take_readbacks())
                if (data.pass == "observe:centres")
                    take(render::decode_texels(data.format, data.bytes), run, settings, light);
        }
        return light;
    }

 private:
    static void replace(std::string& text, const std::string& from, const std::string& to) {
        const size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
    }
    static void take(const std::vector<glm::vec4>& texels, size_t run, const FilterSettings& settings,
                     CentreLight& light) {
        ASSERT_EQ(texels.size(), kCentres * light.size());
        for (size_t i = 0; i < light.size(); ++i) {
            if (settings.run_of_roughness[i] != run) continue;
            for (size_t k = 0; k < kCentres; ++k) light[i].push_back(texels[i * kCentres + k].g);
        }
    }
};

}  // namespace weft::test
