// Purpose: a graph compiled and proved without a device, for `check` and `plan`: a profile stands in for one,
// and memory needs are the contents' own bytes.
#pragma once

#include <map>
#include <string>

#include "weft/device_profile.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::viewer {

[[nodiscard]] Result<FramePlan> compile_offline(const std::string& file, const DeviceProfile& profile,
                                                Extent3D size, const std::map<std::string, double>& params,
                                                Diagnostics& warnings);

}  // namespace weft::viewer
