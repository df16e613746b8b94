#include "shader/reflect/sampled_images.h"

#include <spirv.h>

#include <map>

#include "shader/gate/spirv_words.h"

namespace weft::shader {
namespace {

bool samples(uint32_t opcode) {
    return (opcode >= SpvOpImageSampleImplicitLod && opcode <= SpvOpImageSampleProjDrefExplicitLod) ||
           opcode == SpvOpImageGather || opcode == SpvOpImageDrefGather;
}

bool asks_for_size(uint32_t opcode) {
    return opcode == SpvOpImageQuerySize || opcode == SpvOpImageQuerySizeLod;
}

// Returns true if the result of the instruction stands for the image in its operand 2.
bool passes_on(uint32_t opcode) {
    return opcode == SpvOpLoad || opcode == SpvOpAccessChain || opcode == SpvOpInBoundsAccessChain ||
           opcode == SpvOpSampledImage || opcode == SpvOpImage || opcode == SpvOpCopyObject;
}

}  // namespace

std::set<std::string> sampled_images(std::span<const uint32_t> spirv) {
    std::map<uint32_t, std::string> names;
    // For each id that stands for an image: the variable of the image.
    std::map<uint32_t, uint32_t> variables;
    std::set<uint32_t> declared, sampled, excluded;
    const auto variable_of = [&](uint32_t id) {
        const auto found = variables.find(id);
        return found != variables.end() ? found->second : id;
    };
    SpirvReader reader(spirv);
    for (SpirvInstruction i; reader.next(i);) {
        if (i.opcode == SpvOpName && i.operands.size() > 1)
            names[i.operand(0)] = spirv_string(i.operands.subspan(1));
        if (i.opcode == SpvOpVariable) declared.insert(i.operand(1));
        if (passes_on(i.opcode)) variables[i.operand(1)] = variable_of(i.operand(2));
        if (samples(i.opcode)) sampled.insert(variable_of(i.operand(2)));
        if (asks_for_size(i.opcode)) excluded.insert(variable_of(i.operand(2)));
        if (i.opcode == SpvOpFunctionCall)
            for (const uint32_t argument : i.operands.subspan(i.operands.size() < 3 ? i.operands.size() : 3))
                excluded.insert(variable_of(argument));
    }
    std::set<std::string> found;
    for (const uint32_t variable : sampled)
        // Parameters of functions are not declared as variables.
        if (declared.contains(variable) && !excluded.contains(variable)) found.insert(names[variable]);
    return found;
}

}  // namespace weft::shader
