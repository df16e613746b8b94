// Purpose: finds the members of a uniform block that the entry point of a stage can read. For example, a
// shader that includes frame_set.glsl declares all members of the frame, but reads only a few of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::shader {

// `variable` is the SPIR-V id of the block, and `members` are its members. A member that is a struct is
// divided into its own members. An array counts as a whole. The result is sorted by offset, and its ranges do
// not overlap. FrameRange::binding is not set.
[[nodiscard]] std::vector<FrameRange> used_ranges(std::span<const uint32_t> spirv, uint32_t variable,
                                                  const std::vector<BlockMember>& members,
                                                  uint32_t block_bytes);

// Sorts the ranges by binding and offset, and merges those that overlap or touch.
void merge_ranges(std::vector<FrameRange>& ranges);

}  // namespace weft::shader
