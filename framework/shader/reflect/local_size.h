// Purpose: finds out whether a compute shader declares its local size. SPIR-V does not contain this
// information: a missing declaration and an explicit size of 1 × 1 × 1 give the same module.
#pragma once

#include <span>

#include "shader/faults/source_position.h"

namespace weft::shader {

// Returns true if a source file contains a declaration of the local size outside comments. `sources` are the
// file of the shader and all files that it includes.
[[nodiscard]] bool states_local_size(std::span<const SourceText* const> sources);

}  // namespace weft::shader
