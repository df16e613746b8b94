// Purpose: places the boxes of a directed graph in layers from left to right and leads its edges around them.
// Source: K. Sugiyama, S. Tagawa and M. Toda, "Methods for Visual Understanding of Hierarchical System
// Structures", 1981; heights by isotonic regression (pool adjacent violators), M. Ayer et al., 1955.
// Units: pixels; y grows downwards. Deterministic: the same graph gives the same picture.
#pragma once

#include <cstdint>
#include <vector>

namespace weft {

struct LayoutBox {
    int32_t width_px = 0;
    int32_t height_px = 0;
};

// No cycles. Several edges between the same two boxes are laid out as one.
struct LayoutEdge {
    uint32_t from = 0;
    uint32_t to = 0;
};

struct PointPx {
    int32_t x = 0;
    int32_t y = 0;
};

struct LayeredLayout {
    std::vector<PointPx> boxes;  // top left corners
    // By edge: where it enters and leaves each layer that it crosses. Two points a layer, on one height.
    std::vector<std::vector<PointPx>> bends;
    int32_t width_px = 0;
    int32_t height_px = 0;
    uint32_t layers = 0;
};

// Boxes stand in each layer in their given order at first, and change places where that saves crossings.
[[nodiscard]] LayeredLayout layered_layout(const std::vector<LayoutBox>& boxes,
                                           const std::vector<LayoutEdge>& edges, int32_t layer_gap_px);

}  // namespace weft
