// Purpose: whether a compute shader states its local size. SPIR-V does not tell: without a statement it is 1
// × 1 × 1, as if that had been asked for.
#pragma once

#include <span>

#include "shader/faults/source_position.h"

namespace weft::shader {

// `sources`: the shader's file and all that it includes. Comments do not count.
[[nodiscard]] bool states_local_size(std::span<const SourceText* const> sources);

}  // namespace weft::shader
