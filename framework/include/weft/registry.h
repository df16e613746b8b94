// Purpose: returns the pass types in C++ that this build contains, by the names that graphs use.
#pragma once

#include "weft/pass.h"

namespace weft {

[[nodiscard]] PassCatalog registered_passes();

}  // namespace weft
