// Purpose: lists the files that the program and the Vulkan driver open, in addition to the files that the
// user names.
#pragma once

#include "viewer/sandbox/sandbox_kernel.h"

namespace weft::viewer {

// Returns the files that the program may open. If `device` is true, the list includes the files of the Vulkan
// loader, the drivers and the layers.
[[nodiscard]] OpenRules rules_of_program(bool device);

}  // namespace weft::viewer
