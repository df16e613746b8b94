#include "vulkan/pipelines/opaque_uniforms.h"

#include <algorithm>
#include <map>
#include <set>

#include "vulkan/pipelines/pass_layout.h"
#include "vulkan/pipelines/spirv_module.h"

namespace weft::vk {
namespace {

using namespace spirv;

// Number of the SPIR-V capability UniformBufferArrayDynamicIndexing.
constexpr uint32_t kUniformBufferArrayDynamicIndexing = 28;

bool is_uniform(uint32_t storage_class) {
    return storage_class == kUniform || storage_class == kPushConstant;
}

class Rewriter {
 public:
    Rewriter(std::span<const uint32_t> spirv, const BlockPlace& push_constants)
        : spirv_(spirv), place_(push_constants), bound_(spirv[kBoundWord]) {
        for_each_instruction(spirv, [&](const Instruction& at) { survey(at); });
        uint_ = found_uint_ != 0 ? found_uint_ : new_id();
    }

    std::vector<uint32_t> run() {
        if (blocks_.empty()) return {spirv_.begin(), spirv_.end()};
        out_.assign(spirv_.begin(), spirv_.begin() + kHeaderWords);
        emit(kOpCapability, {kUniformBufferArrayDynamicIndexing});
        for_each_instruction(spirv_, [&](const Instruction& at) { rewrite(at); });
        out_[kBoundWord] = bound_;
        return std::move(out_);
    }

 private:
    void survey(const Instruction& at) {
        if (at.opcode == kOpTypeInt && at.words[2] == 32 && at.words[3] == 0) found_uint_ = at.words[1];
        if (at.opcode == kOpTypeArray || at.opcode == kOpTypeRuntimeArray) arrays_.insert(at.words[1]);
        if (at.opcode == kOpTypePointer) pointees_[at.words[1]] = at.words[3];
        if (at.opcode == kOpVariable && is_uniform(at.words[3]))
            blocks_[at.words[2]] = arrays_.contains(pointees_[at.words[1]]);
    }

    uint32_t new_id() { return bound_++; }
    void emit(uint32_t opcode, std::initializer_list<uint32_t> operands) {
        spirv::emit(out_, opcode, operands);
    }
    void copy(const Instruction& at) { out_.insert(out_.end(), at.words.begin(), at.words.end()); }

    void rewrite(const Instruction& at) {
        // In a module, all decorations come before all types. declare() adds decorations, then types. So it
        // must run after the last old decoration and before the first old type (or the OpLine before it).
        if (!declared_ && ends_decorations(at.opcode)) declare();
        // declare() has already declared this type, and a module must not declare it twice.
        if (at.opcode == kOpTypeInt && at.words[1] == uint_) return;
        const size_t start = out_.size();
        if (at.opcode == kOpVariable && is_uniform(at.words[3])) return rewrite_variable(at);
        if (is_access_chain(at.opcode) && blocks_.contains(at.words[3])) return rewrite_access(at);
        copy(at);
        // The last operands of OpEntryPoint list the variables that the shader uses. The new push constant is
        // added to this list.
        if (at.opcode == kOpEntryPoint) {
            out_.push_back(index_block_);
            out_[start] += 1u << 16;
        }
        if (at.opcode == kOpTypePointer && at.words[2] == kPushConstant) out_[start + 2] = kUniform;
    }

    // Declares the push constant that is always 0, and its types and constants. Also gives a descriptor set
    // and binding to the shader's own push constants, which become a uniform block.
    void declare() {
        declared_ = true;
        emit(kOpDecorate, {index_struct_, kBlock});
        emit(kOpMemberDecorate, {index_struct_, 0, kOffset, 0});
        for_each_instruction(spirv_, [&](const Instruction& at) {
            if (at.opcode != kOpVariable || at.words[3] != kPushConstant) return;
            emit(kOpDecorate, {at.words[2], kDescriptorSet, place_.set});
            emit(kOpDecorate, {at.words[2], kBinding, place_.binding});
        });
        const uint32_t pointer = new_id();
        emit(kOpTypeInt, {uint_, 32, 0});
        emit(kOpConstant, {uint_, zero_, 0});
        emit(kOpConstant, {uint_, one_, 1});
        emit(kOpTypeStruct, {index_struct_, uint_});
        emit(kOpTypePointer, {pointer, kPushConstant, index_struct_});
        emit(kOpTypePointer, {index_pointer_, kPushConstant, uint_});
        emit(kOpVariable, {pointer, index_block_, kPushConstant});
    }

