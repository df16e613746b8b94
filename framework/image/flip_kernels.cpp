#include "image/flip_kernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::image {
namespace {

constexpr double kPi = std::numbers::pi;

// One term a · exp(-b · f²) of the eye's contrast sensitivity at f cycles per degree. Its Fourier transform
// is the blur kernel a √(π/b) exp(-π² d² / b) at the distance d in degrees.
struct Term {
    double a, b;
};
// Index: channel (Y, Cx, Cz), then term. A term with a = 0 is not used.
constexpr std::array<std::array<Term, 2>, 3> kSensitivities{{
    {{{1, 0.0047}, {0, 1e-5}}},
    {{{1, 0.0053}, {0, 1e-5}}},
    {{{34.1, 0.04}, {13.5, 0.025}}},
}};
constexpr double kWidest = 0.04;  // The largest b of all terms. Its blur kernel is the widest.

// Width of the feature detectors (edges and points), in degrees of the field of view.
constexpr double kFeatureWidth = 0.082;

// Returns the radius of a kernel in pixels: three standard deviations.
int radius_of(double deviation_px) {
    return static_cast<int>(std::ceil(3 * deviation_px));
}

template <class Function>
std::vector<double> sample(int radius, const Function& function) {
    std::vector<double> taps;
    for (int x = -radius; x <= radius; ++x) taps.push_back(function(double(x)));
    return taps;
}

// Scales the positive taps so that their sum is 1, and the negative taps so that their sum is -1.
std::vector<float> normalized(const std::vector<double>& taps) {
    double positive = 0, negative = 0;
    for (const double tap : taps) (tap > 0 ? positive : negative) += std::abs(tap);
    std::vector<float> result;
    for (const double tap : taps)
        result.push_back(tap == 0 ? 0 : static_cast<float>(tap / (tap > 0 ? positive : negative)));
    return result;
}

}  // namespace

SensitivityKernels sensitivity_kernels(float pixels_per_degree) {
    const int radius = radius_of(std::sqrt(kWidest / (2 * kPi * kPi)) * pixels_per_degree);
    SensitivityKernels kernels;
    for (size_t channel = 0; channel < kernels.size(); ++channel) {
        double all = 0;
        // One value per term: the sum of the term's two-dimensional kernel over all pixels. The weight of a
        // term is its share of the sum over all terms.
        std::vector<double> volumes;
        for (const Term& term : kSensitivities[channel]) {
            if (term.a == 0) continue;
            const std::vector<double> taps = sample(radius, [&](double x_px) {
                const double degrees = x_px / pixels_per_degree;
                return std::exp(-kPi * kPi * degrees * degrees / term.b);
            });
            double sum = 0;
            for (const double tap : taps) sum += tap;
            volumes.push_back(term.a * std::sqrt(kPi / term.b) * sum * sum);
            all += volumes.back();
            kernels[channel].push_back({0, normalized(taps)});
        }
        for (size_t i = 0; i < volumes.size(); ++i)
            kernels[channel][i].weight = static_cast<float>(volumes[i] / all);
    }
    return kernels;
}

FeatureKernels feature_kernels(float pixels_per_degree) {
    const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;
    const int radius = radius_of(deviation);
    const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
    const auto first = [&](double x) { return -x * gaussian(x); };
    const auto second = [&](double x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); };
    return {normalized(sample(radius, gaussian)), normalized(sample(radius, first)),
            normalized(sample(radius, second))};
}

}  // namespace weft::image
