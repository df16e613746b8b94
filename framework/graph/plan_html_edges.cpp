#include "graph/plan_html_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace weft {
namespace {

constexpr int32_t kWayStep_px = 2;
constexpr int32_t kCharacter_px = 7;  // in the style "edgename"
constexpr int32_t kAscent_px = 10, kDescent_px = 3;
constexpr int32_t kClear_px = 3;  // between a name and its way
constexpr int32_t kTryEvery_px = 6;

std::string point(PointPx p) {
    return std::to_string(p.x) + " " + std::to_string(p.y);
}

// What is drawn on, in squares of kSquare_px.
class Occupied {
 public:
    explicit Occupied(PointPx drawing)
        : columns_(drawing.x / kSquare_px + 1),
          rows_(drawing.y / kSquare_px + 1),
          used_(static_cast<size_t>(columns_) * static_cast<size_t>(rows_), false) {}

    void take(const AreaPx& area) {
        for_squares(area, [this](size_t square) {
            used_[square] = true;
            return true;
        });
    }
    [[nodiscard]] bool is_free(const AreaPx& area) const {
        if (area.x < 0 || area.y < 0 || area.x + area.width > columns_ * kSquare_px ||
            area.y + area.height > rows_ * kSquare_px)
            return false;
        return for_squares(area, [this](size_t square) { return !used_[square]; });
    }

 private:
    static constexpr int32_t kSquare_px = 2;

    // Until `visit` returns false; then it does so too.
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
    std::vector<bool> used_;
};

AreaPx area_of(const std::string& text, PointPx at) {
    const auto width_px = static_cast<int32_t>(text.size()) * kCharacter_px;
    return {at.x - width_px / 2, at.y - kAscent_px, width_px, kAscent_px + kDescent_px};
}

// Above a point of a way, below it, or at a side of it.
std::vector<PointPx> places_at(PointPx p, const std::string& text) {
    const int32_t aside_px = static_cast<int32_t>(text.size()) * kCharacter_px / 2 + 2 * kClear_px;
    const int32_t above_px = p.y - kDescent_px - kClear_px, below_px = p.y + kAscent_px + kClear_px,
                  level_px = p.y + (kAscent_px - kDescent_px) / 2;
    return {{p.x, above_px},
            {p.x, below_px},
            {p.x + aside_px, level_px},
            {p.x - aside_px, level_px},
            {p.x + aside_px, below_px},
            {p.x - aside_px, above_px},
            {p.x + aside_px, above_px},
            {p.x - aside_px, below_px}};
}

// As near as can be to the middle of the way.
EdgeName place(const std::string& text, const EdgeWay& way, const Occupied& occupied) {
    const auto count = static_cast<int32_t>(way.points().size()), middle = count / 2;
    for (int32_t away = 0; away <= middle; away += kTryEvery_px / kWayStep_px)
        for (const int32_t index : {middle - away, middle + away}) {
            if (index < 0 || index >= count) continue;
            for (const PointPx& at : places_at(way.points()[static_cast<size_t>(index)], text))
                if (occupied.is_free(area_of(text, at))) return {text, at};
        }
    return {};
}

}  // namespace

void EdgeWay::move(PointPx to) {
    path_ += "M" + point(to);
    points_.push_back(to);
}

void EdgeWay::line(PointPx to) {
    path_ += "L" + point(to);
    follow(points_.back(), to, to);
}

void EdgeWay::curve(PointPx first, PointPx second, PointPx to) {
    path_ += "C" + point(first) + " " + point(second) + " " + point(to);
    follow(first, second, to);
}

void EdgeWay::bend(PointPx corner, PointPx to) {
    path_ += "Q" + point(corner) + " " + point(to);
    follow(corner, corner, to);  // inside its corner too, which is near enough
}

void EdgeWay::follow(PointPx first, PointPx second, PointPx to) {
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

std::vector<EdgeName> place_edge_names(const std::vector<EdgeWay>& ways,
                                       const std::vector<NameChoices>& names,
                                       const std::vector<AreaPx>& boxes, PointPx drawing) {
    Occupied occupied(drawing);
    for (const AreaPx& box : boxes) occupied.take(box);
    for (const EdgeWay& way : ways)
        for (const PointPx& p : way.points()) occupied.take({p.x - 1, p.y - 1, 2, 2});
    std::vector<EdgeName> placed(ways.size());
    for (size_t i = 0; i < ways.size(); ++i)
        for (const std::string& text : names[i]) {
            placed[i] = place(text, ways[i], occupied);
            if (placed[i].text.empty()) continue;
            const AreaPx area = area_of(text, placed[i].at);
            occupied.take(
                {area.x - kCharacter_px, area.y - 1, area.width + 2 * kCharacter_px, area.height + 2});
            break;
        }
    return placed;
}

}  // namespace weft
