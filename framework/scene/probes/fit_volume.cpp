// Chooses a grid for a whole scene. The grid begins with coarse cells near all surfaces. Then the following
// steps split cells into eight. Where possible, a step splits all cells of one kind together, so that similar
// places have similar spacings:
// 1. Single cells with a free place that no probe of the cell sees.
// 2. All cells in rooms whose smallest dimension is less than four spacings of the cell, until the spacing is
// small enough for objects.
// 3. All cells in the open whose surfaces are not parallel, until the spacing is twice that of step 2.
// 4. All cells in rooms that still need a smaller spacing, until the spacing is the smallest one of the grid.
// 5. Single cells that still need a smaller spacing, because all cells of their kind together needed too many
// probes. The cells with the greatest need are split first.
// 6. With the probes that are left: all cells of one size, first the cells whose surfaces are not parallel.
// 7. Single cells with objects, if the spacing of the cell is more than a quarter of the distance of the
// surfaces around it.
#include <algorithm>
#include <array>
#include <functional>
#include <queue>

#include "scene/probes/refine_grid.h"
#include "scene/probes/share_minor_probes.h"

namespace weft::scene {
namespace {

// If the grid of a whole scene would begin with more cells than this, it begins with larger cells.
constexpr size_t kMostCells = 600;
// Splitting ends when this many grid points were examined.
constexpr size_t kMostExamined = 4096;
// A cell is not split if its parts need too many probes. After this many such cells, split_worst() ends.
constexpr uint32_t kMostFailures = 32;
// Several minor grid points (where few probes are enough) can share a probe. At first, each minor grid point
// counts as one eighth of a probe. If the volume then has too many probes, the fit is repeated with the next
// number of eighths. With the last number, a minor grid point counts as a whole probe, so the volume cannot
// have too many probes.
constexpr std::array<uint32_t, 6> kMinorEighths{1, 2, 3, 4, 6, 8};

class Fit {
 public:
    Fit(ProbeGrid& grid, const PlacementParams& params, int base)
        : grid_(grid), params_(params), base_(base) {}

    // Adds all cells near surfaces that have the stride base_. Returns false if there are too many of these
    // cells, or if they need more than three quarters of the permitted probes.
    [[nodiscard]] bool begin() {
        std::optional<std::vector<GridCell>> cells = grid_.cells_near_surfaces(base_, kMostCells);
        if (!cells || !grid_.exchange({}, *cells, params_.most_probes * 3 / 4)) return false;
        cells_ = std::move(*cells);
        return true;
    }

    void refine() {
        split_worst([&](const GridCell& cell) { return grid_.has_dark_place(cell) ? cell.stride : 0; });
        for (int stride = base_; stride > kObjectStride; stride /= 2) (void)split_all(rooms(stride));
        for (int stride = base_; stride > 2 * kObjectStride; stride /= 2)
            (void)split_all(uneven_cells(stride));
        for (int stride = kObjectStride; stride > 1; stride /= 2) (void)split_all(rooms(stride));
        split_worst([&](const GridCell& cell) { return std::max(room_need(cell), object_need(cell)); });
        for (int stride = base_; stride > 1; stride /= 2)
            if (!split_all(uneven_cells(stride)) || !split_all(cells_of_stride(stride))) break;
        split_worst([&](const GridCell& cell) {
            return has_objects(cell) ? need_in(cell, 1 / grid_.nearness_per_m(cell)) : 0;
        });
    }

    [[nodiscard]] ProbeVolume volume() const {
        int finest = base_, coarsest = 1;
        for (const GridCell& cell : cells_) {
            finest = std::min(finest, cell.stride);
            coarsest = std::max(coarsest, cell.stride);
        }
        std::vector<uint32_t> strides;
        for (int stride = finest; stride <= std::max(finest, coarsest); stride *= 2)
            strides.push_back(static_cast<uint32_t>(stride));
        return grid_.volume(strides, false);
    }

 private:
    [[nodiscard]] std::vector<GridCell> cells_of_stride(int stride) const {
        std::vector<GridCell> found;
        for (const GridCell& cell : cells_)
            if (cell.stride == stride) found.push_back(cell);
        std::ranges::sort(found, PointOrder{}, &GridCell::at);
        return found;
    }

    // True if the surfaces of the cell are not parallel, and if one of them is visible from a probe that is
    // not minor. Probes that see much of the sky are minor. So the edge of a roof with only the sky around it
    // does not count as an object.
    [[nodiscard]] bool has_objects(const GridCell& cell) const {
        return grid_.nearness_per_m(cell) > 0 && grid_.is_uneven(cell);
    }

    [[nodiscard]] std::vector<GridCell> uneven_cells(int stride) const {
        std::vector<GridCell> found = cells_of_stride(stride);
        std::erase_if(found, [&](const GridCell& cell) { return !has_objects(cell); });
        return found;
    }

