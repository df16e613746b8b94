#include "tests/render/probes/probe_reference.h"

#include <algorithm>
#include <cmath>

namespace weft::test {
namespace {

constexpr int kSide = 32;       // Texels of a map of moments, without the border.
constexpr double kFade = 0.25;  // In cells.
constexpr double kReach = 0.5;  // In cells.
constexpr double kBias = 0.1;   // In spacings.
constexpr double kTrusted = 0.02;
constexpr double kFacingAxis = 0.25;
constexpr double kLeastCloseness = 0.01;

double step(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

glm::dvec2 octahedral(const glm::dvec3& v) {
    const double sum = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    const glm::dvec2 p(v.x / sum, v.y / sum);
    if (v.z >= 0) return p;
    return {(1 - std::abs(p.y)) * (p.x >= 0 ? 1 : -1), (1 - std::abs(p.x)) * (p.y >= 0 ? 1 : -1)};
}

std::array<double, 9> basis(const glm::dvec3& n) {
    return {1, n.x, n.y, n.z, n.x * n.y, n.y * n.z, n.x * n.z, 3 * n.y * n.y - 1, n.x * n.x - n.z * n.z};
}

// Returns the side of the cell, −1 or 1 along each axis, on which neighbours are looked up for a surface.
glm::ivec3 side_of(const glm::dvec3& normal, const glm::dvec3& t) {
    glm::ivec3 side;
    for (int i = 0; i < 3; ++i) {
        const double towards = std::abs(normal[i]) > kFacingAxis ? normal[i] : t[i] - 0.5;
        side[i] = towards >= 0 ? 1 : -1;
    }
    return side;
}

}  // namespace

struct ProbeReference::Sums {
    glm::dvec3 facing{0}, mirrored{0};
    double lit = 0, weight = 0;
};

ProbeReference::ProbeReference(const scene::ProbeVolume& volume, ProbeContent content)
    : volume_(volume), content_(std::move(content)), cells_(scene::cells_of(volume)) {
    to_grid_ = glm::dmat3(glm::transpose(scene::yaw_rotation(volume.yaw_deg)));
    for (size_t i = 0; i < cells_.size(); ++i) {
        const scene::ProbeCell& cell = cells_[i];
        places_[{cell.level, cell.at.x, cell.at.y, cell.at.z}] = i;
    }
    size_t number = 0;
    for (const scene::Probe& probe : volume_.probes) {
        numbers_.push_back(number);
        if (probe.state != scene::ProbeState::dropped) ++number;
    }
}

const scene::ProbeCell* ProbeReference::cell_at(const glm::ivec3& corner, uint32_t level) const {
    const int stride = static_cast<int>(volume_.strides[level]);
    const auto found = places_.find({level, corner.x * stride, corner.y * stride, corner.z * stride});
    return found == places_.end() ? nullptr : &cells_[found->second];
}

// Next to a missing neighbour, the share of the cell falls to 0.
double ProbeReference::fade(const scene::ProbeCell& cell, const glm::dvec3& t) const {
    const glm::ivec3 corner = cell.at / static_cast<int>(volume_.strides[cell.level]);
    double nearest = kFade;
    for (int i = 0; i < 27; ++i) {
        const glm::ivec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (cell_at(corner + step, cell.level) != nullptr) continue;
        double apart = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (step[axis] != 0) apart = std::max(apart, step[axis] > 0 ? 1 - t[axis] : t[axis]);
        nearest = std::min(nearest, apart);
    }
    return step(nearest / kFade);
}

ProbeReference::Place ProbeReference::find_place(const glm::dvec3& position, uint32_t level) const {
    const glm::dvec3 grid = to_grid_ * (position - glm::dvec3(volume_.origin)) / spacing_m(level);
    const glm::dvec3 corner = glm::floor(grid), t = grid - corner;
    const bool coarsest = level + 1 == volume_.strides.size();
    Place place{cell_at(glm::ivec3(corner), level), t, 1};
    if (place.cell != nullptr) {
        if (!coarsest) place.share = fade(*place.cell, t);
        return place;
    }
    if (!coarsest) return place;
    // Of equally near cells, the one along x counts, then y, then x and y, and so on.
    double nearest = kReach;
    for (int i = 1; i < 8; ++i) {
        glm::ivec3 step(i & 1, i >> 1 & 1, i >> 2 & 1);
        for (int axis = 0; axis < 3; ++axis)
            if (t[axis] < 0.5) step[axis] = -step[axis];
        const scene::ProbeCell* cell = cell_at(glm::ivec3(corner) + step, level);
        if (cell == nullptr) continue;
        const glm::dvec3 inside = glm::clamp(t - glm::dvec3(step), 0.0, 1.0);
        const glm::dvec3 away = glm::abs(t - glm::dvec3(step) - inside);
        const double apart = std::max({away.x, away.y, away.z});
        if (apart >= nearest) continue;
        nearest = apart;
        place.cell = cell;
        place.t = inside;
    }
    place.share = 1 - nearest / kReach;
    return place;
}

// Of the four nearest texels, the one that hides most decides; but the mean of the four where the nearest
// surface is much nearer than the point, and the farthest is about as far as the point.
double ProbeReference::visibility(size_t probe, const glm::dvec3& to_point) const {
    const glm::dvec2 at = (octahedral(to_point) * 0.5 + 0.5) * double(kSide) + 0.5;
    const glm::dvec2 low = glm::floor(at), f = at - low;
    const double distance = glm::length(to_point);
    double least = 1, mean = 0, nearest = 0, farthest = 1e30;
    for (size_t i = 0; i < 4; ++i) {
        const size_t dx = i % 2, dy = i / 2, side = kSide + 2;
        const size_t x = static_cast<size_t>(low.x) + dx, y = static_cast<size_t>(low.y) + dy;
        const glm::dvec4 seen(content_.moments[(probe * side + y) * side + x]);
        const double weight = (dx != 0 ? f.x : 1 - f.x) * (dy != 0 ? f.y : 1 - f.y);
        const double surface = glm::dot(glm::dvec3(seen), to_point) / distance;
        nearest = std::max(nearest, surface * distance);
        farthest = std::min(farthest, surface * distance);
        const double behind = surface - 1 / distance;
        if (behind <= 0) {
            mean += weight;
            continue;
        }
        const double variance = std::pow(std::clamp(seen.w, 0.03 * surface, 0.12 * surface), 2);
        const double less = behind * std::min(1.0, 32 * weight);
        least = std::min(least, variance / (variance + less * less));
        mean += weight * std::pow(variance / (variance + behind * behind), 3);
    }
    const double edge = step((nearest - 1.6) / 1.4) * (1 - step((std::abs(farthest - 1) - 0.4) / 0.3));
    return glm::mix(std::pow(least, 3), mean, edge);
}

double ProbeReference::add(Sums& sums, const PointQuery& query, const Place& place, double weight) const {
    const glm::dvec3 looked_at =
        query.position + (query.normal + query.to_eye) * kBias * std::min(1.0, spacing_m(place.cell->level));
    glm::dvec3 facing(0), mirrored(0);
    double lit = 0, seen = 0, all = 0;
    for (size_t corner = 0; corner < 8; ++corner) {
        const uint32_t index = place.cell->corners[corner];
        if (index == scene::ProbeCell::kNoProbe) continue;
        const glm::dvec3 probe(scene::position_of(volume_, volume_.probes[index]));
        double near = 1;
        for (int axis = 0; axis < 3; ++axis)
            near *= std::max(kLeastCloseness, (corner >> axis & 1) != 0 ? place.t[axis] : 1 - place.t[axis]);
        const double cosine = glm::dot(glm::normalize(probe - query.position), query.normal);
        const double own = near * (std::pow((1 + cosine) / 2, 2) + 0.2);
        const size_t number = numbers_[index];
        const glm::vec4* harmonics = &content_.harmonics[16 * number];
        const bool has_light = harmonics[0].w > 0;
        const double visible =
            own * (has_light ? std::max(visibility(number, looked_at - probe), 1e-12) : 1.0);
        all += own;
        seen += visible;
        if (!has_light) continue;
        lit += visible;
        for (size_t i = 0; i < 9; ++i) {
            facing += visible * basis(query.normal)[i] * glm::dvec3(harmonics[i]);
            mirrored += visible * basis(query.mirrored)[i] * glm::dvec3(harmonics[i]);
        }
    }
    if (all <= 0) return -1;
    const double trust = std::clamp(seen / all / kTrusted, 1e-6, 1.0);
    sums.facing += weight * trust / seen * glm::max(facing, 0.0);
    sums.mirrored += weight * trust / seen * glm::max(mirrored, 0.0);
    sums.lit += weight * trust * lit / seen;
    sums.weight += weight * trust;
    return trust;
}

LookedUp ProbeReference::look_up(const PointQuery& query) const {
    Sums sums;
    Place first;
    double rest = 1, beyond = 1, outside = 1;
    for (uint32_t level = 0; level < volume_.strides.size() && rest > 1e-3; ++level) {
        const Place place = find_place(query.position, level);
        if (place.cell == nullptr || place.share <= 0) continue;
        if (first.cell == nullptr) first = place;
        const double trust = add(sums, query, place, rest * place.share);
        rest *= 1 - place.share * std::max(trust, 0.0);
        beyond *= 1 - place.share;
        const bool coarsest = level + 1 == volume_.strides.size();
        outside = coarsest ? outside * (1 - place.share) : 0;
    }
    for (int i = 1; i < 8 && rest - beyond > 1e-3; ++i) {
        const glm::ivec3 step =
            glm::ivec3(i & 1, i >> 1 & 1, i >> 2) * side_of(to_grid_ * query.normal, first.t);
        const glm::ivec3 corner = first.cell->at / static_cast<int>(volume_.strides[first.cell->level]);
        const scene::ProbeCell* around = cell_at(corner + step, first.cell->level);
        if (around == nullptr) continue;
        add(sums, query, {around, glm::clamp(first.t - glm::dvec3(step), 0.0, 1.0), 1}, rest - beyond);
    }
    if (sums.lit <= 0) return {};
    return {sums.facing / sums.lit, sums.mirrored / sums.lit, sums.lit / sums.weight * (1 - outside)};
}

}  // namespace weft::test
