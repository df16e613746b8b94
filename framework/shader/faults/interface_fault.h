// Purpose: a fault in the interface of a shader that has no place in a source file yet. SPIR-V keeps names
// but no places, so the place is found by searching the sources for the name.
#pragma once

#include <string>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::shader {

struct InterfaceFault {
    // "W205" stages that do not match, "W206" an unsupported interface, "W208" and "W209" SPIR-V that the
    // gate rejects
    std::string code;
    ShaderStage stage = ShaderStage::compute;
    std::string subject;  // the name to search for in the source; empty when the fault has none
    std::string message;
    std::string help;
    // Used without a name: words whose position in the source is reported; see find_words().
    std::string words = {};
};

using InterfaceFaults = std::vector<InterfaceFault>;

}  // namespace weft::shader
