// Purpose: where a plan's memory goes: the sum of all sizes, the peak and who is alive there, the heaps, and
// whether a device has room for them. Units: bytes.
#pragma once

#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/limits.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// The transients alive where most are, largest first.
[[nodiscard]] std::vector<ResourceId> live_at_peak(const FramePlan& plan);
// The bytes that a resource was placed with; 0 when it has no place.
[[nodiscard]] uint64_t placed_bytes(const FramePlan& plan, ResourceId resource);

// Indented lines. With a profile, heaps say which type of memory they are made of.
[[nodiscard]] std::string memory_report(const FramePlan& plan, const DeviceProfile* profile);

// Warning W142 for each of the device's heaps that is too small; `file` names the graph. Lazily allocated
// memory counts nothing.
[[nodiscard]] Diagnostics memory_faults(const FramePlan& plan, const DeviceProfile& profile,
                                        const std::string& file);

// Error W143 when all heaps together are beyond the limit; `file` names the graph.
[[nodiscard]] Diagnostics budget_faults(const FramePlan& plan, const GraphLimits& limits,
                                        const std::string& file);

}  // namespace weft
