// Purpose: test fixture for the light of the surroundings. It runs a graph that evaluates the functions of
// ambient.glsl and dfg.glsl on the GPU.
#pragma once

#include <cstring>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_ambient.h"

namespace weft::test {

inline constexpr const char* kAmbientGraph = WEFT_SOURCE_DIR "/tests/render/ambient/ambient.json";
inline constexpr size_t kDirections = 384;

// Direction of a column of the picture `mirrored`.
inline glm::dvec3 spiral(size_t i) {
    const double y = 1 - (2.0 * double(i) + 1) / kDirections, azimuth = 2.39996323 * double(i),
                 across = std::sqrt(1 - y * y);
    return {across * std::cos(azimuth), y, across * std::sin(azimuth)};
}

// Returns a picture of the surroundings. Each texel is the mean of 3 × 3 samples.
inline scene::Environment picture_of(const Surroundings& light, uint32_t width = 512) {
    const uint32_t height = width / 2;
    std::vector<glm::vec3> texels;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            double sum = 0;
            for (int i = 0; i < 9; ++i) {
                const double polar = kPi * (y + (i / 3 + 0.5) / 3) / height,
                             azimuth = 2 * kPi * ((x + (i % 3 + 0.5) / 3) / width - 0.5);
                sum += light({std::sin(polar) * std::sin(azimuth), std::cos(polar),
                              -std::sin(polar) * std::cos(azimuth)}) /
                       9;
            }
            texels.push_back(glm::vec3(float(sum)));
        }
    return scene::build_environment(width, height, texels);
}

// A smooth sky: bright towards the sun and the horizon, over a ground of constant radiance.
inline double smooth_sky(const glm::dvec3& d) {
    if (d.y < 0) return 1;
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.6, 0.58, -0.5));
    return 1.5 + 2.5 * std::exp(-4 * d.y) + 6 * std::exp(-6 * (1 - glm::dot(d, sun)));
}
inline double half_sky(const glm::dvec3& d) {
    return glm::dot(d, glm::dvec3(1, 2, 3)) > 0 ? 1 : 0;
}
inline double spot_sky(const glm::dvec3& d) {
    const double cosine = glm::dot(d, glm::normalize(glm::dvec3(1, 2, 3)));
    return cosine > std::cos(2.5 * kPi / 180) ? 1000 : 1;
}

class AmbientLight : public SessionTest {
 protected:
    // Runs the graph once. Keys of the result: the observed resources, and "sh".
    std::map<std::string, std::vector<glm::vec4>> run(const scene::Scene& scene,
                                                      std::vector<std::string> observed = {"mirrored",
                                                                                           "diffuse"}) {
        const std::unique_ptr<render::Session> session =
            start(scene, scene::Camera{}, kAmbientGraph, {16, 16, 1}, std::move(observed));
        std::map<std::string, std::vector<glm::vec4>> found;
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "the graph cannot run";
            return found;
        }
        for (const vk::ReadbackData& data : session->take_readbacks()) {
            if (data.pass == "keepSh") {
                found["sh"].resize(data.bytes.size() / sizeof(glm::vec4));
                std::memcpy(found["sh"].data(), data.bytes.data(), data.bytes.size());
            } else {
                found[data.pass.substr(std::string("observe:").size())] =
                    render::decode_texels(data.format, data.bytes);
            }
        }
        return found;
    }
    std::map<std::string, std::vector<glm::vec4>> run(const Surroundings& light,
                                                      std::vector<std::string> observed = {"mirrored",
                                                                                           "diffuse"}) {
        scene::Scene scene;
        scene.environment = picture_of(light);
        return run(scene, std::move(observed));
    }
};

}  // namespace weft::test
