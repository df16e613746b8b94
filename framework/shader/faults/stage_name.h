// Purpose: the names of shader stages for messages to the user.
#pragma once

#include <array>

#include "graph/diagnostics/name_of_value.h"
#include "weft/shader_interface.h"

namespace weft::shader {

[[nodiscard]] constexpr const char* stage_name(ShaderStage stage) {
    return name_of_value(stage, std::array{"vertex", "fragment", "compute"});
}

}  // namespace weft::shader
