// Purpose: an error in the interface of a shader, before its line in the source is known. SPIR-V contains
// names but no lines, so the line is found later by searching the source files for the name.
#pragma once

#include <string>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::shader {

struct InterfaceFault {
    // Code of the error. W205: the stages do not match. W206: the interface is not supported. W208, W209: the
    // SPIR-V gate rejects the module.
    std::string code;
    ShaderStage stage = ShaderStage::compute;
    std::string subject;  // Name to search for in the source files; empty if the error concerns no name.
    std::string message;
    std::string help;
    // Used if `subject` is empty: words to search for in the source files, separated by spaces; see
    // find_words().
    std::string words = {};
};

using InterfaceFaults = std::vector<InterfaceFault>;

}  // namespace weft::shader
