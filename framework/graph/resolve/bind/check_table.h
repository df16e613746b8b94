// Purpose: checks the ports that are tables of textures, and the shaders that index such tables. Private to
// bind().
#pragma once

#include "graph/resolve/bind/bind_pass.h"

namespace weft {

[[nodiscard]] bool is_table(const PassBinding& pass, const UseDecl& use);
// Checks that a table is an input that the shader declares as an array of sampler2D. `binding` is the binding
// of the shader with the name of the port; null if the shader has no such binding. Returns false after
// reporting an error. Errors: W232.
[[nodiscard]] bool check_table(PassBinding& pass, const UseDecl& use, const ShaderBinding* binding);
// Reports each table in a pass without a shader. Errors: W232.
void refuse_tables(PassBinding& pass);
// If the shader needs tables of textures, checks that the device supports them. Also checks that no stage of
// the shader samples too many textures. Errors: W231.
void check_table_support(PassBinding& pass);

}  // namespace weft