    // Replaces each of the cells by its parts (cells of half the size) if there are enough probes for all
    // parts. Adds the parts to `parts`.
    bool split(const std::vector<GridCell>& cells, std::vector<GridCell>& parts) {
        if (grid_.examined() > kMostExamined) return false;
        for (const GridCell& cell : cells) {
            const std::vector<GridCell> some = grid_.parts_of(cell);
            parts.insert(parts.end(), some.begin(), some.end());
        }
        if (!grid_.exchange(cells, parts, params_.most_probes)) return false;
        std::erase_if(cells_, [&](const GridCell& cell) {
            return std::ranges::any_of(cells, [&](const GridCell& gone) {
                return gone.at == cell.at && gone.stride == cell.stride;
            });
        });
        cells_.insert(cells_.end(), parts.begin(), parts.end());
        return true;
    }

    bool split_all(const std::vector<GridCell>& cells) {
        std::vector<GridCell> parts;
        return split(cells, parts);
    }

    struct Need {
        double need = 0;
        GridCell cell;
        // std::priority_queue returns the largest element in this order first. So the cell with the largest
        // `need` is split first.
        bool operator<(const Need& other) const {
            if (need != other.need) return need < other.need;
            return PointOrder{}(other.cell.at, cell.at);
        }
    };

    // Returns the spacing of the cell divided by the largest spacing that suits a room of this size.
    [[nodiscard]] double need_in(const GridCell& cell, double room_m) const {
        // The spacing in a room is at most the smallest dimension of the room divided by this number.
        constexpr double kSpacingsPerRoom = 4;
        return kSpacingsPerRoom * double{params_.min_spacing_m} * cell.stride / room_m;
    }

    [[nodiscard]] double room_need(const GridCell& cell) const {
        // A gap between surfaces that is smaller than this counts as a room of this size. Unit: the smallest
        // spacing of the grid.
        constexpr double kSmallestRoom = 4;
        const int pitch = std::min(cell.stride / 2, kObjectStride);
        return need_in(cell,
                       std::max(grid_.room_size(cell, pitch), kSmallestRoom * double{params_.min_spacing_m}));
    }

    [[nodiscard]] double object_need(const GridCell& cell) const {
        if (cell.stride <= kObjectStride || !has_objects(cell)) return 0;
        // Cells with objects in the open are split as if they were in a room of this size. Unit: the smallest
        // spacing of the grid.
        constexpr double kObjectRoom = 8;
        return need_in(cell, kObjectRoom * double{params_.min_spacing_m});
    }

    [[nodiscard]] std::vector<GridCell> rooms(int stride) const {
        std::vector<GridCell> found = cells_of_stride(stride);
        std::erase_if(found, [&](const GridCell& cell) { return room_need(cell) <= 1; });
        return found;
    }

    // Splits all cells for which need_of() is above 1, the cell with the greatest need first. The parts of a
    // split cell are treated in the same way.
    void split_worst(const std::function<double(const GridCell&)>& need_of) {
        std::priority_queue<Need> needs;
        const auto consider = [&](const GridCell& cell) {
            const double need = cell.stride > 1 ? need_of(cell) : 0;
            if (need > 1) needs.push({need, cell});
        };
        for (const GridCell& cell : cells_) consider(cell);
        uint32_t failures = 0;
        while (!needs.empty() && failures < kMostFailures) {
            const GridCell cell = needs.top().cell;
            needs.pop();
            std::vector<GridCell> parts;
            if (split({cell}, parts))
                for (const GridCell& part : parts) consider(part);
            else
                ++failures;
        }
    }

    ProbeGrid& grid_;
    const PlacementParams& params_;
    int base_;
    std::vector<GridCell> cells_;
};

}  // namespace

std::optional<ProbeVolume> fit_volume(const TriangleTree& tree, const PlacementParams& params,
                                      uint32_t threads) {
    const glm::vec3 size = tree.bounds().max - tree.bounds().min;
    const float half_size = 0.5f * std::max({size.x, size.y, size.z}) / params.min_spacing_m;
    int base = kObjectStride;
    while (base < kGroundStride && static_cast<float>(base) < half_size) base *= 2;
    for (; base <= kGroundStride; base *= 2) {
        ProbeGrid grid(tree, glm::vec3(0.5f * params.min_spacing_m), params.min_spacing_m, base, threads);
        for (const uint32_t minor_eighths : kMinorEighths) {
            grid.clear(minor_eighths);
            Fit fit(grid, params, base);
            if (!fit.begin()) break;
            fit.refine();
            ProbeVolume volume = fit.volume();
            if (share_minor_probes(tree, volume, params.most_probes, threads) <= params.most_probes)
                return volume;
        }
    }
    return std::nullopt;
}

}  // namespace weft::scene
