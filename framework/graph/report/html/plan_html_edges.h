// Purpose: the paths of the edges in the page's graph, and where on them there is room for the names of
// their resources. Units: pixels of the drawing.
#pragma once

#include <string>
#include <vector>

#include "graph/report/html/layered_layout.h"
#include "weft/declaration.h"

namespace weft {

// The path of an SVG element, and points on it that lie no further apart than kWayStep_px.
class EdgePath {
 public:
    void move(PointPx to);
    void line(PointPx to);
    void curve(PointPx first, PointPx second, PointPx to);  // cubic
    void bend(PointPx corner, PointPx to);                  // quadratic

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::vector<PointPx>& points() const { return points_; }

 private:
    void follow(PointPx first, PointPx second, PointPx to);

    std::string path_;
    std::vector<PointPx> points_;
};

struct AreaPx {
    int32_t x = 0, y = 0, width = 0, height = 0;
};

struct EdgeName {
    std::string text;  // "" where there is no room
    PointPx at;        // the middle of its base line
};

// The possible names of an edge, the longest first.
using NameChoices = std::vector<std::string>;

// By edge. Those that come first have the choice of place; a name lies on its own path, and touches no box,
// no path of another name and no other name. Paths that share a name and the place where it lies share the
// name: only the first has it.
[[nodiscard]] std::vector<EdgeName> place_edge_names(const std::vector<EdgePath>& paths,
                                                     const std::vector<NameChoices>& names,
                                                     const std::vector<AreaPx>& boxes, PointPx drawing);

}  // namespace weft
