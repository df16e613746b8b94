#include "render/probes/probe_tables.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/views/view_matrices.h"

namespace weft::render {
namespace {

static_assert(sizeof(shared::ProbePoint) == 16 && sizeof(shared::ProbeCell) == 64 &&
              sizeof(shared::ProbeGrid) == 64);

// Distance from a probe to the near planes of the views of its six faces, in metres.
constexpr double kProbeNear_m = 0.01;
constexpr int kNeighbours = 27;

// Returns the slot of a cell, or the empty slot at which the search for it ends.
shared::ProbeCell& find_slot(std::vector<shared::ProbeCell>& slots, const glm::ivec3& at, uint32_t level) {
    const auto count = static_cast<uint32_t>(slots.size());
    uint32_t slot = shared::probe_cell_slot(at, level, count);
    while (slots[slot].level != shared::kEmptyProbeSlot &&
           (slots[slot].level != level || slots[slot].at != at))
        slot = (slot + 1) % count;
    return slots[slot];
}

void find_neighbours(std::vector<shared::ProbeCell>& slots, const scene::ProbeVolume& volume) {
    for (shared::ProbeCell& cell : slots) {
        if (cell.level == shared::kEmptyProbeSlot) continue;
        const int stride = static_cast<int>(volume.strides[cell.level]);
        for (int i = 0; i < kNeighbours; ++i) {
            const glm::ivec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (find_slot(slots, cell.at + step * stride, cell.level).level == cell.level)
                cell.neighbours |= 1u << i;
        }
    }
}

std::vector<shared::ProbeCell> hash_cells(const std::vector<scene::ProbeCell>& cells,
                                          const scene::ProbeVolume& volume,
                                          const std::vector<uint32_t>& numbers) {
    shared::ProbeCell empty{};
    empty.level = shared::kEmptyProbeSlot;
    std::vector<shared::ProbeCell> slots(slots_for(cells.size()), empty);
    for (const scene::ProbeCell& cell : cells) {
        shared::ProbeCell& slot = find_slot(slots, cell.at, cell.level);
        slot.at = cell.at;
        slot.level = cell.level;
        for (size_t i = 0; i < cell.corners.size(); ++i) {
            const bool exists = cell.corners[i] != scene::ProbeCell::kNoProbe;
            slot.corners[i] = exists ? numbers[cell.corners[i]] : shared::kNoProbe;
        }
    }
    find_neighbours(slots, volume);
    return slots;
}

// Returns the grid point of a corner of the cell.
glm::ivec3 corner_at(const scene::ProbeCell& cell, uint32_t corner, const scene::ProbeVolume& volume) {
    const glm::ivec3 side(corner & 1u, corner >> 1u & 1u, corner >> 2u);
    return cell.at + side * static_cast<int>(volume.strides[cell.level]);
}

float level_spacing_m(const scene::ProbeVolume& volume, uint32_t level) {
    return volume.spacing_m * static_cast<float>(volume.strides[level]);
}

}  // namespace

ProbeTables probe_tables(const scene::ProbeVolume& volume) {
    ProbeTables tables;
    std::vector<scene::ProbeCell> cells = scene::cells_of(volume);
    std::erase_if(cells, [](const scene::ProbeCell& cell) { return cell.level >= shared::kMostProbeLevels; });
    std::vector<uint32_t> numbers(volume.probes.size(), shared::kNoProbe);
    for (size_t i = 0; i < volume.probes.size(); ++i) {
        const scene::Probe& probe = volume.probes[i];
        if (probe.state == scene::ProbeState::dropped) continue;
        numbers[i] = static_cast<uint32_t>(tables.points.size());
        tables.points.push_back({scene::position_of(volume, probe), level_spacing_m(volume, probe.level)});
    }
    for (const scene::ProbeCell& cell : cells)
        for (uint32_t i = 0; i < cell.corners.size(); ++i) {
            const uint32_t corner = cell.corners[i];
            // A cell may use a probe at another grid point instead of a probe at its corner. Then the cell
            // does not change the spacing of that probe.
            if (corner == scene::ProbeCell::kNoProbe ||
                volume.probes[corner].at != corner_at(cell, i, volume))
                continue;
            float& spacing_m = tables.points[numbers[corner]].spacing_m;
            spacing_m = std::min(spacing_m, level_spacing_m(volume, cell.level));
        }
    tables.cells = hash_cells(cells, volume, numbers);
    tables.grid.origin = volume.origin;
    tables.grid.half_yaw_tangent = std::tan(glm::radians(volume.yaw_deg) / 2);
    tables.grid.spacing_m = volume.spacing_m;
    tables.grid.levels = static_cast<uint32_t>(
        cells.empty() ? 0 : std::min<size_t>(volume.strides.size(), shared::kMostProbeLevels));
    tables.grid.slots = static_cast<uint32_t>(tables.cells.size());
    tables.grid.probes = static_cast<uint32_t>(tables.points.size());
    for (uint32_t level = 0; level < tables.grid.levels; ++level)
        tables.grid.strides[level / 4][static_cast<int>(level % 4)] = volume.strides[level];
    return tables;
}

ReflectionTables reflection_tables(const std::vector<scene::ReflectionProbe>& probes) {
    ReflectionTables tables;
    for (const scene::ReflectionProbe& probe : probes) {
        tables.points.push_back({probe.position, 0});
        shared::ReflectionBox& box = tables.boxes.emplace_back();
        if (!probe.box) continue;
        // The matrix from world space to the box, where the box reaches from -1 to 1 on each axis. It is the
        // inverse of this order of steps: scale, rotate, move to the centre.
        const glm::mat3 rows = glm::mat3_cast(probe.box->rotation);
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 axis = rows[i] / probe.box->half_size_m[i];
            box.to_box[static_cast<size_t>(i)] = glm::vec4(axis, -glm::dot(axis, probe.box->center));
        }
    }
    return tables;
}

uint32_t count_probes(const scene::ProbeVolume& volume) {
    return static_cast<uint32_t>(volume.probes.size()) - scene::count_of(volume, scene::ProbeState::dropped);
}

uint32_t slots_for(size_t cells) {
    return std::bit_ceil(static_cast<uint32_t>(std::max<size_t>(1, 2 * cells)));
}

std::vector<shared::ViewConstants> probe_face_views(const std::vector<shared::ProbePoint>& points) {
    std::vector<shared::ViewConstants> views;
    views.reserve(points.size() * kCubeFaces);
    for (const shared::ProbePoint& point : points)
        for (uint32_t face = 0; face < kCubeFaces; ++face)
            views.push_back(constants_of(cube_face(glm::dvec3(point.position), face, kProbeNear_m)));
    return views;
}

}  // namespace weft::render
