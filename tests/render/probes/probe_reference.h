// Purpose: computes the light of the irradiance probes at a point on the CPU, in double precision, as
// docs/probes.md describes it. It does not use the tables of framework/render/probes.
#pragma once

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "weft/scene/probes.h"

namespace weft::test {

// The content of `probeSh` and `probeMoments` for the probes that exist.
struct ProbeContent {
    std::vector<glm::vec4> harmonics;  // 16 for each probe.
    std::vector<glm::vec4> moments;    // 18 × 18 for each probe.
};

struct LookedUp {
    glm::dvec3 facing{0}, mirrored{0};
    double validity = 0;
};

struct PointQuery {
    glm::dvec3 position{0}, normal{0}, to_eye{0}, mirrored{0};
};

class ProbeReference {
 public:
    ProbeReference(const scene::ProbeVolume& volume, ProbeContent content);
    [[nodiscard]] LookedUp look_up(const PointQuery& query) const;

 private:
    struct Place {
        const scene::ProbeCell* cell = nullptr;
        glm::dvec3 t{0};  // From 0 to 1.
        double share = 0;
    };
    struct Sums;

    [[nodiscard]] const scene::ProbeCell* cell_at(const glm::ivec3& corner, uint32_t level) const;
    [[nodiscard]] Place find_place(const glm::dvec3& position, uint32_t level) const;
    [[nodiscard]] double fade(const scene::ProbeCell& cell, const glm::dvec3& t) const;
    [[nodiscard]] double visibility(size_t probe, const glm::dvec3& to_point) const;
    double add(Sums& sums, const PointQuery& query, const Place& place, double weight) const;
    [[nodiscard]] double spacing_m(uint32_t level) const {
        return double(volume_.spacing_m) * volume_.strides[level];
    }

    scene::ProbeVolume volume_;
    glm::dmat3 to_grid_{1};  // From world space to the axes of the grid.
    ProbeContent content_;
    std::vector<scene::ProbeCell> cells_;
    std::map<std::tuple<uint32_t, int, int, int>, size_t> places_;
    std::vector<size_t> numbers_;  // Of each grid point: the number of its probe.
};

}  // namespace weft::test
