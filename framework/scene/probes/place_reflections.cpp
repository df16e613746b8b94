#include "scene/probes/place_reflections.h"

#include <algorithm>
#include <bitset>
#include <numeric>

#include "scene/loading/worker_threads.h"
#include "scene/probes/settle_probe.h"

namespace weft::scene {
namespace {

using Seen = std::bitset<kMostIrradianceProbes>;

// A new reflection probe must see at least 1 / kLeastPart of all irradiance probes. Irradiance probes that an
// earlier reflection probe sees do not count for it. Minor probes count less; see kMinorValue.
constexpr double kLeastPart = 16;
// A minor probe (in the open, or in a closed shell) counts as this part of a probe, because surfaces near it
// mostly reflect the sky.
constexpr double kMinorValue = 0.05;
// An irradiance probe at this distance counts half. An irradiance probe at more than twice this distance does
// not count. Unit: the smallest spacing of the grid.
constexpr double kHalfDistance = 16;

}  // namespace

std::vector<ReflectionProbe> place_reflections(const TriangleTree& tree, const ProbeVolume& volume,
                                               uint32_t threads) {
    std::vector<glm::vec3> places;
    for (const Probe& probe : volume.probes)
        if (probe.state != ProbeState::dropped) places.push_back(position_of(volume, probe));
    const double half_m = kHalfDistance * double{volume.spacing_m};
    std::vector<Seen> seen(places.size());
    run_on_threads(places.size(), threads, [&](size_t i) {
        for (size_t k = 0; k < places.size(); ++k) {
            const bool near = double{glm::distance(places[i], places[k])} <= 2 * half_m;
            seen[i][k] = near && sees(tree, places[i], places[k]);
        }
    });
    Seen open;
    for (size_t i = 0; i < places.size(); ++i) open.set(i);
    std::vector<double> weights(places.size());
    run_on_threads(places.size(), threads,
                   [&](size_t i) { weights[i] = look_around(tree, places[i]).is_minor ? kMinorValue : 1; });
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto value_of = [&](size_t i) {
        double value = 0;
        for (size_t k = 0; k < places.size(); ++k) {
            const double ratio = double{glm::distance(places[i], places[k])} / half_m;
            if (seen[i][k] && open[k]) value += weights[k] / (1 + ratio * ratio);
        }
        return value * weights[i];
    };
    std::vector<ReflectionProbe> chosen;
    while (chosen.size() < kMostReflectionProbes && open.any()) {
        std::vector<double> values(places.size());
        run_on_threads(places.size(), threads, [&](size_t i) { values[i] = value_of(i); });
        const size_t best = static_cast<size_t>(std::ranges::max_element(values) - values.begin());
        const Seen first = seen[best] & open;
        double part = 0;
        for (size_t k = 0; k < places.size(); ++k) part += first[k] ? weights[k] : 0;
        if (part * kLeastPart < all) break;
        chosen.push_back({"automatic " + std::to_string(chosen.size() + 1), places[best], std::nullopt});
        open &= ~first;
    }
    return chosen;
}

}  // namespace weft::scene
