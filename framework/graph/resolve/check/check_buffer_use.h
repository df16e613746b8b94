// Purpose: checks one use of a buffer. Private to check_interfaces().
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Checks that the bytes of a use suit the block in the shader, and that they begin at an offset that the
// device allows. `binding` is null if the port has no binding in a shader. Errors: W166, W194.
void check_buffer_use(const Declared& declared, PassId pass, const UseDecl& use, const ResourceDecl& buffer,
                      const ShaderBinding* binding, PassReporter& report);

}  // namespace weft