    void rewrite_variable(const Instruction& at) {
        uint32_t type = at.words[1];
        if (!blocks_.at(at.words[2])) {
            const uint32_t array = new_id(), pointer = new_id();
            emit(kOpTypeArray, {array, pointees_.at(type), one_});
            emit(kOpTypePointer, {pointer, kUniform, array});
            type = pointer;
        }
        emit(kOpVariable, {type, at.words[2], kUniform});
    }

    // Rewrites an access to a uniform block. The block is now an element of an array, and a push constant
    // contains the index of the element. If the variable was an array of blocks before, the access already
    // has an element index; the push constant is added to it. The operands of the instruction are: type,
    // result, variable, indices.
    void rewrite_access(const Instruction& at) {
        const uint32_t place = new_id();
        uint32_t index = new_id();
        emit(kOpAccessChain, {index_pointer_, place, index_block_, zero_});
        emit(kOpLoad, {uint_, index, place});
        std::span<const uint32_t> rest = at.words.subspan(4);
        if (blocks_.at(at.words[3])) {
            const uint32_t sum = new_id();
            emit(kOpIAdd, {uint_, sum, rest[0], index});
            index = sum;
            rest = rest.subspan(1);
        }
        const size_t start = out_.size();
        emit(at.opcode, {at.words[1], at.words[2], at.words[3], index});
        out_.insert(out_.end(), rest.begin(), rest.end());
        out_[start] += static_cast<uint32_t>(rest.size()) << 16;
    }

    std::span<const uint32_t> spirv_;
    BlockPlace place_;
    uint32_t bound_;
    // Maps the id of each pointer type to the id of the type to which it points.
    std::map<uint32_t, uint32_t> pointees_;
    // The ids of all array types.
    std::set<uint32_t> arrays_;
    // For the id of each variable that is a uniform block or push constants: true if the variable was an
    // array of blocks in the original module.
    std::map<uint32_t, bool> blocks_;
    uint32_t found_uint_ = 0, uint_ = 0;
    const uint32_t zero_ = new_id(), one_ = new_id();
    const uint32_t index_struct_ = new_id(), index_pointer_ = new_id(), index_block_ = new_id();
    bool declared_ = false;
    std::vector<uint32_t> out_;
};

uint32_t free_binding(const ShaderInterface& interface) {
    uint32_t free = 0;
    for (const ShaderBinding& binding : interface.bindings)
        if (binding.set == kPortSet) free = std::max(free, binding.binding + 1);
    return free;
}

}  // namespace

bool can_hide_uniforms(std::span<const uint32_t> spirv) {
    std::set<uint32_t> blocks;
    bool can = true;
    for_each_instruction(spirv, [&](const Instruction& at) {
        if (at.opcode == kOpVariable && is_uniform(at.words[3])) blocks.insert(at.words[2]);
        const bool takes_pointers = at.opcode == kOpLoad || at.opcode == kOpCopyMemory ||
                                    at.opcode == kOpFunctionCall || at.opcode == kOpCopyObject;
        if (!takes_pointers) return;
        const auto operands = at.words.subspan(1);
        can = can && std::ranges::none_of(operands, [&](uint32_t id) { return blocks.contains(id); });
    });
    return can;
}

std::vector<uint32_t> with_opaque_uniforms(std::span<const uint32_t> spirv,
                                           const BlockPlace& push_constants) {
    return Rewriter(spirv, push_constants).run();
}

ShaderProgram with_opaque_uniforms(ShaderProgram program) {
    const auto can_hide = [](const ShaderModule& module) { return can_hide_uniforms(module.spirv); };
    if (!std::ranges::all_of(program.modules, can_hide)) return program;
    const BlockPlace place{kPortSet, free_binding(program.interface)};
    for (ShaderModule& module : program.modules) module.spirv = with_opaque_uniforms(module.spirv, place);
    ParamsBlock& params = program.interface.params;
    if (program.interface.has_params && params.push_constants) {
        params.push_constants = false;
        params.binding = place.binding;
    }
    return program;
}

}  // namespace weft::vk
