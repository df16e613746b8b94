#include "scene/probes/share_minor_probes.h"

#include <algorithm>
#include <bit>
#include <map>

#include "scene/loading/worker_threads.h"
#include "scene/probes/cell_view.h"
#include "scene/probes/probe_grid.h"

namespace weft::scene {
namespace {

// A probe can be the substitute of another probe if their distance is at most this value. Unit: the side of
// the finest cell that has the other probe at a corner. The values are tried in turn, until one of them saves
// enough probes.
constexpr std::array<float, 5> kReaches{1.1f, 1.5f, 2.1f, 3, 4.2f};
// At most 1 / kHiddenPart of the places that a probe sees may be hidden from its substitute.
constexpr size_t kHiddenPart = 10;
// For each probe, at most kMostPlaces places are compared, and at most kMostCandidates substitutes are tried.
constexpr size_t kMostPlaces = 64;
constexpr size_t kMostCandidates = 6;
// The compared places are at this distance in front of surfaces. Unit: the smallest spacing of the volume.
constexpr float kBefore = 0.2f;

struct MinorProbe {
    uint32_t index = 0;             // An index into ProbeVolume::probes.
    float spacing_m = 0;            // Spacing of the finest cell that has the probe at a corner.
    std::vector<glm::vec3> places;  // The places in its cells that the probe sees.
};

// Returns the largest power of two that divides all coordinates.
uint32_t alignment_of(const glm::ivec3& at) {
    const auto bits = static_cast<uint32_t>(at.x | at.y | at.z);
    return bits == 0 ? UINT32_MAX : 1u << std::countr_zero(bits);
}

// Keeps at most kMostPlaces places, evenly from the whole list.
void thin_out(std::vector<glm::vec3>& places) {
    if (places.size() <= kMostPlaces) return;
    for (size_t i = 0; i < kMostPlaces; ++i) places[i] = places[i * places.size() / kMostPlaces];
    places.resize(kMostPlaces);
}

class Sharing {
 public:
    Sharing(const TriangleTree& tree, ProbeVolume& volume, uint32_t threads)
        : tree_(tree), volume_(volume), threads_(threads), cells_(cells_of(volume)) {
        for (const ProbeCell& cell : cells_)
            found_[{cell.at.x, cell.at.y, cell.at.z, int(cell.level)}] = true;
        find_minor();
        std::ranges::sort(minor_, [&](const MinorProbe& a, const MinorProbe& b) {
            const glm::ivec3 &p = volume_.probes[a.index].at, &q = volume_.probes[b.index].at;
            const uint32_t i = alignment_of(p), k = alignment_of(q);
            return i != k ? i > k : PointOrder{}(p, q);
        });
        find_places();
    }

    // Finds a substitute for each minor probe, at a distance of at most `reach`; see kReaches. Returns the
    // number of probes that have a substitute.
    uint32_t share(float reach) {
        uint32_t saved = 0;
        std::vector<const MinorProbe*> kept;
        for (const MinorProbe& probe : minor_) {
            std::optional<glm::ivec3>& substitute = volume_.probes[probe.index].substitute;
            substitute = substitute_for(probe, reach, kept);
            if (substitute)
                ++saved;
            else
                kept.push_back(&probe);
        }
        return saved;
    }

    // Drops the probes that have a substitute.
    void finish() {
        for (const MinorProbe& minor : minor_) {
            Probe& probe = volume_.probes[minor.index];
            if (!probe.substitute) continue;
            probe.state = ProbeState::dropped;
            probe.offset = glm::vec3(0);
        }
    }

 private:
    [[nodiscard]] glm::vec3 place_of(const MinorProbe& probe) const {
        return position_of(volume_, volume_.probes[probe.index]);
    }

    [[nodiscard]] float spacing_of(uint32_t level) const {
        return volume_.spacing_m * static_cast<float>(volume_.strides[level]);
    }

    void find_minor() {
        std::vector<uint8_t> minor(volume_.probes.size());
        run_on_threads(minor.size(), threads_, [&](size_t i) {
            const Probe& probe = volume_.probes[i];
            minor[i] =
                probe.state != ProbeState::dropped && look_around(tree_, position_of(volume_, probe)).is_minor
                    ? 1
                    : 0;
        });
        for (uint32_t i = 0; i < minor.size(); ++i)
            if (minor[i] != 0) minor_.push_back({i, 0, {}});
    }

