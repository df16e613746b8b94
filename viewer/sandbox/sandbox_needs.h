// Purpose: the files that the program and the driver open, besides those of a command.
#pragma once

#include "viewer/sandbox/sandbox_kernel.h"

namespace weft::viewer {

// If `device`, includes the files of the Vulkan loader, the drivers and the layers.
[[nodiscard]] OpenRules rules_of_program(bool device);

}  // namespace weft::viewer
