// Chooses a grid for a whole scene. It begins with the finest cells near all surfaces that need at most half
// of the probes. Then it splits cells into eight, in two steps:
// 1. One by one, the worst first: cells in rooms whose smallest dimension is less than four spacings, and
//    cells whose surfaces are not parallel, until their spacing fits objects.
// 2. With the probes that are left: all cells of a level, first those whose surfaces are not parallel.
#include <algorithm>
#include <queue>

#include "scene/probes/refine_grid.h"

namespace weft::scene {
namespace {

// More cells than this are too many for the grid of a whole scene.
constexpr size_t kMostCells = 600;
// Splitting ends when this many grid points were examined.
constexpr size_t kMostExamined = 4096;
// The spacing in a room is at most its smallest dimension divided by this.
constexpr double kSpacingsPerRoom = 4;
// Smaller gaps between surfaces count as rooms of this size, in finest spacings.
constexpr double kSmallestRoom = 4;
// Objects in the open need as many probes as a room of this size, in finest spacings.
constexpr double kObjectRoom = 8;
// Cells that need too many probes are left out, until there are this many of them.
constexpr uint32_t kMostFailures = 8;

class Fit {
 public:
    Fit(const TriangleTree& tree, const PlacementParams& params, int base, uint32_t threads)
        : grid_(tree, glm::vec3(0.5f * params.min_spacing_m), params.min_spacing_m, base, threads),
          params_(params),
          base_(base) {}

    // Adds the cells of the base. Returns false if they are too many.
    [[nodiscard]] bool begin() {
        std::optional<std::vector<GridCell>> cells = grid_.cells_near_surfaces(base_, kMostCells);
        if (!cells || !grid_.exchange({}, *cells, params_.most_probes / 2)) return false;
        cells_ = std::move(*cells);
        return true;
    }

    void refine() {
        split_worst();
        for (int stride = base_; stride > 1; stride /= 2)
            if (!split_all(uneven_cells(stride)) || !split_all(cells_of_stride(stride))) break;
    }

    [[nodiscard]] ProbeVolume volume() const {
        std::vector<uint32_t> strides;
        for (int stride = finest_; stride <= base_; stride *= 2)
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

    [[nodiscard]] std::vector<GridCell> uneven_cells(int stride) const {
        std::vector<GridCell> found = cells_of_stride(stride);
        std::erase_if(found, [&](const GridCell& cell) { return !grid_.is_uneven(cell); });
        return found;
    }

    // Replaces the cells by their parts, if there are enough probes for all of them. Adds the parts to
    // `parts`.
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
        if (!parts.empty()) finest_ = std::min(finest_, parts.front().stride);
        return true;
    }

    bool split_all(const std::vector<GridCell>& cells) {
        std::vector<GridCell> parts;
        return split(cells, parts);
    }

    struct Need {
        double factor = 0;  // The spacing of the cell, divided by the largest one that the place allows.
        GridCell cell;
        // The cell that is split first is the largest.
        bool operator<(const Need& other) const {
            if (factor != other.factor) return factor < other.factor;
            return PointOrder{}(other.cell.at, cell.at);
        }
    };

    // Returns how much too large the spacing of the cell is, as a factor.
    [[nodiscard]] double need_of(const GridCell& cell) {
        double room_m = std::max(grid_.room_size(cell), kSmallestRoom * double{params_.min_spacing_m});
        if (cell.stride > kObjectStride && grid_.is_uneven(cell))
            room_m = std::min(room_m, kObjectRoom * double{params_.min_spacing_m});
        return kSpacingsPerRoom * double{params_.min_spacing_m} * cell.stride / room_m;
    }

    void split_worst() {
        std::priority_queue<Need> needs;
        const auto consider = [&](const GridCell& cell) {
            const double factor = cell.stride > 1 ? need_of(cell) : 0;
            if (factor > 1) needs.push({factor, cell});
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

    ProbeGrid grid_;
    const PlacementParams& params_;
    int base_;
    int finest_ = base_;
    std::vector<GridCell> cells_;
};

}  // namespace

std::optional<ProbeVolume> fit_volume(const TriangleTree& tree, const PlacementParams& params,
                                      uint32_t threads) {
    for (int base = kObjectStride; base <= kGroundStride; base *= 2) {
        Fit fit(tree, params, base, threads);
        if (!fit.begin()) continue;
        fit.refine();
        return fit.volume();
    }
    return std::nullopt;
}

}  // namespace weft::scene