    // True if a finer cell contains the place.
    [[nodiscard]] bool is_in_finer_cell(const glm::vec3& place, uint32_t level) const {
        for (uint32_t i = 0; i < level; ++i) {
            const int stride = static_cast<int>(volume_.strides[i]);
            const glm::ivec3 at(glm::floor((place - volume_.origin) / spacing_of(i)));
            if (found_.contains({at.x * stride, at.y * stride, at.z * stride, int(i)})) return true;
        }
        return false;
    }

    void find_places() {
        std::vector<std::vector<glm::vec3>> places(cells_.size());
        run_on_threads(cells_.size(), threads_, [&](size_t i) {
            const glm::vec3 low = volume_.origin + glm::vec3(cells_[i].at) * volume_.spacing_m;
            places[i] = places_before_surfaces(tree_, {low, low + spacing_of(cells_[i].level)},
                                               kBefore * volume_.spacing_m);
            std::erase_if(places[i],
                          [&](const glm::vec3& place) { return is_in_finer_cell(place, cells_[i].level); });
        });
        run_on_threads(minor_.size(), threads_, [&](size_t k) {
            MinorProbe& probe = minor_[k];
            for (size_t i = 0; i < cells_.size(); ++i) {
                if (std::ranges::find(cells_[i].corners, probe.index) == cells_[i].corners.end()) continue;
                if (probe.spacing_m == 0) probe.spacing_m = spacing_of(cells_[i].level);
                for (const glm::vec3& place : places[i])
                    if (sees(tree_, place, place_of(probe))) probe.places.push_back(place);
            }
            thin_out(probe.places);
        });
    }

    [[nodiscard]] bool can_substitute(const MinorProbe& substitute, const MinorProbe& probe) {
        const auto [known, fresh] = can_substitute_.try_emplace({substitute.index, probe.index}, false);
        if (!fresh) return known->second;
        const size_t most_hidden = probe.places.size() / kHiddenPart;
        size_t hidden = 0;
        return known->second = std::ranges::all_of(probe.places, [&](const glm::vec3& place) {
                   hidden += sees(tree_, place, place_of(substitute)) ? 0 : 1;
                   return hidden <= most_hidden;
               });
    }

    [[nodiscard]] std::optional<glm::ivec3> substitute_for(const MinorProbe& probe, float reach,
                                                           const std::vector<const MinorProbe*>& kept) {
        struct Near {
            float distance_m;
            const MinorProbe* probe;
        };
        std::vector<Near> near;
        for (const MinorProbe* other : kept) {
            const float distance_m = glm::distance(place_of(probe), place_of(*other));
            if (distance_m <= reach * probe.spacing_m) near.push_back({distance_m, other});
        }
        std::ranges::stable_sort(near, {}, &Near::distance_m);
        if (near.size() > kMostCandidates) near.resize(kMostCandidates);
        for (const Near& other : near)
            if (can_substitute(*other.probe, probe)) return volume_.probes[other.probe->index].at;
        return std::nullopt;
    }

    const TriangleTree& tree_;
    ProbeVolume& volume_;
    uint32_t threads_;
    std::vector<ProbeCell> cells_;
    std::map<std::array<int, 4>, bool> found_;  // Keys: corner and level of each cell that exists.
    std::vector<MinorProbe> minor_;
    std::map<std::pair<uint32_t, uint32_t>, bool> can_substitute_;  // Results for pairs of probes.
};

}  // namespace

uint32_t share_minor_probes(const TriangleTree& tree, ProbeVolume& volume, uint32_t most, uint32_t threads) {
    const auto count = static_cast<uint32_t>(volume.probes.size()) - count_of(volume, ProbeState::dropped);
    if (count <= most) return count;
    Sharing sharing(tree, volume, threads);
    uint32_t saved = 0;
    for (const float reach : kReaches) {
        saved = sharing.share(reach);
        if (count - saved <= most) break;
    }
    sharing.finish();
    return count - saved;
}

}  // namespace weft::scene
