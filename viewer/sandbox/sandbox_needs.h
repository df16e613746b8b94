// Purpose: what the program and the driver open besides a command's own files.
#pragma once

#include "viewer/sandbox/sandbox_kernel.h"

namespace weft::viewer {

// With the files of the Vulkan loader, the drivers and the layers if `device`.
[[nodiscard]] OpenRules rules_of_program(bool device);

}  // namespace weft::viewer
