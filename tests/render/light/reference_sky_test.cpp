// Tests the reference for the sky against radiances and irradiances that other programs computed: the light
// of the first order by quadrature with 20,000 points, and the light of all orders by tracing paths.
#include "tests/render/light/reference_sky.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace weft::test {
namespace {

using Orders = ReferenceSky::Orders;

// Radiances in 10⁻³ / sr. `table_error` is the error, in percent, that the table of multiple scattering
// causes in the light of all orders.
struct SkyRow {
    double elevation_deg, azimuth_deg;
    glm::dvec3 first, all, table_error;
};
struct SkyHour {
    double sun_deg;
    glm::dvec3 transmittance, first_diffuse, all_diffuse, table_error;
    std::array<SkyRow, 4> rows;
};

const std::array kHours{
    SkyHour{60,
            {.93151, .84888, .73112},
            {24.11, 44.38, 82.02},
            {36.42, 73.39, 158.6},
            {1.8, -0.5, -3.4},
            {SkyRow{90, 0, {5.526, 10.61, 21.43}, {7.605, 15.76, 36.30}, {2.4, 0.7, -1.3}},
             SkyRow{45, 180, {3.940, 8.224, 16.87}, {6.883, 15.48, 37.38}, {3.2, 0.1, -3.2}},
             SkyRow{15, 45, {12.58, 24.08, 41.53}, {20.47, 42.15, 85.61}, {0.7, -1.8, -5.1}},
             SkyRow{2, 0, {40.72, 55.27, 55.61}, {71.10, 104.5, 128.2}, {-1.7, -3.4, -7.1}}}},
    SkyHour{30,
            {.88482, .75391, .58237},
            {22.80, 40.09, 69.70},
            {30.78, 59.65, 124.7},
            {0.2, -2.1, -5.6},
            {SkyRow{90, 0, {3.264, 6.576, 13.29}, {4.572, 9.944, 23.73}, {2.2, 0, -2.8}},
             SkyRow{45, 0, {13.32, 19.38, 31.60}, {15.27, 24.37, 46.73}, {0.1, -1.4, -4.3}},
             SkyRow{15, 0, {34.49, 46.79, 64.08}, {39.91, 59.53, 96.85}, {-1.0, -2.8, -6.2}},
             SkyRow{2, 90, {29.35, 38.38, 35.25}, {48.57, 70.64, 84.53}, {-2.6, -5.1, -10.6}}}},
    SkyHour{10,
            {.71303, .45949, .22172},
            {19.24, 29.08, 42.73},
            {23.19, 38.71, 70.59},
            {-1.7, -3.7, -7.2},
            {SkyRow{90, 0, {2.356, 4.094, 7.176}, {2.962, 5.673, 12.36}, {0.6, -1.1, -3.9}},
             SkyRow{45, 45, {4.543, 7.634, 12.75}, {5.471, 10.03, 20.32}, {-1.0, -3.0, -6.3}},
             SkyRow{15, 180, {14.37, 22.67, 30.65}, {17.07, 28.99, 47.08}, {-3.0, -5.0, -8.8}},
             SkyRow{2, 0, {233.1, 157.3, 70.50}, {246.8, 176.5, 95.81}, {-2.2, -3.6, -8.9}}}}};

// Returns the largest relative error of the three components.
double relative_error(const glm::dvec3& found, const glm::dvec3& expected) {
    const glm::dvec3 error = glm::abs(found / expected - 1.0);
    return std::max({error.x, error.y, error.z});
}

TEST(ReferenceSkyLight, HasTheRadiancesOfPathTracing) {
    double first_worst = 0, all_worst = 0;
    for (const SkyHour& hour : kHours) {
        const ReferenceSky sky(hour.sun_deg * std::numbers::pi / 180);
        EXPECT_LT(relative_error(sky.sun_transmittance(), hour.transmittance), 2e-3) << hour.sun_deg;
        for (const SkyRow& row : hour.rows) {
            const auto found = [&](Orders orders) {
                return 1e3 * sky.radiance(row.elevation_deg * std::numbers::pi / 180,
                                          row.azimuth_deg * std::numbers::pi / 180, orders);
            };
            const double first = relative_error(found(Orders::first), row.first),
                         all = relative_error(found(Orders::all), row.all * (1.0 + row.table_error / 100.0));
            first_worst = std::max(first_worst, first);
            all_worst = std::max(all_worst, all);
            EXPECT_LT(first, 0.005) << hour.sun_deg << ": " << row.elevation_deg << ", " << row.azimuth_deg;
            EXPECT_LT(all, 0.006) << hour.sun_deg << ": " << row.elevation_deg << ", " << row.azimuth_deg;
        }
        EXPECT_LT(relative_error(1e3 * sky.diffuse_irradiance(Orders::first), hour.first_diffuse), 0.005);
        EXPECT_LT(relative_error(1e3 * sky.diffuse_irradiance(Orders::all),
                                 hour.all_diffuse * (1.0 + hour.table_error / 100.0)),
                  0.006);
    }
    std::printf("largest errors: first order %.2f %%, all orders %.2f %%\n", first_worst * 100,
                all_worst * 100);
}

}  // namespace
}  // namespace weft::test
