#include "shader/reflect/sampled_images.h"

#include <spirv.h>

#include <map>
#include <utility>

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

// Returns true if the result of the instruction stands for the same image as operand 2 of the instruction.
bool passes_on(uint32_t opcode) {
    return opcode == SpvOpLoad || opcode == SpvOpAccessChain || opcode == SpvOpInBoundsAccessChain ||
           opcode == SpvOpSampledImage || opcode == SpvOpImage || opcode == SpvOpCopyObject;
}

// The ids of the image variables of a stage, sorted by the instructions that use the images. `measured` has
// the images whose size the stage queries.
struct ImageUses {
    std::map<uint32_t, std::string> names;
    std::set<uint32_t> declared, sampled, measured, passed_to_functions;
};

ImageUses image_uses(std::span<const uint32_t> spirv) {
    ImageUses uses;
    // For each id that stands for an image: the variable of the image.
    std::map<uint32_t, uint32_t> variables;
    const auto variable_of = [&](uint32_t id) {
        const auto found = variables.find(id);
        return found != variables.end() ? found->second : id;
    };
    SpirvReader reader(spirv);
    for (SpirvInstruction i; reader.next(i);) {
        if (i.opcode == SpvOpName && i.operands.size() > 1)
            uses.names[i.operand(0)] = spirv_string(i.operands.subspan(1));
        if (i.opcode == SpvOpVariable) uses.declared.insert(i.operand(1));
        if (passes_on(i.opcode)) variables[i.operand(1)] = variable_of(i.operand(2));
        if (samples(i.opcode)) uses.sampled.insert(variable_of(i.operand(2)));
        if (asks_for_size(i.opcode)) uses.measured.insert(variable_of(i.operand(2)));
        if (i.opcode == SpvOpFunctionCall)
            for (const uint32_t argument : i.operands.subspan(i.operands.size() < 3 ? i.operands.size() : 3))
                uses.passed_to_functions.insert(variable_of(argument));
    }
    return uses;
}

}  // namespace

std::set<std::string> sampled_images(std::span<const uint32_t> spirv) {
    ImageUses uses = image_uses(spirv);
    std::set<std::string> found;
    for (const uint32_t variable : uses.sampled)
        // `declared` does not contain the parameters of functions, so these are left out.
        if (uses.declared.contains(variable) && !uses.measured.contains(variable) &&
            !uses.passed_to_functions.contains(variable))
            found.insert(uses.names[variable]);
    return found;
}

std::set<uint32_t> filtered_images(std::span<const uint32_t> spirv) {
    ImageUses uses = image_uses(spirv);
    uses.sampled.merge(uses.passed_to_functions);
    return std::move(uses.sampled);
}

}  // namespace weft::shader
