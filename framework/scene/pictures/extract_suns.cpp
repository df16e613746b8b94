#include "scene/pictures/extract_suns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace weft::scene {
namespace {

// A texel belongs to a region if it is brighter than this number times the median of the picture.
constexpr double kMedians = 30;
// The light of a sun is at least this share of the light of the picture.
constexpr double kLeastShare = 0.02;
constexpr double kMostRadius_rad = 10 * std::numbers::pi / 180;
// A region with at most this radius may have any shape that is not elongated, because highlights of this size
// do not show the shape. Larger regions must look like a uniform disc.
constexpr double kSmallRadius_rad = 2 * std::numbers::pi / 180;
constexpr double kMostTexels = 2.5;  // The same limit in texels: a shape of so few texels is not visible.
// A region looks like a disc if misplaced_share() is at most this value.
constexpr double kMostMisplaced = 0.08;
// Largest value of (radius of the spread of the light)² / (radius of a disc with the solid angle of the
// region)². The quotient of a disc is 1. The quotient of a rectangle is 0.52 · (k + 1 / k), where k is the
// ratio of its sides.
constexpr double kMostElongation = 2;

double luminance_of(const glm::vec3& texel) {
    return glm::dot(glm::dvec3(texel), glm::dvec3(0.2126, 0.7152, 0.0722));
}

// Integrals over a texel of one row. They are exact, so that the sums over the texels of a region are exact,
// too.
struct RowShape {
    double solid_angle = 0;  // Solid angle of one texel.
    double across = 0;  // ∫ sin² θ over the row's polar angles θ, times 2 sin(half the texel's azimuth).
    double up = 0;      // ∫ cos θ over the solid angle of a texel; cos θ is the y of a direction.
    double sides2 = 0;  // width² + height² of a texel, in rad².
};

// The sums over the light that comes from a set of texels.
struct RegionLight {
    double solid_angle = 0;
    double flux = 0;                           // ∫ luminance.
    glm::dvec3 flow{0};                        // ∫ luminance × direction.
    std::array<glm::dvec3, 3> channel_flow{};  // ∫ radiance × direction for each channel.
    double sides2 = 0;                         // ∫ luminance × RowShape::sides2.
    [[nodiscard]] double spread_rad() const {
        // The mean direction of a uniform disc with the radius a has the length cos²(a / 2). So 1 minus this
        // length is sin²(a / 2), and the radius follows from it.
        const double missing = std::clamp(1 - glm::length(flow) / flux, 0.0, 1.0);
        return 2 * std::asin(std::sqrt(missing));
    }
    // Returns the radius that the disc had before the picture was divided into texels. The variance of a disc
    // is half of the square of its radius. Texels add (width² + height²) / 12 to the variance twice: a texel
    // is a mean over its area, and spread_rad() counts it as light from its whole area. In sources that are
    // hardly larger than a texel, the variance that texels add depends on their position. For this reason,
    // the result is at least half of spread_rad().
    [[nodiscard]] double radius_rad() const {
        const double spread2 = spread_rad() * spread_rad();
        return std::sqrt(std::max(spread2 - sides2 / flux / 3, spread2 / 4));
    }
};

// Marks of the texels. A mark from 1 to kMostLevels is a level: the texel is in a region of this level; see
// find_candidates().
constexpr uint16_t kUnseen = 0, kInside = 0xFFFE, kRing = 0xFFFF;
// find_candidates() tests regions again with higher thresholds, called levels. The threshold of the next
// level is the larger of two values: kLevelStep times the threshold of this level, and kLevelMean times the
// mean luminance of the region.
constexpr double kLevelStep = 2, kLevelMean = 0.25;
constexpr uint16_t kMostLevels = 32;

class SunFinder {
 public:
    SunFinder(uint32_t width_px, uint32_t height_px, std::span<glm::vec3> radiance)
        : width_(width_px), height_(height_px), radiance_(radiance), marks_(radiance.size(), kUnseen) {
        const double step = 2 * std::numbers::pi / width_;
        for (uint32_t y = 0; y < height_; ++y) {
            const double top = std::numbers::pi * y / height_, bottom = std::numbers::pi * (y + 1) / height_;
            const double sines =
                (bottom - top - (std::sin(bottom) * std::cos(bottom) - std::sin(top) * std::cos(top))) / 2;
            const double squares = std::sin(bottom) * std::sin(bottom) - std::sin(top) * std::sin(top);
            const double across = step * std::sin((top + bottom) / 2);
            rows_.push_back({step * (std::cos(top) - std::cos(bottom)), sines * 2 * std::sin(step / 2),
                             step * squares / 2, across * across + (bottom - top) * (bottom - top)});
        }
        for (uint32_t x = 0; x < width_; ++x) {
            const double azimuth = (x + 0.5) * step - std::numbers::pi;
            columns_.emplace_back(std::sin(azimuth), -std::cos(azimuth));
        }
    }

