// Purpose: the C++ pass types in this build, by the names used in graphs.
#pragma once

#include "weft/pass.h"

namespace weft {

[[nodiscard]] PassCatalog registered_passes();

}  // namespace weft
