#include "shader/gate/spirv_gate.h"

#include <spirv.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "shader/faults/stage_name.h"
#include "shader/gate/capability_table.h"
#include "shader/gate/spirv_words.h"

namespace weft::shader {
namespace {

// Allowed SPIR-V extensions. They are part of Vulkan 1.3 or SPIR-V 1.6, so every device supports them.
constexpr std::array<std::string_view, 2> kExtensions{"SPV_EXT_demote_to_helper_invocation",
                                                      "SPV_KHR_non_semantic_info"};
constexpr std::array<std::string_view, 2> kInstructionSets{"GLSL.std.450", "NonSemantic.DebugPrintf"};

constexpr const char* kCoreOnly = "use features of core GLSL 4.60";

bool offered(const CapabilityRow& row, const ShaderTarget& target) {
    if (row.capability == SpvCapabilityStorageImageReadWithoutFormat)
        return target.storage_read_without_format;
    return (row.needs & ~target.capabilities) == 0;
}

// Returns the reason why the capability is rejected, or an empty text if it is allowed.
std::string refusal(const CapabilityRow& row, ShaderStage stage, const ShaderTarget& target) {
    switch (row.rule) {
        case CapabilityRule::always:
        case CapabilityRule::tables:
            return {};
        case CapabilityRule::compute:
            if (stage != ShaderStage::compute) return "which is allowed only in compute stages";
            [[fallthrough]];
        case CapabilityRule::device:
            return offered(row, target) ? "" : "which the device does not support";
        case CapabilityRule::never:
            break;
    }
    if (row.capability == SpvCapabilityPhysicalStorageBufferAddresses)
        return "which lets a shader read and write any address";
    return "which Weft does not support";
}

class CapabilityCheck {
 public:
    CapabilityCheck(ShaderStage stage, const GateRules& rules, InterfaceFaults& faults)
        : stage_(stage), rules_(rules), faults_(faults) {}

    void capability(uint32_t number) {
        const CapabilityRow* row = find_capability(number);
        if (row == nullptr) {
            fault("capability " + std::to_string(number) + " of SPIR-V, which Weft does not support", {},
                  kCoreOnly);
            return;
        }
        const std::string why = refusal(*row, stage_, rules_.target);
        // One GLSL construct often needs several capabilities with the same remedy. Report each remedy only
        // once.
        if (why.empty() || !said_.insert(row->remedy).second) return;
        const std::string remedy = row->rule == CapabilityRule::compute && stage_ != ShaderStage::compute
                                       ? "move this work into a compute pass"
                                       : row->remedy;
        fault(std::string("the capability ") + row->name + ", " + why, row->words, remedy);
    }

    // Reports an extension that is not in kExtensions. kExtensions contains the extensions of all allowed
    // capabilities. If an error was already reported, nothing is added: the shader probably needs the
    // extension for the rejected capability, so a second error would not help the user.
    void extension(const std::string& name) {
        if (!faults_.empty() || std::ranges::find(kExtensions, name) != kExtensions.end()) return;
        fault("the SPIR-V extension " + name + ", which Weft does not support", words_of_extension(name),
              kCoreOnly);
    }

    void instruction_set(const std::string& name) {
        if (!faults_.empty() || std::ranges::find(kInstructionSets, name) != kInstructionSets.end()) return;
        fault("the instruction set " + name + ", which Weft does not support", words_of_extension(name),
              kCoreOnly);
    }

 private:
    // Returns the GLSL words that may lead to a SPIR-V extension. For example, SPV_AMD_gcn_shader comes from
    // "#extension GL_AMD_gcn_shader". The GLSL extension can have another prefix than the SPIR-V extension,
    // so the names with GL_EXT, GL_ARB and GL_KHR are included, too.
    static std::string words_of_extension(const std::string& name) {
        const size_t maker_end = name.find('_', 4);
        if (!name.starts_with("SPV_") || maker_end == std::string::npos) return {};
        const std::string subject = name.substr(maker_end);
        return "GL_" + name.substr(4) + "* GL_EXT" + subject + "* GL_ARB" + subject + "* GL_KHR" + subject +
               "*";
    }

    void fault(const std::string& what, std::string words, std::string help) {
        faults_.push_back({"W208",
                           stage_,
                           {},
                           std::string("the ") + stage_name(stage_) + " stage needs " + what,
                           std::move(help),
                           std::move(words)});
    }

    ShaderStage stage_;
    const GateRules& rules_;
    InterfaceFaults& faults_;
    std::set<std::string> said_;
};

// Rejects shared variables with an initial value, and arrays of images with an index that is not a constant.
// Both need a feature of the device, but the SPIR-V declares no capability for it: for such an index, glslang
// does not emit the capabilities SampledImageArrayDynamicIndexing and StorageImageArrayDynamicIndexing.
// Exceptions: an array of sampled images without a size may have any index, because it is a table of
// textures, and resolve() checks that the device has tables. An array of sampled images with a size may have
// any index if ShaderTarget::texture_tables is true.
class FeatureCheck {
 public:
    FeatureCheck(ShaderStage stage, const ShaderTarget& target, InterfaceFaults& faults)
        : stage_(stage), target_(target), faults_(faults) {}

