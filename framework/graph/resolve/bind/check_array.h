// Purpose: checks ports with "each" against the arrays of descriptors that shaders declare. Private to
// bind().
#pragma once

#include "graph/resolve/bind/bind_pass.h"

namespace weft {

// Checks that a port is an array of descriptors exactly if it has "each", and that the array has an element
// for each mip or layer. Returns false after reporting an error. Errors: W173, W196, W232.
[[nodiscard]] bool check_array(PassBinding& pass, const UseDecl& use, const PortDraft& port,
                               const ShaderBinding& binding);
// Reports "each" of a port that cannot be an array. Errors: W196.
void report_no_array(PassBinding& pass, const UseDecl& use, const PortDraft& port);
// Checks that no stage of the shader has more images than the device allows. The elements of arrays are
// counted one by one. Errors: W197.
void check_image_count(PassBinding& pass);

}  // namespace weft