    std::vector<PictureSun> run() {
        find_threshold();
        std::vector<Candidate> candidates = find_candidates();
        std::ranges::stable_sort(candidates, std::greater{}, &Candidate::flux);
        std::vector<PictureSun> suns;
        for (const Candidate& candidate : candidates)
            if (suns.size() < kMostSuns) take_out(candidate, suns);
        std::ranges::stable_sort(suns, std::greater{},
                                 [](const PictureSun& sun) { return luminance_of(sun.illuminance_lx); });
        return suns;
    }

 private:
    // A region that may be a sun: all texels around `seed` that are brighter than `threshold`.
    struct Candidate {
        uint32_t seed = 0;
        uint16_t level = 1;
        double threshold = 0;
        double flux = 0;
    };

    // Sets channels that are negative or not finite to 0, adds up the light of the picture, and finds the
    // median of the luminance. The histogram has one bin for each value of the upper 16 bits of a float, so
    // the median is exact to 0.8 %.
    void find_threshold() {
        std::vector<double> histogram(size_t{1} << 16);
        double all = 0;
        for (uint32_t y = 0; y < height_; ++y) {
            for (uint32_t x = 0; x < width_; ++x) {
                glm::vec3& texel = radiance_[size_t{y} * width_ + x];
                for (int c = 0; c < 3; ++c)
                    if (!(texel[c] >= 0 && std::isfinite(texel[c]))) texel[c] = 0;
                const double luminance = luminance_of(texel);
                flux_ += luminance * rows_[y].solid_angle;
                all += rows_[y].solid_angle;
                histogram[std::bit_cast<uint32_t>(static_cast<float>(luminance)) >> 16] +=
                    rows_[y].solid_angle;
            }
        }
        double below = 0;
        uint32_t bin = 0;
        while (bin + 1 < histogram.size() && (below += histogram[bin]) < all / 2) ++bin;
        threshold_ = kMedians * double{std::bit_cast<float>(bin << 16)};
    }

    // Calls `visit(i)` for each texel that touches texel i, also across the border and over a pole. All
    // texels of the first row touch each other, and so do all texels of the last row. `poles` stores for each
    // of these two rows whether the whole row was already visited. So fill() visits each of the two rows only
    // once.
    template <typename Visit>
    void visit_neighbours(uint32_t i, std::array<bool, 2>& poles, const Visit& visit) const {
        const uint32_t x = i % width_, y = i / width_;
        for (const uint32_t row : {y - 1, y, y + 1}) {
            if (row >= height_) continue;  // Above row 0, y - 1 wraps to a large number.
            for (const uint32_t column : {x == 0 ? width_ - 1 : x - 1, x, x + 1 == width_ ? 0 : x + 1})
                visit(row * width_ + column);
        }
        for (const bool last : {false, true}) {
            const uint32_t row = last ? height_ - 1 : 0;
            if (y != row || poles[last ? 1 : 0]) continue;
            poles[last ? 1 : 0] = true;
            for (uint32_t column = 0; column < width_; ++column) visit(row * width_ + column);
        }
    }

