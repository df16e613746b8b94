#include "weft/image/flip.h"

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

constexpr float kColorExponent = 0.7f;  // Exponent of colour differences: q_c in the paper that flip.h cites.
// Exponent of feature differences: q_f in the paper that flip.h cites.
constexpr float kFeatureExponent = 0.5f;
// The curve from colour difference to error has two straight parts that meet at the knee. The knee lies at
// kColorKnee (p_c in the paper) times the largest possible difference, and has the error kErrorAtKnee (p_t in
// the paper). The largest possible difference has the error 1.
constexpr float kColorKnee = 0.4f;
constexpr float kErrorAtKnee = 0.95f;

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

// Returns the colours of the picture as the eye perceives them at the given resolution: blurred, then
// converted to L*a*b* with Hunt's correction.
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

// Returns for each texel the strength of a feature (edge or point): the length of a vector (x, y). Its
// component x is the luminance, filtered with `kernel` along x and with `smooth` along y. Its component y is
// the luminance, filtered with `smooth` along x and with `kernel` along y.
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
    const float knee = kColorKnee * largest;
    if (difference < knee) return kErrorAtKnee / knee * difference;
    return kErrorAtKnee + (difference - knee) / (largest - knee) * (1 - kErrorAtKnee);
}

struct Kernels {
    SensitivityKernels sensitivity;
    FeatureKernels detectors;

    explicit Kernels(float pixels_per_degree)
        : sensitivity(sensitivity_kernels(pixels_per_degree)),
          detectors(feature_kernels(pixels_per_degree)) {}

    // Returns the radius of the neighbourhood that affects the result of a texel.
    [[nodiscard]] uint32_t radius_px() const {
        size_t taps = std::max({detectors.edge.size(), detectors.point.size(), detectors.smooth.size()});
        for (const std::vector<WeightedGaussian>& sums : sensitivity)
            for (const WeightedGaussian& gaussian : sums) taps = std::max(taps, gaussian.taps.size());
        return static_cast<uint32_t>(taps / 2);
    }
};

// Returns the rows [first, end) of a picture as display values.
Image rows_of(const Image& picture, uint32_t first, uint32_t end) {
    const auto at = [&](uint32_t row) {
        return picture.texels.begin() + static_cast<std::ptrdiff_t>(size_t{row} * picture.width_px);
    };
    return to_display({picture.width_px, end - first, picture.encoding, {at(first), at(end)}});
}

// The intermediate results of FLIP for one picture: colours as the eye perceives them, and detected edges and
// points.
struct Seen {
    std::vector<glm::vec3> lab;
    Features found;

    Seen(const Image& display, const Kernels& kernels) {
        Planes planes = opponent_planes(display);
        lab = perceived(planes, kernels.sensitivity);
        found = features(std::move(planes[0]), kernels.detectors);
    }
};

Plane flip_of_rows(const Image& reference, const Image& test, const Kernels& kernels) {
    const Seen a(reference, kernels), b(test, kernels);
    const float largest =
        std::pow(hyab_distance(linear_to_hunt_lab({0, 1, 0}), linear_to_hunt_lab({0, 0, 1})), kColorExponent);
    Plane map{reference.width_px, reference.height_px, std::vector<float>(a.lab.size())};
    for (size_t i = 0; i < a.lab.size(); ++i) {
        const float feature = std::max(std::abs(a.found.edges[i] - b.found.edges[i]),
                                       std::abs(a.found.points[i] - b.found.points[i]));
        const float feature_error =
            std::pow(std::min(feature / std::numbers::sqrt2_v<float>, 1.0f), kFeatureExponent);
        const float color = std::min(color_error(a.lab[i], b.lab[i], largest), 1.0f);
        map.values[i] = std::pow(color, 1 - feature_error);
    }
    return map;
}

// The picture is processed in bands of rows with about this many texels, which limits the memory of temporary
// data.
constexpr uint64_t kBandTexels = 1 << 19;
// Temporary memory per texel of a band: two pictures, three planes for each picture, and data of the filters.
constexpr uint64_t kBytesPerBandTexel = 128;

uint32_t band_rows(uint32_t width_px, uint32_t radius_px) {
    return static_cast<uint32_t>(std::max<uint64_t>({kBandTexels / width_px, 2 * radius_px, 1}));
}

}  // namespace

uint64_t flip_band_bytes(uint32_t width_px, uint32_t height_px, float pixels_per_degree) {
    const uint32_t radius_px = Kernels(pixels_per_degree).radius_px();
    const uint64_t rows = std::min<uint64_t>(height_px, band_rows(width_px, radius_px) + 2 * radius_px);
    return rows * width_px * kBytesPerBandTexel;
}

// Computes the map band by band. The filters of a band also need rows above and below the band: as many as
// the radius of the kernels. With these rows, the result is the same as for the whole picture at once.
Plane flip_map(const Image& reference, const Image& test, float pixels_per_degree) {
    assert(same_size(reference, test) && !reference.texels.empty());
    const Kernels kernels(pixels_per_degree);
    const uint32_t radius_px = kernels.radius_px(), height_px = reference.height_px;
    const uint32_t rows = band_rows(reference.width_px, radius_px);
    Plane map{reference.width_px, height_px, {}};
    map.values.reserve(reference.texels.size());
    for (uint32_t first = 0; first < height_px; first += rows) {
        const uint32_t end = std::min(first + rows, height_px);
        const uint32_t above = std::min(first, radius_px), below = std::min(height_px - end, radius_px);
        const Plane band = flip_of_rows(rows_of(reference, first - above, end + below),
                                        rows_of(test, first - above, end + below), kernels);
        const float* own = band.values.data() + size_t{above} * map.width_px;
        map.values.insert(map.values.end(), own, own + size_t{end - first} * map.width_px);
    }
    return map;
}

}  // namespace weft::image
