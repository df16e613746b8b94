// Purpose: places the boxes of a directed graph in layers from left to right and routes its edges around the
// boxes.
// Source: K. Sugiyama, S. Tagawa and M. Toda, "Methods for Visual Understanding of Hierarchical System
// Structures", 1981; vertical positions by isotonic regression (pool adjacent violators), M. Ayer et al.,
// 1955.
// Units: pixels; y grows downwards. The same graph always gives the same picture.
#pragma once

#include <cstdint>
#include <vector>

namespace weft {

struct LayoutBox {
    int32_t width_px = 0;
    int32_t height_px = 0;
};

// An edge from one box to another, by index. The edges must have no cycle. Several edges between the same two
// boxes get the same path.
struct LayoutEdge {
    uint32_t from = 0;
    uint32_t to = 0;
};

struct PointPx {
    int32_t x = 0;
    int32_t y = 0;
};

struct LayeredLayout {
    std::vector<PointPx> boxes;  // Index: box. Position of its top left corner.
    // Index: edge. The points where the edge enters and leaves each layer between its two boxes. The two
    // points of a layer have the same y. Empty for edges to the next layer, and for the longest edges of a
    // very large graph: they lead directly from box to box.
    std::vector<std::vector<PointPx>> bends;
    int32_t width_px = 0;
    int32_t height_px = 0;
    uint32_t layers = 0;
};

// Computes the layout. At first, the boxes of one layer have the order of `boxes`. They change places if
// fewer edges cross then. `layer_gap_px` is the horizontal gap between two layers.
[[nodiscard]] LayeredLayout layered_layout(const std::vector<LayoutBox>& boxes,
                                           const std::vector<LayoutEdge>& edges, int32_t layer_gap_px);

}  // namespace weft