    // Puts the region around `seed` into region_: the connected texels that have the mark `from` and are
    // brighter than `threshold`. These texels get the mark `to`.
    void fill(uint32_t seed, double threshold, uint16_t from, uint16_t to) {
        region_.assign(1, seed);
        marks_[seed] = to;
        std::array<bool, 2> poles{};
        for (size_t next = 0; next < region_.size(); ++next) {
            visit_neighbours(region_[next], poles, [&](uint32_t i) {
                if (marks_[i] != from || luminance_of(radiance_[i]) <= threshold) return;
                marks_[i] = to;
                region_.push_back(i);
            });
        }
    }

    // Adds up the light of region_, after the radiance `ground` is subtracted from each texel.
    [[nodiscard]] RegionLight light_of_region(const glm::vec3& ground) const {
        RegionLight light;
        for (const uint32_t i : region_) {
            const RowShape& row = rows_[i / width_];
            const glm::dvec2& azimuth = columns_[i % width_];
            const glm::dvec3 flow(azimuth.x * row.across, row.up, azimuth.y * row.across);
            const glm::dvec3 excess = glm::dvec3(radiance_[i]) - glm::dvec3(ground);
            const double luminance = luminance_of(radiance_[i]) - luminance_of(ground);
            light.solid_angle += row.solid_angle;
            light.flux += luminance * row.solid_angle;
            light.flow += luminance * flow;
            light.sides2 += luminance * row.solid_angle * row.sides2;
            for (size_t c = 0; c < 3; ++c) light.channel_flow[c] += excess[static_cast<int>(c)] * flow;
        }
        return light;
    }

    [[nodiscard]] bool is_sun(const RegionLight& light, const glm::vec3& ground) const {
        if (light.flux <= kLeastShare * flux_) return false;
        const double spread = light.spread_rad();
        if (spread > kMostRadius_rad || disc_angle(spread) > kMostElongation * light.solid_angle)
            return false;
        const double texel = std::numbers::pi / height_;
        return spread <= std::max(kSmallRadius_rad, kMostTexels * texel) ||
               misplaced_share(light, ground) <= kMostMisplaced;
    }

    // Returns the solid angle of a disc with the angular radius `radius_rad`.
    static double disc_angle(double radius_rad) {
        const double half_sine = std::sin(radius_rad / 2);
        return 4 * std::numbers::pi * half_sine * half_sine;
    }

    // Compares region_ with a uniform disc of the same light and the same spread. Returns the share of the
    // light that the region has outside of the disc, or in excess of the disc's luminance.
    [[nodiscard]] double misplaced_share(const RegionLight& light, const glm::vec3& ground) const {
        const double radius = light.spread_rad(), luminance = light.flux / disc_angle(radius);
        const double texel = std::numbers::pi / height_;
        const glm::dvec3 middle = glm::normalize(light.flow);
        double misplaced = 0;
        for (const uint32_t i : region_) {
            const double polar = std::numbers::pi * (i / width_ + 0.5) / height_;
            const glm::dvec2& azimuth = columns_[i % width_];
            const glm::dvec3 direction(std::sin(polar) * azimuth.x, std::cos(polar),
                                       std::sin(polar) * azimuth.y);
            const double off = std::acos(std::clamp(glm::dot(direction, middle), -1.0, 1.0));
            const double covered = std::clamp((radius - off) / texel + 0.5, 0.0, 1.0);
            const double excess = luminance_of(radiance_[i]) - luminance_of(ground) - covered * luminance;
            misplaced += std::max(excess, 0.0) * rows_[i / width_].solid_angle;
        }
        return misplaced / light.flux;
    }

