// Purpose: the C++ pass types that this build contains, by the name that graphs use.
#pragma once

#include "weft/pass.h"

namespace weft {

[[nodiscard]] PassCatalog registered_passes();

}  // namespace weft
