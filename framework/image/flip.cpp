#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "image/flip_kernels.h"
#include "image/opponent_color.h"
#include "image/separable_filter.h"

namespace weft::image {
namespace {

constexpr float kColorExponent = 0.7f;    // q_c
constexpr float kFeatureExponent = 0.5f;  // q_f
// Differences up to kKnee (p_c) of the largest possible one take up kKneeError (p_t) of the range.
constexpr float kKnee = 0.4f;
constexpr float kKneeError = 0.95f;

using Planes = std::array<Plane, 3>;

Planes opponent_planes(const Image& display) {
    Planes planes;
    for (Plane& plane : planes)
        plane = {display.width_px, display.height_px, std::vector<float>(display.texels.size())};
    for (size_t i = 0; i < display.texels.size(); ++i) {
        const glm::vec3& texel = display.texels[i];
        const glm::vec3 ycxcz =
            linear_to_ycxcz({decode_srgb(texel.r), decode_srgb(texel.g), decode_srgb(texel.b)});
        for (int c = 0; c < 3; ++c) planes[static_cast<size_t>(c)].values[i] = ycxcz[c];
    }
    return planes;
}

Plane blurred(const Plane& plane, const std::vector<WeightedGaussian>& kernels) {
    Plane result{plane.width_px, plane.height_px, std::vector<float>(plane.values.size())};
    for (const WeightedGaussian& kernel : kernels) {
        const Plane part = filter_columns(filter_rows(plane, kernel.taps), kernel.taps);
        for (size_t i = 0; i < part.values.size(); ++i) result.values[i] += kernel.weight * part.values[i];
    }
    return result;
}

// What the eye makes of a picture at that distance.
std::vector<glm::vec3> perceived(const Planes& ycxcz, const SensitivityKernels& kernels) {
    const Planes blur{blurred(ycxcz[0], kernels[0]), blurred(ycxcz[1], kernels[1]),
                      blurred(ycxcz[2], kernels[2])};
    std::vector<glm::vec3> lab(blur[0].values.size());
    for (size_t i = 0; i < lab.size(); ++i) {
        const glm::vec3 rgb = ycxcz_to_linear({blur[0].values[i], blur[1].values[i], blur[2].values[i]});
        lab[i] = linear_to_hunt_lab(glm::clamp(rgb, 0.0f, 1.0f));
    }
    return lab;
}

// The length of a gradient whose parts are `kernel` along x and along y.
std::vector<float> strength(const Plane& luminance, const std::vector<float>& kernel,
                            const std::vector<float>& smooth) {
    const Plane x = filter_columns(filter_rows(luminance, kernel), smooth);
    const Plane y = filter_columns(filter_rows(luminance, smooth), kernel);
    std::vector<float> lengths(x.values.size());
    for (size_t i = 0; i < lengths.size(); ++i) lengths[i] = std::hypot(x.values[i], y.values[i]);
    return lengths;
}

struct Features {
    std::vector<float> edges, points;
};

Features features(Plane luminance, const FeatureKernels& kernels) {
    for (float& y : luminance.values) y = (y + 16) / 116;
    return {strength(luminance, kernels.edge, kernels.smooth),
            strength(luminance, kernels.point, kernels.smooth)};
}

float color_error(glm::vec3 a, glm::vec3 b, float largest) {
    const float difference = std::pow(hyab_distance(a, b), kColorExponent);
    const float knee = kKnee * largest;
    if (difference < knee) return kKneeError / knee * difference;
    return kKneeError + (difference - knee) / (largest - knee) * (1 - kKneeError);
}

}  // namespace

Plane flip_map(const Image& reference, const Image& test, float pixels_per_degree) {
    assert(same_size(reference, test) && !reference.texels.empty());
    const SensitivityKernels sensitivity = sensitivity_kernels(pixels_per_degree);
    const FeatureKernels detectors = feature_kernels(pixels_per_degree);
    const Planes planes_a = opponent_planes(to_display(reference));
    const Planes planes_b = opponent_planes(to_display(test));
    const std::vector<glm::vec3> lab_a = perceived(planes_a, sensitivity);
    const std::vector<glm::vec3> lab_b = perceived(planes_b, sensitivity);
    const Features features_a = features(planes_a[0], detectors);
    const Features features_b = features(planes_b[0], detectors);

    const float largest =
        std::pow(hyab_distance(linear_to_hunt_lab({0, 1, 0}), linear_to_hunt_lab({0, 0, 1})), kColorExponent);
    Plane map{reference.width_px, reference.height_px, std::vector<float>(lab_a.size())};
    for (size_t i = 0; i < lab_a.size(); ++i) {
        const float feature = std::max(std::abs(features_a.edges[i] - features_b.edges[i]),
                                       std::abs(features_a.points[i] - features_b.points[i]));
        const float feature_error =
            std::pow(std::min(feature / std::numbers::sqrt2_v<float>, 1.0f), kFeatureExponent);
        const float color = std::min(color_error(lab_a[i], lab_b[i], largest), 1.0f);
        map.values[i] = std::pow(color, 1 - feature_error);
    }
    return map;
}

}  // namespace weft::image
