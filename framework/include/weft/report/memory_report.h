// Purpose: reports the memory of a plan: the sum of all sizes, the peak and the resources alive there, the
// heaps, and whether the device has enough memory. Units: bytes.
#pragma once

#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/limits.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// The transients alive at the peak of live memory, largest first.
[[nodiscard]] std::vector<ResourceId> live_at_peak(const FramePlan& plan);
// The placed size of a resource; 0 if it has no placement.
[[nodiscard]] uint64_t placed_bytes(const FramePlan& plan, ResourceId resource);

// Indented lines. With a profile, each heap is listed with its memory type.
[[nodiscard]] std::string memory_report(const FramePlan& plan, const DeviceProfile* profile);

// Warning W142 for each of the device's heaps that is too small; `file` names the graph. Lazily allocated
// memory is not counted.
[[nodiscard]] Diagnostics memory_faults(const FramePlan& plan, const DeviceProfile& profile,
                                        const std::string& file);

// Error W143 if the total size of all heaps exceeds the limit; `file` names the graph.
[[nodiscard]] Diagnostics budget_faults(const FramePlan& plan, const GraphLimits& limits,
                                        const std::string& file);

}  // namespace weft
