#include "render/views/sun_fit.h"

#include <array>
#include <numeric>
#include <span>
#include <tuple>

namespace weft::render {
namespace {

// A group of patches is sorted along an axis and divided into a first part and a second part. These are the
// shares of all patches that the first part may have. With the shares near 0 and 1, a few patches far away
// can be separated from the others.
constexpr std::array kPlaces{1.0 / 256, 1.0 / 64,  1.0 / 16,  2.0 / 16,  3.0 / 16,   4.0 / 16,  5.0 / 16,
                             6.0 / 16,  7.0 / 16,  8.0 / 16,  9.0 / 16,  10.0 / 16,  11.0 / 16, 12.0 / 16,
                             13.0 / 16, 14.0 / 16, 15.0 / 16, 63.0 / 64, 255.0 / 256};
// The group of all patches can be divided in many ways. Only this number of these divisions is examined
// further, by dividing their two sides again: the divisions with the lowest cost without further divisions.
constexpr size_t kFollowed = 8;
// Additional cost of a patch that is left to the map that covers everything: the texels of this map count as
// four times as wide. So only few patches are left to this map.
const double kOmittedCost = std::log(16.0);
// Least side of a rectangle, in metres, so that its area is not 0.
constexpr double kLeastRectSide_m = 1e-3;
// Axes along which a group is divided: the two axes of the plane, and the distance from the eye.
constexpr size_t kDivisionAxes = 3;

double position(const VisiblePatch& patch, size_t axis) {
    const int i = static_cast<int>(axis);
    return axis == 2 ? patch.distance_m : (patch.rect.min[i] + patch.rect.max[i]) * 0.5;
}

// Returns a rectangle that contains the whole plane.
LightRect everywhere() {
    return {glm::dvec2(std::numeric_limits<double>::lowest()),
            glm::dvec2(std::numeric_limits<double>::max())};
}

LightRect common(const LightRect& a, const LightRect& b) {
    return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

double log_area(const LightRect& rect) {
    const glm::dvec2 size = glm::max(rect.size(), glm::dvec2(kLeastRectSide_m));
    return std::log(size.x * size.y);
}

// The patches that a map covers. Their cost is the sum, over the patches, of the logarithm of the area of the
// map's texels in pixels. The part of the sum that is the same for all maps is left out.
class Cost {
 public:
    void add(const VisiblePatch& patch) {
        rect_.add(patch.rect);
        shares_ += patch.share;
    }
    // The cost if only the part of the patches inside of `limits` counts.
    [[nodiscard]] double value(const LightRect& limits) const { return shares_ * log_area(rect(limits)); }
    [[nodiscard]] double shares() const { return shares_; }
    [[nodiscard]] LightRect rect(const LightRect& limits) const { return common(rect_, limits); }

 private:
    LightRect rect_;
    double shares_ = 0;
};

// Patches that one or more maps cover: their indices in the order along each axis.
struct PatchGroup {
    std::array<std::vector<uint32_t>, kDivisionAxes> orders;
    // The maps of this group cover the patches only inside of this rectangle. Maps of other groups cover the
    // rest.
    LightRect limits;

    [[nodiscard]] size_t size() const { return orders[0].size(); }
};

// Which sides of a divided group get maps of their own: both, only the side before the division, or only the
// side after it. If only one side gets maps, the other side is left to the map that covers everything.
enum class Kept : uint8_t { both, before, after };
constexpr std::array kWaysToKeep{Kept::both, Kept::before, Kept::after};

struct Division {
    double cost = 0;
    size_t axis = 0;
    size_t place = 0;  // Number of patches on the side before the division.
    Kept kept = Kept::both;
};

struct Fit {
    double cost = 0;
    std::vector<LightRect> rects;
};

class Fitter {
 public:
    Fitter(std::span<const VisiblePatch> patches, const LightRect& whole)
        : patches_(patches), whole_(log_area(whole) + kOmittedCost), side_(patches.size()) {}

    [[nodiscard]] PatchGroup all() const {
        PatchGroup group;
        group.limits = everywhere();
        for (size_t axis = 0; axis < kDivisionAxes; ++axis) {
            group.orders[axis].resize(patches_.size());
            std::iota(group.orders[axis].begin(), group.orders[axis].end(), 0u);
            std::ranges::stable_sort(group.orders[axis], {},
                                     [&](uint32_t i) { return position(patches_[i], axis); });
        }
        return group;
    }

    // Returns the best fit that was found with at most `count` maps. The cost of a division is computed as if
    // no further divisions followed. The `followed` divisions with the lowest cost are then tried with
    // further divisions.
    [[nodiscard]] Fit best(const PatchGroup& group, uint32_t count, size_t followed = kFollowed) {
        Fit best = undivided(group);
        if (group.size() < 2) return best;
        std::vector<Division> divisions = divisions_of(group, count > 1);
        std::ranges::stable_sort(divisions, {}, &Division::cost);
        divisions.resize(std::min(divisions.size(), followed));
        for (const Division& division : divisions) {
            if (count == 1 && division.cost >= best.cost) break;
            Fit fit = fit_of(group, division, count, followed / 2);
            if (fit.cost < best.cost) best = std::move(fit);
        }
        return best;
    }

 private:
    [[nodiscard]] Fit undivided(const PatchGroup& group) const {
        Cost cost;
        for (const uint32_t i : group.orders[0]) cost.add(patches_[i]);
        return {cost.value(group.limits), {cost.rect(group.limits)}};
    }
    // Returns the best fit for a division, with the maps shared out to both sides in every possible way.
    [[nodiscard]] Fit fit_of(const PatchGroup& group, const Division& division, uint32_t count,
                             size_t followed) {
        const auto [before, after] = divided(group, division);
        if (division.kept != Kept::both) {
            Fit fit = best(division.kept == Kept::before ? before : after, count, followed);
            fit.cost += whole_cost(division.kept == Kept::before ? after : before);
            return fit;
        }
        Fit result;
        for (uint32_t left = 1; left < count; ++left) {
            Fit fit = best(before, left, followed);
            const Fit other = best(after, count - left, followed);
            fit.cost += other.cost;
            fit.rects.insert(fit.rects.end(), other.rects.begin(), other.rects.end());
            if (left == 1 || fit.cost < result.cost) result = std::move(fit);
        }
        return result;
    }
    [[nodiscard]] double whole_cost(const PatchGroup& group) const {
        Cost cost;
        for (const uint32_t i : group.orders[0]) cost.add(patches_[i]);
        return cost.shares() * whole_;
    }
    // For each element of kPlaces, returns the cost of the patches before this place along an axis (or of the
    // patches after this place, if `backward`).
    [[nodiscard]] std::array<Cost, kPlaces.size()> costs_along(const PatchGroup& group, size_t axis,
                                                               bool backward) const {
        std::array<Cost, kPlaces.size()> costs;
        Cost cost;
        size_t done = 0;
        for (size_t k = 0; k < kPlaces.size(); ++k) {
            const size_t place = backward ? kPlaces.size() - 1 - k : k;
            const size_t at = place_of(group, place), wanted = backward ? group.size() - at : at;
            for (; done < wanted; ++done)
                cost.add(patches_[group.orders[axis][backward ? group.size() - 1 - done : done]]);
            costs[place] = cost;
        }
        return costs;
    }
    [[nodiscard]] static size_t place_of(const PatchGroup& group, size_t place) {
        return static_cast<size_t>(static_cast<double>(group.size()) * kPlaces[place]);
    }
    [[nodiscard]] std::vector<Division> divisions_of(const PatchGroup& group, bool may_keep_both) const {
        std::vector<Division> found;
        for (size_t axis = 0; axis < kDivisionAxes; ++axis) {
            const auto firsts = costs_along(group, axis, false), lasts = costs_along(group, axis, true);
            for (size_t place = 0; place < kPlaces.size(); ++place) {
                Division division{0, axis, place_of(group, place)};
                if (division.place == 0 || division.place == group.size()) continue;
                const auto limits = limits_of(group, division);
                for (const Kept kept : kWaysToKeep) {
                    if (kept == Kept::both && !may_keep_both) continue;
                    division.kept = kept;
                    division.cost = (kept == Kept::after ? firsts[place].shares() * whole_
                                                         : firsts[place].value(limits.first)) +
                                    (kept == Kept::before ? lasts[place].shares() * whole_
                                                          : lasts[place].value(limits.second));
                    found.push_back(division);
                }
            }
        }
        return found;
    }
    // Returns PatchGroup::limits for the two sides of a division.
    [[nodiscard]] std::pair<LightRect, LightRect> limits_of(const PatchGroup& group,
                                                            const Division& division) const {
        std::pair limits(group.limits, group.limits);
        if (division.axis == 2) return limits;
        const auto at = [&](size_t place) {
            return position(patches_[group.orders[division.axis][place]], division.axis);
        };
        const double line = (at(division.place - 1) + at(division.place)) * 0.5;
        limits.first.max[static_cast<int>(division.axis)] = line;
        limits.second.min[static_cast<int>(division.axis)] = line;
        return limits;
    }
    [[nodiscard]] std::pair<PatchGroup, PatchGroup> divided(const PatchGroup& group,
                                                            const Division& division) {
        const std::vector<uint32_t>& order = group.orders[division.axis];
        for (size_t k = 0; k < order.size(); ++k) side_[order[k]] = k < division.place ? 0 : 1;
        std::pair<PatchGroup, PatchGroup> result;
        std::tie(result.first.limits, result.second.limits) = limits_of(group, division);
        for (size_t axis = 0; axis < kDivisionAxes; ++axis)
            for (const uint32_t i : group.orders[axis])
                (side_[i] == 0 ? result.first : result.second).orders[axis].push_back(i);
        return result;
    }

    std::span<const VisiblePatch> patches_;
    double whole_ = 0;  // Cost of a patch that only the map that covers everything contains.
    std::vector<uint8_t> side_;
};

}  // namespace

std::vector<LightRect> fit_rects(std::span<const VisiblePatch> patches, uint32_t count,
                                 const LightRect& whole) {
    if (patches.empty() || count == 0) return {};
    Fitter fitter(patches, whole);
    std::vector<LightRect> rects = fitter.best(fitter.all(), count).rects;
    std::ranges::stable_sort(rects, {}, [](const LightRect& rect) { return rect.size().x * rect.size().y; });
    return rects;
}

}  // namespace weft::render