    // Finds the regions that are brighter than the threshold, and that are suns. A region that has enough
    // light but is too large, or has the wrong shape, may have a sun inside of it, such as the sun in a
    // bright haze. So its texels are searched again with a higher threshold, as regions of the next level.
    std::vector<Candidate> find_candidates() {
        std::vector<Candidate> candidates;
        std::vector<Search> searches;
        for (uint32_t i = 0; i < radiance_.size(); ++i) {
            find_region({i, 1, threshold_}, candidates, searches);
            while (!searches.empty()) {
                const Search search = std::move(searches.back());
                searches.pop_back();
                for (const uint32_t texel : search.texels)
                    find_region({texel, search.level, search.threshold}, candidates, searches);
            }
        }
        return candidates;
    }

    struct Search {
        std::vector<uint32_t> texels;
        uint16_t level = 1;
        double threshold = 0;
    };

    // Fills the region around start.seed, unless this texel is too dark or its region is already found. Adds
    // the region to `candidates` if it is a sun. If it has enough light but is no sun, adds it to `searches`.
    void find_region(Candidate start, std::vector<Candidate>& candidates, std::vector<Search>& searches) {
        const auto from = static_cast<uint16_t>(start.level - 1);
        if (marks_[start.seed] != from || luminance_of(radiance_[start.seed]) <= start.threshold) return;
        fill(start.seed, start.threshold, from, start.level);
        const RegionLight light = light_of_region(glm::vec3(0));
        start.flux = light.flux;
        if (light.flux <= kLeastShare * flux_) return;
        if (is_sun(light, glm::vec3(0)))
            candidates.push_back(start);
        else if (start.level < kMostLevels)
            searches.push_back(
                {region_, static_cast<uint16_t>(start.level + 1),
                 std::max(start.threshold * kLevelStep, light.flux / light.solid_angle * kLevelMean)});
    }

    // Returns the median of the texels that touch region_, separately for each channel.
    glm::vec3 ring_median() {
        std::vector<uint32_t> ring;
        std::array<bool, 2> poles{};
        for (const uint32_t texel : region_) {
            visit_neighbours(texel, poles, [&](uint32_t i) {
                if (marks_[i] == kInside || marks_[i] == kRing) return;
                marks_[i] = kRing;
                ring.push_back(i);
            });
        }
        glm::vec3 median(0);
        std::vector<float> values(ring.size());
        for (int c = 0; c < 3 && !ring.empty(); ++c) {
            std::ranges::transform(ring, values.begin(), [&](uint32_t i) { return radiance_[i][c]; });
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::ranges::nth_element(values, middle);
            median[c] = *middle;
        }
        for (const uint32_t i : ring) marks_[i] = kUnseen;
        return median;
    }

    void take_out(const Candidate& candidate, std::vector<PictureSun>& suns) {
        fill(candidate.seed, candidate.threshold, candidate.level, kInside);
        const glm::vec3 ground = ring_median();
        const RegionLight light = light_of_region(ground);
        if (!is_sun(light, ground)) return;
        const glm::dvec3 to_sun = glm::normalize(light.flow);
        PictureSun sun;
        sun.to_sun = glm::vec3(to_sun);
        sun.solid_angle_sr = static_cast<float>(light.solid_angle);
        sun.angular_radius_rad = static_cast<float>(light.radius_rad());
        for (size_t c = 0; c < 3; ++c)
            sun.illuminance_lx[static_cast<int>(c)] =
                static_cast<float>(std::max(0.0, glm::dot(light.channel_flow[c], to_sun)));
        for (const uint32_t i : region_) radiance_[i] = ground;
        suns.push_back(sun);
    }

    uint32_t width_, height_;
    std::span<glm::vec3> radiance_;
    std::vector<uint16_t> marks_;
    std::vector<uint32_t> region_;
    std::vector<RowShape> rows_;
    std::vector<glm::dvec2>
        columns_;  // The sine of the azimuth and its negative cosine: x and z of a direction.
    double flux_ = 0;
    double threshold_ = 0;
};

}  // namespace

std::vector<PictureSun> extract_suns(uint32_t width_px, uint32_t height_px, std::span<glm::vec3> radiance) {
    return radiance.empty() ? std::vector<PictureSun>{} : SunFinder(width_px, height_px, radiance).run();
}

}  // namespace weft::scene
