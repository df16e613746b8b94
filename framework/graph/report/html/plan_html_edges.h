// Purpose: creates the paths of the edges in the page's graph, and finds places on them for the names of the
// edges' resources. Units: pixels of the drawing.
#pragma once

#include <string>
#include <vector>

#include "graph/report/html/layered_layout.h"
#include "weft/declaration.h"

namespace weft {

// The path of an SVG element, and points along it that are about kWayStep_px apart.
class EdgePath {
 public:
    void move(PointPx to);
    void line(PointPx to);
    void curve(PointPx first, PointPx second, PointPx to);  // Appends a cubic Bézier curve.
    void bend(PointPx corner, PointPx to);                  // Appends a quadratic Bézier curve.

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
    std::string text;  // The edge's name; empty if the edge gets none.
    PointPx at;        // The middle of the name's baseline.
};

// The possible names of an edge, the longest first.
using NameChoices = std::vector<std::string>;

// Returns the name of each edge with its place. Earlier edges choose their place first. A name lies on its
// own path and touches no box, no path with another name, and no other name. A path gets no name if there is
// no such place, or if it passes through the same name on an earlier path.
[[nodiscard]] std::vector<EdgeName> place_edge_names(const std::vector<EdgePath>& paths,
                                                     const std::vector<NameChoices>& names,
                                                     const std::vector<AreaPx>& boxes, PointPx drawing);

}  // namespace weft
