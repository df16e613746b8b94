#include "scene/probes/probe_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/loading/worker_threads.h"

namespace weft::scene {
namespace {

// A probe that is not minor counts as eight eighths of a probe; see clear().
constexpr uint32_t kEighths = 8;
// A cell is used if it contains a surface, or if it is in front of a surface at a distance of at most this
// share of the side of the cell.
constexpr float kMargin = 0.25f;
// The smallest distance between a probe and a surface. Unit: the smallest spacing of the grid.
constexpr float kClearance = 0.1f;

glm::ivec3 part_offset(int corner) {
    return {corner & 1, corner >> 1 & 1, corner >> 2 & 1};
}

// Rounds down to a multiple of `stride`.
int floor_to(double value, int stride) {
    return static_cast<int>(std::floor(value / stride)) * stride;
}

}  // namespace

bool PointOrder::operator()(const glm::ivec3& a, const glm::ivec3& b) const {
    if (a.z != b.z) return a.z < b.z;
    if (a.y != b.y) return a.y < b.y;
    return a.x < b.x;
}

glm::ivec3 corner_of(const GridCell& cell, int corner) {
    return cell.at + part_offset(corner) * cell.stride;
}

ProbeGrid::ProbeGrid(const TriangleTree& tree, glm::vec3 origin, float spacing_m, int top, uint32_t threads)
    : tree_(tree), origin_(origin), spacing_m_(spacing_m), top_(top), threads_(threads) {}

Bounds ProbeGrid::box_of(const GridCell& cell, float margin_m) const {
    return {position(cell.at) - glm::vec3(margin_m),
            position(cell.at + glm::ivec3(cell.stride)) + glm::vec3(margin_m)};
}

bool ProbeGrid::is_near_surface(const GridCell& cell) const {
    return tree_.touches_front(box_of(cell, 0), kMargin * spacing_m_ * static_cast<float>(cell.stride));
}

std::optional<std::vector<GridCell>> ProbeGrid::cells_near_surfaces(int stride, size_t most) const {
    if (tree_.empty()) return std::vector<GridCell>{};
    const float margin_m = kMargin * spacing_m_ * static_cast<float>(stride);
    const glm::vec3 low = (tree_.bounds().min - margin_m - origin_) / spacing_m_;
    const glm::vec3 high = (tree_.bounds().max + margin_m - origin_) / spacing_m_;
    const glm::vec3 size = high - low;
    int root = stride;
    while (static_cast<float>(root) < std::max({size.x, size.y, size.z})) root *= 2;
    std::vector<GridCell> open, found;
    for (int z = floor_to(low.z, root); z <= floor_to(high.z, root); z += root)
        for (int y = floor_to(low.y, root); y <= floor_to(high.y, root); y += root)
            for (int x = floor_to(low.x, root); x <= floor_to(high.x, root); x += root)
                open.push_back({{x, y, z}, root});
    while (!open.empty()) {
        const GridCell cell = open.back();
        open.pop_back();
        if (!tree_.touches(box_of(cell, margin_m))) continue;
        if (cell.stride == stride) {
            if (!is_near_surface(cell)) continue;
            found.push_back(cell);
            if (found.size() > most) return std::nullopt;
            continue;
        }
        for (int part = 0; part < 8; ++part)
            open.push_back({cell.at + part_offset(part) * (cell.stride / 2), cell.stride / 2});
    }
    std::ranges::sort(found, PointOrder{}, &GridCell::at);
    return found;
}

std::vector<GridCell> ProbeGrid::parts_of(const GridCell& cell) const {
    std::vector<GridCell> parts;
    for (int part = 0; part < 8; ++part) {
        const GridCell half{cell.at + part_offset(part) * (cell.stride / 2), cell.stride / 2};
        if (is_near_surface(half)) parts.push_back(half);
    }
    return parts;
}

bool ProbeGrid::is_uneven(const GridCell& cell) const {
    return tree_.is_uneven(box_of(cell, 0));
}

double ProbeGrid::room_size(const GridCell& cell, int pitch) const {
    double least = std::numeric_limits<double>::infinity();
    const int parts = cell.stride / pitch;
    for (int z = 0; z < parts; ++z)
        for (int y = 0; y < parts; ++y)
            for (int x = 0; x < parts; ++x) {
                const GridCell part{cell.at + glm::ivec3(x, y, z) * pitch, pitch};
                const glm::vec3 middle = position(part.at) + 0.5f * spacing_m_ * static_cast<float>(pitch);
                if (is_near_surface(part)) least = std::min(least, room_size_at(tree_, middle));
            }
    return least;
}

bool ProbeGrid::has_dark_place(const GridCell& cell) const {
    return views_.at({cell.at.x, cell.at.y, cell.at.z, cell.stride}).has_dark_place;
}

double ProbeGrid::nearness_per_m(const GridCell& cell) const {
    const CellView& view = views_.at({cell.at.x, cell.at.y, cell.at.z, cell.stride});
    double sum = 0;
    int probes = 0;
    bool all_minor = true;
    for (int corner = 0; corner < 8; ++corner) {
        if ((view.useful >> corner & 1) == 0) continue;
        const Surroundings& around = points_.at(corner_of(cell, corner)).settled.around;
        sum += around.nearness_per_m;
        ++probes;
        all_minor = all_minor && around.is_minor;
    }
    return all_minor ? 0 : sum / probes;
}

int ProbeGrid::coarsest_stride(const glm::ivec3& at) const {
    int stride = top_;
    while (stride > 1 && ((at.x | at.y | at.z) & (stride - 1)) != 0) stride /= 2;
    return stride;
}

// Decides for each of these points whether it has a probe, and at which place. Stores the results. The caller
// passes only points that have no result yet.
void ProbeGrid::settle(const std::vector<glm::ivec3>& points) {
    // A grid point has no probe if no surface touches a cube around the point. Half of the side of this cube
    // is the side of the largest cell that can have this point as a corner, but at least kFar times the
    // smallest spacing of the grid.
    constexpr float kFar = 5;
    std::vector<Settled> settled(points.size());
    run_on_threads(points.size(), threads_, [&](size_t i) {
        const float spacing_m = spacing_m_ * static_cast<float>(coarsest_stride(points[i]));
        const float far_m = std::max(spacing_m, kFar * spacing_m_);
        const glm::vec3 place = position(points[i]);
        if (tree_.touches({place - far_m, place + far_m}))
            settled[i] = settle_probe(tree_, place, {kClearance * spacing_m_, kMostOffset * spacing_m});
        else
            settled[i].state = ProbeState::dropped;
    });
    for (size_t i = 0; i < points.size(); ++i) points_[points[i]].settled = settled[i];
}

CellView ProbeGrid::view_of(const GridCell& cell) const {
    const float size_m = spacing_m_ * static_cast<float>(cell.stride);
    std::array<std::optional<glm::vec3>, 8> probes;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 at = corner_of(cell, corner);
        const Settled& settled = points_.at(at).settled;
        if (settled.state != ProbeState::dropped && glm::length(settled.offset) <= kMostOffset * size_m)
            probes[static_cast<size_t>(corner)] = position(at) + settled.offset;
    }
    // Places at this distance in front of a surface must be visible from a probe. Unit: the smallest spacing
    // of the grid.
    constexpr float kClose = 0.2f;
    return view_of_cell(tree_, box_of(cell, 0), probes,
                        {kClose * spacing_m_, kMargin * size_m, kClearance * spacing_m_});
}

