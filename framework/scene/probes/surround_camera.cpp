// Places three nested levels of probes around a camera. Each level gets a third of the probes, and has the
// cells near surfaces that are nearest to the camera. The grid stands still when the camera moves, and the
// place of the camera is rounded to a cell of each level. So most probes stay the same when the camera moves.
#include <algorithm>

#include "scene/probes/refine_grid.h"

namespace weft::scene {
namespace {

constexpr int kLevels = 3;
// The largest distance between a cell and the cell of the camera along each axis, in cells.
constexpr int kReach = 10;
constexpr double kSpacingsPerSide = 4;

// Returns the cell of this stride that contains the place.
GridCell cell_at(const glm::vec3& place, const glm::vec3& origin, const PlacementParams& params, int stride) {
    const glm::vec3 at = (place - origin) / params.min_spacing_m;
    const glm::ivec3 cell(glm::floor(at / static_cast<float>(stride)));
    return {cell * stride, stride};
}

// Returns the cells near surfaces around the camera, the nearest first.
std::vector<GridCell> cells_around(const ProbeGrid& grid, const GridCell& middle) {
    struct Near {
        int squared_distance;
        GridCell cell;
    };
    std::vector<Near> found;
    for (int z = -kReach; z <= kReach; ++z)
        for (int y = -kReach; y <= kReach; ++y)
            for (int x = -kReach; x <= kReach; ++x) {
                const GridCell cell{middle.at + glm::ivec3(x, y, z) * middle.stride, middle.stride};
                if (grid.is_near_surface(cell)) found.push_back({x * x + y * y + z * z, cell});
            }
    std::ranges::stable_sort(found, {}, &Near::squared_distance);
    std::vector<GridCell> cells;
    for (const Near& near : found) cells.push_back(near.cell);
    return cells;
}

// Returns the stride of the finest level: kObjectStride, or less if the camera is in a small room.
int finest_stride(const ProbeGrid& grid, const glm::vec3& origin, const PlacementParams& params) {
    const double room_m =
        grid.room_size(cell_at(*params.camera, origin, params, kObjectStride), kObjectStride / 2);
    int stride = kObjectStride;
    while (stride > 1 && double{params.min_spacing_m} * stride * kSpacingsPerSide > room_m) stride /= 2;
    return stride;
}

}  // namespace

ProbeVolume surround_camera(const TriangleTree& tree, const glm::vec3& origin, const PlacementParams& params,
                            uint32_t threads) {
    PlacementParams around = params;
    const Bounds& bounds = tree.bounds();
    // If the camera is outside of the scene's bounds, the probes surround the nearest point of the bounds.
    // From far away, the camera sees this part of the scene best.
    around.camera =
        glm::clamp(params.camera.value_or((bounds.min + bounds.max) * 0.5f), bounds.min, bounds.max);
    const uint32_t share = params.most_probes / kLevels;
    // If three levels whose spacings differ by a factor of 2 are enough for the whole scene, the factor is 2.
    // Otherwise it is 4.
    const ProbeGrid probe(tree, origin, params.min_spacing_m, kGroundStride, threads);
    const int finest = finest_stride(probe, origin, around);
    const int factor = probe.cells_near_surfaces(finest * 4, share) ? 2 : 4;
    std::vector<uint32_t> strides;
    for (int level = 0, stride = finest; level < kLevels; ++level, stride *= factor)
        strides.push_back(static_cast<uint32_t>(stride));
    const int top = static_cast<int>(strides.back());
    ProbeGrid grid(tree, origin, params.min_spacing_m, top, threads);
    for (uint32_t level = kLevels; level-- > 0;) {
        const uint32_t most = params.most_probes - share * level;
        const GridCell middle = cell_at(*around.camera, origin, params, static_cast<int>(strides[level]));
        for (const GridCell& cell : cells_around(grid, middle)) {
            if (grid.examined() > kMostGridPoints / 2 || !grid.exchange({}, {cell}, most)) break;
        }
    }
    return grid.volume(strides, true);
}

}  // namespace weft::scene
