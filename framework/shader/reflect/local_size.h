// Purpose: finds out whether a compute shader declares its local size. SPIR-V cannot tell: a missing
// declaration and an explicit 1 × 1 × 1 give the same module.
#pragma once

#include <span>

#include "shader/faults/source_position.h"

namespace weft::shader {

// `sources`: the shader's file and all files that it includes. Comments are ignored.
[[nodiscard]] bool states_local_size(std::span<const SourceText* const> sources);

}  // namespace weft::shader
