// Purpose: a reference in double precision for the light of a clear sky. The air contains gas (Rayleigh
// scattering), dust (Mie scattering) and ozone, with the constants of Bruneton 2017, "A Qualitative and
// Quantitative Evaluation of 8 Clear Sky Models". Light that is scattered once is integrated along the view
// ray. Light that is scattered more often is estimated from a table, as in Hillaire 2020, "A Scalable and
// Production Ready Sky and Atmosphere Rendering Technique".
// Units: kilometres, radians. Radiance is per sr, for a solar illuminance of 1 above the air. The three
// components are three wavelengths: 680, 550 and 440 nm.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace weft::test {

// Albedo of the ground in the table of multiple scattering and below the horizon.
inline constexpr double kSkyGroundAlbedo = 0.3;

class ReferenceSky {
 public:
    // The observer stands 2 m above the ground and sees the centre of the sun at this elevation.
    explicit ReferenceSky(double sun_elevation_rad);

    // Share of the light that is left on the way from the sun to the observer.
    [[nodiscard]] glm::dvec3 sun_transmittance() const;
    // Radiance of the sky without the sun's disc. `orders`: `first` counts only light that was
    // scattered once.
    enum class Orders { first, all };
    [[nodiscard]] glm::dvec3 radiance(double elevation_rad, double azimuth_from_sun_rad, Orders orders) const;
    // Irradiance of a horizontal plane, without the light that comes directly from the sun.
    [[nodiscard]] glm::dvec3 diffuse_irradiance(Orders orders) const;
    // Radiance of the matt ground in the light of the sun and the sky.
    [[nodiscard]] glm::dvec3 ground_radiance() const;

 private:
    struct Ray;
    [[nodiscard]] glm::dvec3 depth(double height_km, double mu) const;
    [[nodiscard]] glm::dvec3 sun_light(double height_km, double mu) const;
    [[nodiscard]] glm::dvec3 higher_orders(double height_km, double mu_sun) const;
    [[nodiscard]] Ray along(const glm::dvec3& from, const glm::dvec3& direction, int steps,
                            bool with_higher) const;
    void make_depths();
    void make_higher_orders();

    glm::dvec3 to_sun_;
    std::vector<glm::dvec3> depths_;  // Optical depth to the upper end of the air.
    // Radiance of the light of all orders from the second on, as a mean over all directions.
    std::vector<glm::dvec3> higher_orders_;
};

// The luminance of the sky with the sun at an elevation of 30°, over ground of constant luminance, read from
// a table. The azimuth of the sun is that of +x.
class SkyLuminance {
 public:
    SkyLuminance();
    [[nodiscard]] double operator()(const glm::dvec3& direction) const;

 private:
    static constexpr int kRows = 96, kColumns = 96;
    std::vector<double> table_;
    double ground_ = 0;
};

}  // namespace weft::test
