// Purpose: the values of a plan that follow live scales. The scale of a live size is a parameter of the
// graph. The images with this size are allocated for scale 1. In each frame, passes use only their area: the
// part at the top left whose size follows the scale. The plan contains the expressions of all sizes and
// numbers that depend on scales; the executor evaluates them once per frame, and decides nothing else. Units:
// areas in pixels.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/expr_op.h"
#include "weft/id.h"

namespace weft {

// The scales of one frame, by the names of the parameters. A scale that is not in the map has the value of
// its parameter.
using Scales = std::map<std::string, double, std::less<>>;

// One operation of an expression in postfix order.
struct LiveStep {
    ExprOp op = ExprOp::number;
    double number = 0;
    uint32_t value = kNoId;  // For ExprOp::name: an index into ResolvedGraph::live_values.
    auto operator<=>(const LiveStep&) const = default;
};

// A number or size that may change from frame to frame. It is one of three kinds:
// - a parameter: `param` is set. If it is a scale, a frame may give it another value in [least, most];
// - a live size: `scale` is set. `steps` computes a size. The value is this size times the scale, rounded
//   up, and clamped to the range from 1 to this size;
// - any other expression: `steps` computes it from values that stand earlier in the list of live values.
struct LiveValue {
    std::string name;            // The parameter, size or constant; empty for an expression without a name.
    uint32_t param = kNoId;      // An index into ResolvedGraph::params.
    double least = 0, most = 0;  // The range of a scale; `most` is 0 for all other values.
    std::vector<LiveStep> steps;
    uint32_t scale = kNoId;  // For a live size: the index of its scale in ResolvedGraph::live_values.
};

// Names the area of one mip level of an image with a live size (the part of the image that passes use).
// `image` is an index into ResolvedGraph::resources. kNoId: there is no such image.
struct LiveArea {
    uint32_t image = kNoId;
    uint32_t mip = 0;
    bool operator==(const LiveArea&) const = default;
};

// The number of workgroups in one dimension: one side (width or height) of a live value, divided by `per`,
// rounded up.
struct LiveCount {
    uint32_t value = kNoId;  // kNoId: the number does not change.
    uint32_t side = 0;       // 0: the width, or the value itself if it is a number. 1: the height.
    uint32_t mip = kNoId;    // The side of this mip level's area; kNoId: the side of the value itself.
    uint32_t per = 1;        // Number of shader invocations per workgroup in this dimension.
    bool operator==(const LiveCount&) const = default;
};

// One number of the viewport or the scissor rectangle of a pass.
struct LiveSide {
    bool scissor = false;  // False: a number of the viewport.
    uint32_t side = 0;     // 0 to 3: x, y, width, height.
    uint32_t value = kNoId;
    bool operator==(const LiveSide&) const = default;
};

}  // namespace weft
