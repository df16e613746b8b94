// Purpose: lists of passes in messages about frames. A long list ends with the number of its other entries.
#pragma once

#include <cstdint>
#include <string>

#include "weft/plan.h"
#include "weft/vulkan/draw_source.h"

namespace weft::vk {

// Returns the names of the passes from position `first` of the execution order on.
[[nodiscard]] std::string pass_names(const FramePlan& plan, uint32_t first);

// Returns how many objects each pass draws, for the passes from position `first` of the execution order on.
// The help of the error for a lost frame lists these numbers, because many draws may cause a time-out.
// Example: "gbuffer 4096, sunShadows#0 4096".
[[nodiscard]] std::string draw_counts(const FramePlan& plan, const DrawSource* draws, uint32_t first);

}  // namespace weft::vk
