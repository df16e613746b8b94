#include "tests/render/light/reference_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::test {
namespace {

constexpr double kPi_rad = std::numbers::pi;
constexpr double kGround_km = 6360, kTop_km = 6460, kEye_km = 0.002;
// Coefficients per kilometre.
constexpr glm::dvec3 kGasScattering(5.802e-3, 13.558e-3, 33.1e-3), kOzone(0.650e-3, 1.881e-3, 0.085e-3);
constexpr double kDustScattering = 3.996e-3, kDustExtinction = 4.44e-3;
constexpr double kDustForward = 0.8;  // g of the phase function of Cornette and Shanks.
constexpr int kDepthColumns = 256, kDepthRows = 64, kOrdersSide = 32;

struct Air {
    glm::dvec3 gas;  // Scattering.
    double dust;     // Scattering.
    glm::dvec3 extinction;
};

Air air_at(double height_km) {
    const double dust = std::exp(-height_km / 1.2);
    const double ozone = std::max(0.0, 1 - std::abs(height_km - 25) / 15);
    Air air;
    air.gas = kGasScattering * std::exp(-height_km / 8);
    air.dust = kDustScattering * dust;
    air.extinction = air.gas + glm::dvec3(kDustExtinction * dust) + kOzone * ozone;
    return air;
}

double gas_phase(double cosine) {
    return 3 * (1 + cosine * cosine) / (16 * kPi_rad);
}
double dust_phase(double cosine) {
    const double g = kDustForward;
    return 3 * (1 - g * g) * (1 + cosine * cosine) /
           (8 * kPi_rad * (2 + g * g) * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

// Square of the distance to the horizon from a height.
double horizon_squared(double height_km) {
    return height_km * (2 * kGround_km + height_km);
}
const double kMostHorizon_km = std::sqrt(horizon_squared(kTop_km - kGround_km));

// Distance from a height to the sphere of radius `sphere_km` on the far side, for a ray with the cosine `mu`
// to the vertical.
double far_distance(double height_km, double mu, double sphere_km) {
    const double r = kGround_km + height_km;
    return -r * mu + std::sqrt(std::max(r * r * (mu * mu - 1) + sphere_km * sphere_km, 0.0));
}
bool hits_ground(double height_km, double mu) {
    const double r = kGround_km + height_km;
    return mu < 0 && horizon_squared(height_km) <= r * r * mu * mu;
}
double ground_distance(double height_km, double mu) {
    const double r = kGround_km + height_km;
    return -r * mu - std::sqrt(std::max(r * r * mu * mu - horizon_squared(height_km), 0.0));
}

glm::dvec3 depth_by_steps(double height_km, double mu) {
    constexpr int kSteps = 300;
    const double step = far_distance(height_km, mu, kTop_km) / kSteps, r = kGround_km + height_km;
    glm::dvec3 sum(0);
    for (int i = 0; i < kSteps; ++i) {
        const double s = (i + 0.5) * step;
        sum += air_at(std::sqrt(r * r + s * s + 2 * r * mu * s) - kGround_km).extinction;
    }
    return sum * step;
}

// Reads a table of rows and columns. Both coordinates are from 0 to 1, which stand for the middles of the
// first and the last entry.
template <typename T>
T between(const std::vector<T>& table, int rows, int columns, double row, double column) {
    const double y = std::clamp(row, 0.0, 1.0) * (rows - 1), x = std::clamp(column, 0.0, 1.0) * (columns - 1);
    const int i = std::min(int(y), rows - 2), k = std::min(int(x), columns - 2);
    const auto at = [&](int a, int b) { return table[size_t(a) * size_t(columns) + size_t(b)]; };
    return glm::mix(glm::mix(at(i, k), at(i, k + 1), x - k), glm::mix(at(i + 1, k), at(i + 1, k + 1), x - k),
                    y - i);
}

glm::dvec3 direction_of(double elevation_rad, double azimuth_rad) {
    return {std::cos(elevation_rad) * std::cos(azimuth_rad), std::sin(elevation_rad),
            std::cos(elevation_rad) * std::sin(azimuth_rad)};
}

double height_of(const glm::dvec3& position) {
    return glm::length(position) - kGround_km;
}

}  // namespace

// Light that reaches the start of a ray. `isotropic_share` is the share of light of uniform radiance 1 that
// the air along the ray scatters to its start.
struct ReferenceSky::Ray {
    glm::dvec3 gas{0}, dust{0}, higher{0}, isotropic{0}, isotropic_share{0}, transmittance{1};
};

ReferenceSky::ReferenceSky(double sun_elevation_rad) : to_sun_(direction_of(sun_elevation_rad, 0)) {
    make_depths();
    make_higher_orders();
}

// The columns are distances to the upper end of the air, between the shortest and the longest possible one;
// the rows are distances to the horizon.
void ReferenceSky::make_depths() {
    depths_.resize(size_t{kDepthColumns} * kDepthRows);
    for (int row = 0; row < kDepthRows; ++row) {
        const double horizon = kMostHorizon_km * row / (kDepthRows - 1);
        const double height = std::sqrt(horizon * horizon + kGround_km * kGround_km) - kGround_km;
        const double r = kGround_km + height, least = kTop_km - r, most = horizon + kMostHorizon_km;
        for (int column = 0; column < kDepthColumns; ++column) {
            const double d = least + (most - least) * column / (kDepthColumns - 1);
            const double mu =
                d <= 0 ? 1 : (kMostHorizon_km * kMostHorizon_km - horizon * horizon - d * d) / (2 * r * d);
            depths_[size_t(row) * kDepthColumns + size_t(column)] =
                depth_by_steps(height, std::clamp(mu, -1.0, 1.0));
        }
    }
}

glm::dvec3 ReferenceSky::depth(double height_km, double mu) const {
    const double horizon = std::sqrt(std::max(horizon_squared(height_km), 0.0));
    const double least = kTop_km - kGround_km - height_km, most = horizon + kMostHorizon_km;
    return between(depths_, kDepthRows, kDepthColumns, horizon / kMostHorizon_km,
                   (far_distance(height_km, mu, kTop_km) - least) / (most - least));
}

glm::dvec3 ReferenceSky::sun_light(double height_km, double mu) const {
    return hits_ground(height_km, mu) ? glm::dvec3(0) : glm::exp(-depth(height_km, mu));
}

glm::dvec3 ReferenceSky::higher_orders(double height_km, double mu_sun) const {
    return between(higher_orders_, kOrdersSide, kOrdersSide, std::sqrt(height_km / (kTop_km - kGround_km)),
                   0.5 + 0.5 * std::cbrt(mu_sun));
}

ReferenceSky::Ray ReferenceSky::along(const glm::dvec3& from, const glm::dvec3& direction, int steps,
                                      bool with_higher) const {
    const double height = height_of(from), mu = glm::dot(from, direction) / glm::length(from);
    const bool ground = hits_ground(height, mu);
    const double length = ground ? ground_distance(height, mu) : far_distance(height, mu, kTop_km);
    Ray ray;
    glm::dvec3 passed(0);
    for (int i = 0; i < steps; ++i) {
        const double begin = double(i) / steps, end = (i + 1.0) / steps, middle = 0.5 * (begin + end);
        const double step = length * (end * end - begin * begin);
        const glm::dvec3 position = from + direction * (length * middle * middle);
        const double h = std::max(height_of(position), 0.0);
        const double mu_sun = glm::dot(position, to_sun_) / glm::length(position);
        const Air air = air_at(h);
        const glm::dvec3 seen = glm::exp(-(passed + air.extinction * (0.5 * step))) * step;
        const glm::dvec3 sun = seen * sun_light(h, mu_sun), scattering = air.gas + glm::dvec3(air.dust);
        ray.gas += sun * air.gas;
        ray.dust += sun * air.dust;
        ray.isotropic += sun * scattering / (4 * kPi_rad);
        ray.isotropic_share += seen * scattering;
        if (with_higher) ray.higher += seen * scattering * higher_orders(h, mu_sun);
        passed += air.extinction * step;
    }
    if (ground) {
        const glm::dvec3 hit = from + direction * length;
        const double mu_sun = glm::dot(hit, to_sun_) / glm::length(hit);
        if (mu_sun > 0)
            ray.isotropic += glm::exp(-passed) * sun_light(0, mu_sun) * (kSkyGroundAlbedo / kPi_rad * mu_sun);
    }
    return ray;
}

// Each entry is L / (1 − f): L is the mean radiance of the second order, with isotropic scattering and with
// the light of the ground; f is the share of uniform light that the air scatters once more.
void ReferenceSky::make_higher_orders() {
    // The sectors are those of one half of the sphere; the other half sees the same.
    constexpr int kRings = 24, kSectors = 5, kSteps = 24;
    const glm::dvec3 to_sun = to_sun_;
    higher_orders_.resize(size_t{kOrdersSide} * kOrdersSide);
    for (int row = 0; row < kOrdersSide; ++row) {
        const double share = double(row) / (kOrdersSide - 1);
        const glm::dvec3 from(0, kGround_km + (kTop_km - kGround_km) * share * share, 0);
        for (int column = 0; column < kOrdersSide; ++column) {
            const double root = 2.0 * column / (kOrdersSide - 1) - 1, mu_sun = root * root * root;
            to_sun_ = {std::sqrt(1 - mu_sun * mu_sun), mu_sun, 0};
            glm::dvec3 light(0), again(0);
            for (int i = 0; i < kRings * kSectors; ++i) {
                const double y = 1 - 2 * (i / kSectors + 0.5) / kRings,
                             azimuth = kPi_rad * (i % kSectors + 0.5) / kSectors;
                const Ray ray = along(from, direction_of(std::asin(y), azimuth), kSteps, false);
                light += ray.isotropic / double(kRings * kSectors);
                again += ray.isotropic_share / double(kRings * kSectors);
            }
            higher_orders_[size_t(row) * kOrdersSide + size_t(column)] = light / (1.0 - again);
        }
    }
    to_sun_ = to_sun;
}

glm::dvec3 ReferenceSky::sun_transmittance() const {
    return sun_light(kEye_km, to_sun_.y);
}

glm::dvec3 ReferenceSky::radiance(double elevation_rad, double azimuth_from_sun_rad, Orders orders) const {
    constexpr int kSteps = 60;
    const glm::dvec3 direction = direction_of(elevation_rad, azimuth_from_sun_rad);
    const double cosine = glm::dot(direction, to_sun_);
    const Ray ray = along({0, kGround_km + kEye_km, 0}, direction, kSteps, orders == Orders::all);
    return ray.gas * gas_phase(cosine) + ray.dust * dust_phase(cosine) + ray.higher;
}

glm::dvec3 ReferenceSky::diffuse_irradiance(Orders orders) const {
    constexpr int kRings = 48, kSectors = 48;
    glm::dvec3 sum(0);
    for (int i = 0; i < kRings; ++i) {
        // The rings are narrow near the horizon and have solid angles of 2π·(difference of sines).
        const double low = std::pow(double(i) / kRings, 2), high = std::pow((i + 1.0) / kRings, 2),
                     sine = 0.5 * (low + high);
        for (int k = 0; k < kSectors; ++k)
            sum += radiance(std::asin(sine), kPi_rad * (k + 0.5) / kSectors, orders) *
                   (sine * (high - low) * 2 * kPi_rad / kSectors);
    }
    return sum;
}

glm::dvec3 ReferenceSky::ground_radiance() const {
    return (sun_transmittance() * to_sun_.y + diffuse_irradiance(Orders::all)) * (kSkyGroundAlbedo / kPi_rad);
}

SkyLuminance::SkyLuminance() {
    const glm::dvec3 weights(0.2126, 0.7152, 0.0722);
    const ReferenceSky sky(kPi_rad / 6);
    table_.resize(size_t{kRows} * kColumns);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const double root = double(row) / (kRows - 1);
            table_[size_t(row) * kColumns + size_t(column)] =
                glm::dot(weights, sky.radiance(0.5 * kPi_rad * root * root, kPi_rad * column / (kColumns - 1),
                                               ReferenceSky::Orders::all));
        }
    ground_ = glm::dot(weights, sky.ground_radiance());
}

double SkyLuminance::operator()(const glm::dvec3& direction) const {
    if (direction.y < 0) return ground_;
    const double elevation = std::asin(std::min(direction.y, 1.0)),
                 azimuth = std::abs(std::atan2(direction.z, direction.x));
    return between(table_, kRows, kColumns, std::sqrt(elevation / (0.5 * kPi_rad)), azimuth / kPi_rad);
}

}  // namespace weft::test
