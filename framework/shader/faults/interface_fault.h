// Purpose: a fault in what a shader asks for or hands on, before it is placed in a source file. SPIR-V keeps
// names, not places: the place is found by looking for the name in the sources.
#pragma once

#include <string>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::shader {

struct InterfaceFault {
    // "W205" stages that do not fit together, "W206" an interface no pass can offer, "W208" and "W209" what
    // the SPIR-V gate refuses
    std::string code;
    ShaderStage stage = ShaderStage::compute;
    std::string subject;  // the name to look for in the source; empty when the fault has none
    std::string message;
    std::string help;
    // Where there is no name to look for: what may stand for the fault in the source; see find_words().
    std::string words = {};
};

using InterfaceFaults = std::vector<InterfaceFault>;

}  // namespace weft::shader
