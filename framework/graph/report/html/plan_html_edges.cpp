#include "graph/report/html/plan_html_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace weft {
namespace {

constexpr int32_t kWayStep_px = 2;
constexpr int32_t kCharacter_px = 7;  // Width of a character in the CSS class "edgename".
constexpr int32_t kAscent_px = 10, kDescent_px = 3;
constexpr int32_t kTryEvery_px = 6;

std::string point(PointPx p) {
    return std::to_string(p.x) + " " + std::to_string(p.y);
}

// Divides the drawing into squares with sides of kSquare_px, and records which path occupies each square.
class Occupied {
 public:
    explicit Occupied(PointPx drawing)
        : columns_(drawing.x / kSquare_px + 1),
          rows_(drawing.y / kSquare_px + 1),
          owners_(static_cast<size_t>(columns_) * static_cast<size_t>(rows_), kFree) {}

    // Marks the squares of an area as occupied by `path`. Paths with equal names count as one path: `path` is
    // the index of the first of them. For a box or a placed name, `path` is kNoId: no name may be written
    // there. A square that two different paths occupy also gets kNoId.
    void take(const AreaPx& area, uint32_t path) {
        for_squares(area, [&](size_t square) {
            const uint32_t owner = owners_[square];
            owners_[square] = owner == kFree || owner == path ? path : kNoId;
            return true;
        });
    }
    // Returns true if the area lies inside the drawing and touches no box, no placed name and no path other
    // than `path`.
    [[nodiscard]] bool is_free(const AreaPx& area, uint32_t path) const {
        if (area.x < 0 || area.y < 0 || area.x + area.width > columns_ * kSquare_px ||
            area.y + area.height > rows_ * kSquare_px)
            return false;
        return for_squares(
            area, [&](size_t square) { return owners_[square] == kFree || owners_[square] == path; });
    }

 private:
    static constexpr int32_t kSquare_px = 2;
    static constexpr uint32_t kFree = kNoId - 1;

    // Calls `visit` for each square of the area. Stops and returns false as soon as `visit` returns false.
    template <class Visit>
    bool for_squares(const AreaPx& area, const Visit& visit) const {
        const int32_t left = std::max(0, area.x / kSquare_px), top = std::max(0, area.y / kSquare_px);
        const int32_t right = std::min(columns_ - 1, (area.x + area.width) / kSquare_px);
        const int32_t bottom = std::min(rows_ - 1, (area.y + area.height) / kSquare_px);
        for (int32_t row = top; row <= bottom; ++row)
            for (int32_t column = left; column <= right; ++column)
                if (!visit(static_cast<size_t>(row) * static_cast<size_t>(columns_) +
                           static_cast<size_t>(column)))
                    return false;
        return true;
    }

    int32_t columns_, rows_;
    std::vector<uint32_t> owners_;
};

AreaPx area_of(const std::string& text, PointPx at) {
    const auto width_px = static_cast<int32_t>(text.size()) * kCharacter_px;
    return {at.x - width_px / 2, at.y - kAscent_px, width_px, kAscent_px + kDescent_px};
}

// Places a name on its own path: at the free place nearest to the middle of the path. Returns an empty name
// if no place is free.
EdgeName place(const std::string& text, const EdgePath& path, uint32_t owner, const Occupied& occupied) {
    const auto count = static_cast<int32_t>(path.points().size()), middle = count / 2;
    for (int32_t away = 0; away <= middle; away += kTryEvery_px / kWayStep_px)
        for (const int32_t step : {middle - away, middle + away}) {
            if (step < 0 || step >= count) continue;
            const PointPx on = path.points()[static_cast<size_t>(step)];
            const PointPx at{on.x, on.y + (kAscent_px - kDescent_px) / 2 + 1};
            if (occupied.is_free(area_of(text, at), owner)) return {text, at};
        }
    return {};
}

bool passes_through(const EdgePath& path, const std::vector<AreaPx>& areas) {
    return std::any_of(areas.begin(), areas.end(), [&](const AreaPx& area) {
        return std::any_of(path.points().begin(), path.points().end(), [&](PointPx p) {
            return p.x >= area.x && p.x < area.x + area.width && p.y >= area.y && p.y < area.y + area.height;
        });
    });
}

}  // namespace

void EdgePath::move(PointPx to) {
    path_ += "M" + point(to);
    points_.push_back(to);
}

void EdgePath::line(PointPx to) {
    path_ += "L" + point(to);
    follow(points_.back(), to, to);
}

void EdgePath::curve(PointPx first, PointPx second, PointPx to) {
    path_ += "C" + point(first) + " " + point(second) + " " + point(to);
    follow(first, second, to);
}

void EdgePath::bend(PointPx corner, PointPx to) {
    path_ += "Q" + point(corner) + " " + point(to);
    // The points follow a cubic curve with both control points at the corner, which is close enough to the
    // quadratic curve.
    follow(corner, corner, to);
}

void EdgePath::follow(PointPx first, PointPx second, PointPx to) {
    const PointPx from = points_.back();
    const auto between = [](PointPx a, PointPx b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y); };
    const int32_t most_px = between(from, first) + between(first, second) + between(second, to);
    const int32_t steps = most_px / kWayStep_px + 1;
    for (int32_t i = 1; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps, s = 1 - t;
        const double w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
        points_.push_back(
            {static_cast<int32_t>(std::lround(w0 * from.x + w1 * first.x + w2 * second.x + w3 * to.x)),
             static_cast<int32_t>(std::lround(w0 * from.y + w1 * first.y + w2 * second.y + w3 * to.y))});
    }
}

std::vector<EdgeName> place_edge_names(const std::vector<EdgePath>& paths,
                                       const std::vector<NameChoices>& names,
                                       const std::vector<AreaPx>& boxes, PointPx drawing) {
    Occupied occupied(drawing);
    for (const AreaPx& box : boxes) occupied.take(box, kNoId);
    // Paths with equal names have the same owner: the index of the first of them. A name may cover the paths
    // of its own owner, but no other paths.
    std::map<NameChoices, uint32_t> by_name;  // Key: the names of a path. Value: its owner.
    std::vector<uint32_t> owner;              // Index: path.
    for (uint32_t i = 0; i < paths.size(); ++i) {
        owner.push_back(by_name.try_emplace(names[i], i).first->second);
        for (const PointPx& p : paths[i].points()) occupied.take({p.x - 1, p.y - 1, 2, 2}, owner[i]);
    }
    std::vector<EdgeName> placed(paths.size());
    // Index: owner. The areas in which the owner's name has been placed.
    std::vector<std::vector<AreaPx>> areas(paths.size());
    for (uint32_t i = 0; i < paths.size(); ++i) {
        if (passes_through(paths[i], areas[owner[i]])) continue;
        for (const std::string& text : names[i]) {
            placed[i] = place(text, paths[i], owner[i], occupied);
            if (placed[i].text.empty()) continue;
            const AreaPx area = area_of(text, placed[i].at);
            occupied.take(
                {area.x - kCharacter_px, area.y - 1, area.width + 2 * kCharacter_px, area.height + 2}, kNoId);
            areas[owner[i]].push_back(area);
            break;
        }
    }
    return placed;
}

}  // namespace weft
