// Purpose: for one frame, evaluates the values of a plan that follow live scales (factors of image sizes that
// may change in each frame), and the numbers of passes that are computed from these values. This is
// arithmetic on data of the plan; this code decides nothing. Units: pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/declaration.h"

namespace weft {

// Minimum distance between a sample position and the edge of an area such that a linear filter reads only
// texels of the area. Half a texel is not enough: at the centre of the last texel, a filter may read the next
// texel with the weight 0. The weights have steps of 1/256.
inline constexpr double kFilterMargin_px = 0.5 + 1.0 / 256;

// The value of a LiveValue (a number or size that may change in each frame) in one frame. For a number, both
// components are equal. If an expression has no value for the scales of the frame, for example because it
// divides by zero, its value is 0.
struct LiveNumber {
    double x = 0;
    double y = 0;
    bool operator==(const LiveNumber&) const = default;
};

// Evaluates ResolvedGraph::live_values and stores the results in `values`, in the same order. Reuses the
// memory of `values`. A scale outside of its range is clamped to the range.
void evaluate_live(const ResolvedGraph& graph, const Scales& scales, std::vector<LiveNumber>& values);

// Returns the area of the first mip of an image: the live value of the image, rounded down and clamped to the
// range from 1 to the extent of the image. For an image without a live size, returns the extent.
[[nodiscard]] Extent3D live_area(const ResourceDecl& image, std::span<const LiveNumber> values);
// Returns the area of one mip of an image with a live size. `area.image` must not be kNoId.
[[nodiscard]] Extent3D live_area(const ResolvedGraph& graph, const LiveArea& area,
                                 std::span<const LiveNumber> values);
// Returns the numbers of workgroups of a compute pass.
[[nodiscard]] std::array<uint32_t, 3> live_groups(const PassDecl& pass, std::span<const LiveNumber> values);
// Returns the state of a pass that draws, with its viewport and scissor in this frame.
[[nodiscard]] RasterState live_state(const PassDecl& pass, std::span<const LiveNumber> values);

}  // namespace weft