// Calls settle() for the corners of the cells. Then finds out which surfaces of a cell the probes at its
// corners see. Skips corners and cells whose result is already known.
void ProbeGrid::examine(std::span<const GridCell> cells) {
    std::set<glm::ivec3, PointOrder> unknown;
    for (const GridCell& cell : cells)
        for (int corner = 0; corner < 8; ++corner)
            if (const glm::ivec3 at = corner_of(cell, corner); !points_.contains(at)) unknown.insert(at);
    settle({unknown.begin(), unknown.end()});
    std::vector<GridCell> fresh;
    for (const GridCell& cell : cells)
        if (!views_.contains({cell.at.x, cell.at.y, cell.at.z, cell.stride})) fresh.push_back(cell);
    std::vector<CellView> views(fresh.size());
    run_on_threads(fresh.size(), threads_, [&](size_t i) { views[i] = view_of(fresh[i]); });
    for (size_t i = 0; i < fresh.size(); ++i)
        views_[{fresh[i].at.x, fresh[i].at.y, fresh[i].at.z, fresh[i].stride}] = views[i];
}

void ProbeGrid::count_cell(const GridCell& cell, int change) {
    const CellView& view = views_.at({cell.at.x, cell.at.y, cell.at.z, cell.stride});
    for (int corner = 0; corner < 8; ++corner) {
        Point& point = points_.at(corner_of(cell, corner));
        const bool useful = (view.useful >> corner & 1) != 0;
        const uint32_t cost = point.settled.around.is_minor ? minor_eighths_ : kEighths;
        if (change > 0) {
            ++point.uses;
            if (useful && point.useful++ == 0) eighths_ += cost;
        } else {
            --point.uses;
            if (useful && --point.useful == 0) eighths_ -= cost;
        }
    }
}

