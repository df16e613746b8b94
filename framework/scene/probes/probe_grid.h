// Purpose: the grid on which the probes of a scene are placed. It stores which grid points have a probe, and
// finds the cells that are near a surface.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "scene/probes/cell_view.h"
#include "scene/probes/settle_probe.h"

namespace weft::scene {

// Orders grid points by z, then y, then x.
struct PointOrder {
    bool operator()(const glm::ivec3& a, const glm::ivec3& b) const;
};

// A cube of the grid. `at` is its corner with the smallest coordinates, and `stride` is the length of its
// sides. Both are multiples of the smallest spacing of the grid.
struct GridCell {
    glm::ivec3 at{0};
    int stride = 1;
};

[[nodiscard]] glm::ivec3 corner_of(const GridCell& cell, int corner);

class ProbeGrid {
 public:
    // `top` is the largest stride of a cell: the length of its sides, divided by `spacing_m`.
    ProbeGrid(const TriangleTree& tree, glm::vec3 origin, float spacing_m, int top, uint32_t threads);

    // Removes all cells. From now on, a minor probe counts as `minor_eighths` eighths of a probe; see
    // Surroundings::is_minor.
    void clear(uint32_t minor_eighths);

    // Returns the cells of this stride near the front of a surface, in the order of their points. Returns
    // nullopt if there are more than `most`.
    [[nodiscard]] std::optional<std::vector<GridCell>> cells_near_surfaces(int stride, size_t most) const;
    [[nodiscard]] bool is_near_surface(const GridCell& cell) const;
    // Splits the cell into eight cells of half the stride. Returns those that are near a surface.
    [[nodiscard]] std::vector<GridCell> parts_of(const GridCell& cell) const;
    [[nodiscard]] bool is_uneven(const GridCell& cell) const;
    // Divides the cell into parts with the stride `pitch`. Calls room_size_at() for the middle of each part
    // that is near a surface: the smallest dimension of the room around this middle. Returns the smallest of
    // these results; infinity if none of the middles is in a room.
    [[nodiscard]] double room_size(const GridCell& cell, int pitch) const;
    // True if the cell has a free place in front of a surface that no probe at a corner of the cell sees.
    // exchange() must have added the cell before.
    [[nodiscard]] bool has_dark_place(const GridCell& cell) const;

    // Returns the mean of Surroundings::nearness_per_m of the probes that see a surface of the cell. Returns
    // 0 if all these probes are minor (Surroundings::is_minor). exchange() must have added the cell before.
    [[nodiscard]] double nearness_per_m(const GridCell& cell) const;

    // Removes the cells `gone`, which were added before, and adds the cells `fresh`. If the corners of all
    // cells would then have more than `most` probes, changes nothing and returns false.
    bool exchange(const std::vector<GridCell>& gone, const std::vector<GridCell>& fresh, uint32_t most);
    // Returns the number of grid points for which settle_probe() has looked for a place.
    [[nodiscard]] size_t examined() const { return points_.size(); }
    // Returns the volume, the finished grid with its probes. ProbeVolume::around_camera becomes
    // `around_camera`.
    [[nodiscard]] ProbeVolume volume(std::vector<uint32_t> strides, bool around_camera) const;

    [[nodiscard]] glm::vec3 position(const glm::ivec3& at) const {
        return origin_ + glm::vec3(at) * spacing_m_;
    }

 private:
    struct Point {
        Settled settled;
        uint32_t uses = 0;    // Number of cells that have this corner.
        uint32_t useful = 0;  // Number of these cells in which the probe sees a surface.
    };
    using CellKey = std::array<int, 4>;

    [[nodiscard]] Bounds box_of(const GridCell& cell, float margin_m) const;
    [[nodiscard]] int coarsest_stride(const glm::ivec3& at) const;
    void count_cell(const GridCell& cell, int change);
    void examine(std::span<const GridCell> cells);
    void settle(const std::vector<glm::ivec3>& points);
    [[nodiscard]] CellView view_of(const GridCell& cell) const;

    const TriangleTree& tree_;
    glm::vec3 origin_;
    float spacing_m_;
    int top_;
    uint32_t threads_;
    std::map<glm::ivec3, Point, PointOrder> points_;
    std::map<CellKey, CellView> views_;
    uint32_t minor_eighths_ = 8;
    // Eighths of a probe, summed over the probes at the corners of all cells; see clear().
    uint64_t eighths_ = 0;
};

// Returns the volume with one entry for each point of a grid of this size. settle_probe() keeps, moves or
// drops the probe of each point.
[[nodiscard]] ProbeVolume settled_grid(const TriangleTree& tree, const ProbeVolume& volume, glm::ivec3 size,
                                       uint32_t threads);

}  // namespace weft::scene
