#include "scene/probes/probe_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/loading/worker_threads.h"

namespace weft::scene {
namespace {

// Corners that are settled together, in parallel, before the number of probes is compared with the limit.
constexpr size_t kBatch = 256;
// A surface counts for the cells that are at most this far away, in spacings of the cell.
constexpr float kMargin = 0.25f;
// Number of places along each axis of a cell at which it is checked that they see a probe.
constexpr int kSamples = 4;
// A grid point has no probe if the nearest surface is farther than one spacing along each axis and farther
// than this, in finest spacings.
constexpr float kFar = 5;
// The smallest distance between a probe and a surface, in finest spacings.
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
    return tree_.touches(box_of(cell, kMargin * spacing_m_ * static_cast<float>(cell.stride)));
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
    const float size_m = spacing_m_ * static_cast<float>(cell.stride);
    std::vector<glm::vec3> probes;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 at = corner_of(cell, corner);
        const Settled& settled = points_.at(at).settled;
        if (settled.state != ProbeState::dropped && glm::length(settled.offset) <= kMostOffset * size_m)
            probes.push_back(position(at) + settled.offset);
    }
    for (int i = 0; i < kSamples * kSamples * kSamples; ++i) {
        const glm::vec3 at(i % kSamples, i / kSamples % kSamples, i / (kSamples * kSamples));
        const glm::vec3 place = position(cell.at) + (at + 0.5f) / static_cast<float>(kSamples) * size_m;
        const bool seen =
            std::ranges::any_of(probes, [&](const glm::vec3& probe) { return sees(tree_, place, probe); });
        if (!seen && can_stand(tree_, place, kClearance * spacing_m_)) return true;
    }
    return false;
}

int ProbeGrid::coarsest_stride(const glm::ivec3& at) const {
    int stride = top_;
    while (stride > 1 && ((at.x | at.y | at.z) & (stride - 1)) != 0) stride /= 2;
    return stride;
}

// Settles points that are not known yet.
void ProbeGrid::settle(const std::vector<glm::ivec3>& points) {
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

void ProbeGrid::count_use(const glm::ivec3& at, int change) {
    Point& point = points_[at];
    const bool counts = point.settled.state != ProbeState::dropped;
    if (change > 0 && point.uses++ == 0 && counts) ++probes_;
    if (change < 0 && --point.uses == 0 && counts) --probes_;
}

bool ProbeGrid::exchange(const std::vector<GridCell>& gone, const std::vector<GridCell>& fresh,
                         uint32_t most) {
    std::vector<glm::ivec3> corners;
    for (const GridCell& cell : fresh)
        for (int corner = 0; corner < 8; ++corner) corners.push_back(corner_of(cell, corner));
    const auto change_gone = [&](int change) {
        for (const GridCell& cell : gone)
            for (int corner = 0; corner < 8; ++corner) count_use(corner_of(cell, corner), change);
    };
    change_gone(-1);
    size_t used = 0;
    while (used < corners.size() && probes_ <= most) {
        const size_t end = std::min(used + kBatch, corners.size());
        std::set<glm::ivec3, PointOrder> unknown;
        for (size_t i = used; i < end; ++i)
            if (!points_.contains(corners[i])) unknown.insert(corners[i]);
        settle({unknown.begin(), unknown.end()});
        for (; used < end; ++used) count_use(corners[used], 1);
    }
    if (probes_ <= most) return true;
    for (size_t i = 0; i < used; ++i) count_use(corners[i], -1);
    change_gone(1);
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
        volume.probes.push_back({at, level, point.settled.offset, point.settled.state});
    }
    return volume;
}

ProbeVolume settled_grid(const TriangleTree& tree, const ProbeVolume& volume, glm::ivec3 size,
                         uint32_t threads) {
    ProbeVolume out = volume;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                out.probes.push_back({{x, y, z}, 0, glm::vec3(0), ProbeState::kept});
    const SettleLimits limits{kClearance * volume.spacing_m, kMostOffset * volume.spacing_m};
    run_on_threads(out.probes.size(), threads, [&](size_t i) {
        const Settled settled = settle_probe(tree, position_of(out, out.probes[i]), limits);
        out.probes[i].state = settled.state;
        out.probes[i].offset = settled.offset;
    });
    return out;
}

}  // namespace weft::scene
