#include "tests/image/flip_direct.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace weft::image::test {
namespace {

const double kPi = std::acos(-1.0);
using Matrix = std::array<Rgb, 3>;  // A 3 × 3 matrix; each element of the array is a row.

Rgb times(const Matrix& m, const Rgb& v) {
    Rgb result{};
    for (size_t row = 0; row < 3; ++row)
        for (size_t column = 0; column < 3; ++column) result[row] += m[row][column] * v[column];
    return result;
}

// Returns the inverse of the matrix, computed with cofactors.
Matrix inverse(const Matrix& m) {
    Matrix result;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            const size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            result[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    double determinant = 0;
    for (size_t j = 0; j < 3; ++j) determinant += m[0][j] * result[j][0];
    for (Rgb& row : result)
        for (double& value : row) value /= determinant;
    return result;
}

// Returns the matrix from linear sRGB to XYZ, computed from the chromaticities of the primaries. The
// primaries are scaled so that their sum is the white point.
Matrix rgb_to_xyz() {
    const std::array<std::array<double, 2>, 3> primaries{{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
    Matrix unscaled;
    for (size_t i = 0; i < 3; ++i) {
        const auto [x, y] = primaries[i];
        unscaled[0][i] = x / y;
        unscaled[1][i] = 1;
        unscaled[2][i] = (1 - x - y) / y;
    }
    const Rgb white{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
    const Rgb scale = times(inverse(unscaled), white);
    for (Rgb& row : unscaled)
        for (size_t i = 0; i < 3; ++i) row[i] *= scale[i];
    return unscaled;
}

const Matrix kToXyz = rgb_to_xyz();
const Matrix kToRgb = inverse(kToXyz);
const Rgb kWhite = times(kToXyz, {1, 1, 1});

double linear_of(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Rgb ycxcz_of(const Rgb& display) {
    Rgb xyz = times(kToXyz, {linear_of(display[0]), linear_of(display[1]), linear_of(display[2])});
    for (size_t i = 0; i < 3; ++i) xyz[i] /= kWhite[i];
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Rgb hunt_lab_of(const Rgb& linear) {
    Rgb f = times(kToXyz, linear);
    for (size_t i = 0; i < 3; ++i) {
        const double t = f[i] / kWhite[i];
        f[i] = t > 216.0 / 24389 ? std::pow(t, 1.0 / 3) : (24389.0 / 27 * t + 16) / 116;
    }
    const double lightness = 116 * f[1] - 16;
    return {lightness, 0.01 * lightness * 500 * (f[0] - f[1]), 0.01 * lightness * 200 * (f[1] - f[2])};
}

Rgb hunt_lab_of_ycxcz(const Rgb& ycxcz) {
    const double y = (ycxcz[0] + 16) / 116;
    Rgb rgb =
        times(kToRgb, {(ycxcz[1] / 500 + y) * kWhite[0], y * kWhite[1], (y - ycxcz[2] / 200) * kWhite[2]});
    for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
    return hunt_lab_of(rgb);
}

double hyab(const Rgb& a, const Rgb& b) {
    return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

double redistributed(double distance) {
    const double most = std::pow(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), 0.7);
    const double x = std::pow(distance, 0.7);
    if (x < 0.4 * most) return 0.95 * x / (0.4 * most);
    return 0.95 + 0.05 * (x - 0.4 * most) / (most - 0.4 * most);
}

// A filter: the weights weight(dx, dy) over a square of texels. They are normalised so that the sum of the
// positive weights is 1 and the sum of the negative weights is −1 (or 0 if there are none).
struct Square {
    int radius = 0;
    std::vector<double> weights;

    Square(int r, const std::function<double(double, double)>& weight) : radius(r) {
        double positive = 0, negative = 0;
        for (int dy = -r; dy <= r; ++dy)
            for (int dx = -r; dx <= r; ++dx) {
                const double w = weight(dx, dy);
                weights.push_back(w);
                if (w > 0) positive += w;
                if (w < 0) negative -= w;
            }
        for (double& w : weights) w /= w > 0 ? positive : negative > 0 ? negative : 1;
    }

    // Returns the filtered value at texel (x, y). value(i) returns the unfiltered value of the texel with
    // index i. Coordinates outside the picture are clamped to its border.
    [[nodiscard]] double at(const DirectImage& size, int x, int y,
                            const std::function<double(size_t)>& value) const {
        double sum = 0;
        size_t i = 0;
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx) {
                const int from_x = std::clamp(x + dx, 0, size.width_px - 1);
                const int from_y = std::clamp(y + dy, 0, size.height_px - 1);
                sum += weights[i++] * value(static_cast<size_t>(from_y * size.width_px + from_x));
            }
        return sum;
    }
};

struct Filters {
    std::vector<Square> blur;  // Blur filters of the channels Y, Cx and Cz, in this order.
    // Feature filters in this order: edge along x, edge along y, point along x, point along y.
    std::vector<Square> detect;
};

Filters filters(double ppd) {
    Filters result;
    const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
    const auto term = [&](double a, double b, double dx, double dy) {
        return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * (dx * dx + dy * dy) / (ppd * ppd) / b);
    };
    result.blur.emplace_back(r, [&](double x, double y) { return term(1, 0.0047, x, y); });
    result.blur.emplace_back(r, [&](double x, double y) { return term(1, 0.0053, x, y); });
    result.blur.emplace_back(
        r, [&](double x, double y) { return term(34.1, 0.04, x, y) + term(13.5, 0.025, x, y); });
    const double s = 0.5 * 0.082 * ppd;
    const int f = static_cast<int>(std::ceil(3 * s));
    const auto g = [&](double x, double y) { return std::exp(-(x * x + y * y) / (2 * s * s)); };
    result.detect.emplace_back(f, [&](double x, double y) { return -x * g(x, y); });
    result.detect.emplace_back(f, [&](double x, double y) { return -y * g(x, y); });
    result.detect.emplace_back(f, [&](double x, double y) { return (x * x / (s * s) - 1) * g(x, y); });
    result.detect.emplace_back(f, [&](double x, double y) { return (y * y / (s * s) - 1) * g(x, y); });
    return result;
}

struct Seen {
    Rgb lab{};
    double edge = 0, point = 0;
};

Seen seen_at(const DirectImage& image, const std::vector<Rgb>& ycxcz, const Filters& f, int x, int y) {
    Rgb blurred;
    for (size_t c = 0; c < 3; ++c)
        blurred[c] = f.blur[c].at(image, x, y, [&](size_t i) { return ycxcz[i][c]; });
    std::array<double, 4> found;
    for (size_t d = 0; d < 4; ++d)
        found[d] = f.detect[d].at(image, x, y, [&](size_t i) { return (ycxcz[i][0] + 16) / 116; });
    return {hunt_lab_of_ycxcz(blurred), std::hypot(found[0], found[1]), std::hypot(found[2], found[3])};
}

std::vector<Rgb> all_ycxcz(const DirectImage& image) {
    std::vector<Rgb> result;
    for (const Rgb& texel : image.texels) result.push_back(ycxcz_of(texel));
    return result;
}

}  // namespace

std::vector<double> flip_direct(const DirectImage& reference, const DirectImage& test,
                                double pixels_per_degree) {
    const Filters f = filters(pixels_per_degree);
    const std::vector<Rgb> a = all_ycxcz(reference), b = all_ycxcz(test);
    std::vector<double> map;
    for (int y = 0; y < reference.height_px; ++y)
        for (int x = 0; x < reference.width_px; ++x) {
            const Seen p = seen_at(reference, a, f, x, y), q = seen_at(test, b, f, x, y);
            const double feature = std::max(std::abs(p.edge - q.edge), std::abs(p.point - q.point));
            map.push_back(
                std::pow(redistributed(hyab(p.lab, q.lab)), 1 - std::pow(feature / std::sqrt(2.0), 0.5)));
        }
    return map;
}

double flip_of_constants(const Rgb& reference, const Rgb& test) {
    return redistributed(hyab(hunt_lab_of_ycxcz(ycxcz_of(reference)), hunt_lab_of_ycxcz(ycxcz_of(test))));
}

}  // namespace weft::image::test
