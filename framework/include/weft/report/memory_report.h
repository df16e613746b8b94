// Purpose: reports the memory of a plan: the sum of all sizes, the peak and the resources alive at the peak,
// the heaps, and whether the device has enough memory. Units: bytes.
#pragma once

#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/limits.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// Returns the transient resources that are alive when the memory in use is largest, largest resource first.
[[nodiscard]] std::vector<ResourceId> live_at_peak(const FramePlan& plan);
// Returns the size that the plan reserves for a resource; 0 if the plan places no memory for it.
[[nodiscard]] uint64_t placed_bytes(const FramePlan& plan, ResourceId resource);

// Returns the report as indented lines. With a profile, the report names the memory type of each heap.
[[nodiscard]] std::string memory_report(const FramePlan& plan, const DeviceProfile* profile);

// Returns a warning W142 for each memory heap of the device that is too small for the plan. `file` is the
// name of the graph file in messages. Lazily allocated memory is not counted.
[[nodiscard]] Diagnostics memory_faults(const FramePlan& plan, const DeviceProfile& profile,
                                        const std::string& file);

// Returns the error W143 if the total size of all heaps exceeds GraphLimits::transient_bytes. `file` is the
// name of the graph file in messages.
[[nodiscard]] Diagnostics budget_faults(const FramePlan& plan, const GraphLimits& limits,
                                        const std::string& file);

}  // namespace weft
