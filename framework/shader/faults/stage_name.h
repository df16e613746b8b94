// Purpose: the names of shader stages for messages to the user.
#pragma once

#include "weft/shader_interface.h"

namespace weft::shader {

[[nodiscard]] constexpr const char* stage_name(ShaderStage stage) {
    switch (stage) {
        case ShaderStage::vertex:
            return "vertex";
        case ShaderStage::fragment:
            return "fragment";
        case ShaderStage::compute:
            return "compute";
    }
    return "";
}

}  // namespace weft::shader