void ProbeGrid::clear(uint32_t minor_eighths) {
    for (auto& [at, point] : points_) point.uses = point.useful = 0;
    eighths_ = 0;
    minor_eighths_ = minor_eighths;
}

bool ProbeGrid::exchange(const std::vector<GridCell>& gone, const std::vector<GridCell>& fresh,
                         uint32_t most) {
    // Number of cells that are examined together, in parallel. After each such batch, the number of probes is
    // compared with the limit.
    constexpr size_t kBatch = 32;
    const uint64_t limit = uint64_t{kEighths} * most;
    for (const GridCell& cell : gone) count_cell(cell, -1);
    size_t used = 0;
    while (used < fresh.size() && eighths_ <= limit) {
        const size_t end = std::min(used + kBatch, fresh.size());
        examine(std::span(fresh).subspan(used, end - used));
        for (; used < end; ++used) count_cell(fresh[used], 1);
    }
    if (eighths_ <= limit) return true;
    for (size_t i = 0; i < used; ++i) count_cell(fresh[i], -1);
    for (const GridCell& cell : gone) count_cell(cell, 1);
    return false;
}

ProbeVolume ProbeGrid::volume(std::vector<uint32_t> strides, bool around_camera) const {
    ProbeVolume volume{origin_, spacing_m_, std::move(strides), {}, around_camera};
    for (const auto& [at, point] : points_) {
        if (point.uses == 0) continue;
        uint32_t level = 0;
        for (uint32_t i = 0; i < volume.strides.size(); ++i) {
            const int stride = static_cast<int>(volume.strides[i]);
            if (at.x % stride == 0 && at.y % stride == 0 && at.z % stride == 0) level = i;
        }
        Probe probe{at, level, glm::vec3(0), ProbeState::dropped, std::nullopt};
        if (point.useful > 0) {
            probe.state = point.settled.state;
            probe.offset = point.settled.offset;
        }
        volume.probes.push_back(probe);
    }
    return volume;
}

ProbeVolume settled_grid(const TriangleTree& tree, const ProbeVolume& volume, glm::ivec3 size,
                         uint32_t threads) {
    ProbeVolume out = volume;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                out.probes.push_back({{x, y, z}, 0, glm::vec3(0), ProbeState::kept, std::nullopt});
    const SettleLimits limits{kClearance * volume.spacing_m, kMostOffset * volume.spacing_m};
    run_on_threads(out.probes.size(), threads, [&](size_t i) {
        const Settled settled = settle_probe(tree, position_of(out, out.probes[i]), limits);
        out.probes[i].state = settled.state;
        out.probes[i].offset = settled.offset;
    });
    return out;
}

}  // namespace weft::scene