    void read(const SpirvInstruction& instruction) {
        switch (instruction.opcode) {
            case SpvOpName:
                names_[instruction.operand(0)] = spirv_string(
                    instruction.operands.subspan(std::min<size_t>(1, instruction.operands.size())));
                break;
            case SpvOpTypeSampledImage:
                sampled_.insert(instruction.operand(0));
                break;
            case SpvOpTypeArray:
                if (sampled_.contains(instruction.operand(1))) sampled_arrays_.insert(instruction.operand(0));
                break;
            case SpvOpTypeRuntimeArray:
                if (sampled_.contains(instruction.operand(1))) tables_.insert(instruction.operand(0));
                break;
            case SpvOpTypePointer:
                if (instruction.operand(1) == SpvStorageClassUniformConstant &&
                    !may_have_any_index(instruction.operand(2)))
                    image_pointers_[instruction.operand(0)] =
                        sampled_arrays_.contains(instruction.operand(2));
                break;
            case SpvOpConstant:
            case SpvOpSpecConstant:
            case SpvOpSpecConstantOp:
                constants_.insert(instruction.operand(1));
                break;
            case SpvOpFunctionParameter:
                note_image(instruction);
                break;
            case SpvOpVariable:
                note_image(instruction);
                variable(instruction);
                break;
            case SpvOpAccessChain:
            case SpvOpInBoundsAccessChain:
                element(instruction);
                break;
            default:
                break;
        }
    }

 private:
    void variable(const SpirvInstruction& instruction) {
        constexpr size_t kInitializer = 3;
        if (instruction.operand(2) != SpvStorageClassWorkgroup || instruction.operands.size() <= kInitializer)
            return;
        const std::string name = names_[instruction.operand(1)];
        faults_.push_back(
            {"W208", stage_, name,
             "\"" + name + "\" is a shared variable with an initial value, which Weft does not support",
             "write the value in main(), then call barrier()"});
    }

    // `type` is the type of a variable with images.
    bool may_have_any_index(uint32_t type) const {
        return tables_.contains(type) || (target_.texture_tables && sampled_arrays_.contains(type));
    }

    void note_image(const SpirvInstruction& instruction) {
        const auto pointer = image_pointers_.find(instruction.operand(0));
        if (pointer != image_pointers_.end()) images_[instruction.operand(1)] = pointer->second;
    }

    void element(const SpirvInstruction& chain) {
        constexpr size_t kFirstIndex = 3;
        const uint32_t array = chain.operand(2);
        const auto image = images_.find(array);
        if (image == images_.end() || !said_.insert(array).second) return;
        for (size_t i = kFirstIndex; i < chain.operands.size(); ++i) {
            if (constants_.contains(chain.operands[i])) continue;
            faults_.push_back(
                {"W208", stage_, names_[array],
                 "\"" + names_[array] +
                     "\" is an array of images with an index that is not a constant, which " +
                     (image->second ? "the device does not support (textureTable is 0)"
                                    : "Weft does not support"),
                 "use only constants as the index: unroll the loop by hand, or write a switch"});
            return;
        }
        said_.erase(array);
    }

    ShaderStage stage_;
    const ShaderTarget& target_;
    InterfaceFaults& faults_;
    std::map<uint32_t, std::string> names_;
    // Ids of types: sampled images, arrays of sampled images with a size, and arrays of sampled images
    // without a size (tables).
    std::set<uint32_t> sampled_, sampled_arrays_, tables_;
    std::set<uint32_t> constants_;
    // Key: id of a pointer type to an image or an array of images. Arrays that may have any index are left
    // out. Value: true for an array of sampled images.
    std::map<uint32_t, bool> image_pointers_;
    // Key: id of a variable or parameter whose type is a key of `image_pointers_`. Value: as in
    // `image_pointers_`.
    std::map<uint32_t, bool> images_;
    std::set<uint32_t> said_;  // Arrays about which an error was reported.
};

}  // namespace

void capability_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                       InterfaceFaults& faults) {
    CapabilityCheck check(stage, rules, faults);
    FeatureCheck features(stage, rules.target, faults);
    SpirvReader reader(spirv);
    for (SpirvInstruction instruction; reader.next(instruction);) {
        const auto text = [&](size_t at) {
            return spirv_string(instruction.operands.subspan(std::min(at, instruction.operands.size())));
        };
        if (instruction.opcode == SpvOpCapability) check.capability(instruction.operand(0));
        if (instruction.opcode == SpvOpExtension) check.extension(text(0));
        if (instruction.opcode == SpvOpExtInstImport) check.instruction_set(text(1));
        features.read(instruction);
    }
}

InterfaceFaults gate_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules) {
    InterfaceFaults faults;
    capability_faults(stage, spirv, rules, faults);
    storage_faults(stage, spirv, rules, faults);
    return faults;
}

}  // namespace weft::shader
