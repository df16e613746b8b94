// Purpose: reads and writes the instructions of SPIR-V modules that Weft rewrites. A module must have passed
// spirv-val. Its header has five words. Each instruction is a word with its length and opcode, followed by
// its operands.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace weft::vk::spirv {

// Word kBoundWord of the header is the bound: all ids are smaller than it.
inline constexpr size_t kHeaderWords = 5, kBoundWord = 3;

enum Opcode : uint32_t {
    kOpLine = 8,
    kOpEntryPoint = 15,
    kOpCapability = 17,
    kOpTypeVoid = 19,
    kOpTypeInt = 21,
    kOpTypeArray = 28,
    kOpTypeRuntimeArray = 29,
    kOpTypeStruct = 30,
    kOpTypePointer = 32,
    kOpTypeForwardPointer = 39,
    kOpConstant = 43,
    kOpFunction = 54,
    kOpFunctionCall = 57,
    kOpVariable = 59,
    kOpLoad = 61,
    kOpStore = 62,
    kOpCopyMemory = 63,
    kOpAccessChain = 65,
    kOpInBoundsAccessChain = 66,
    kOpDecorate = 71,
    kOpMemberDecorate = 72,
    kOpCopyObject = 83,
    kOpIAdd = 128,
    kOpISub = 130,
    kOpLabel = 248,
    kOpNoLine = 317,
};
enum Decoration : uint32_t {
    kBlock = 2,
    kArrayStride = 6,
    kBuiltIn = 11,
    kFlat = 14,
    kBinding = 33,
    kDescriptorSet = 34,
    kOffset = 35
};
enum StorageClass : uint32_t { kInput = 1, kUniform = 2, kOutput = 3, kPushConstant = 9 };

struct Instruction {
    uint32_t opcode = 0;
    // All words of the instruction, including the first, which contains its length and opcode.
    std::span<const uint32_t> words;
};

// Calls `visit` for every instruction.
template <class Visit>
void for_each_instruction(std::span<const uint32_t> spirv, const Visit& visit) {
    for (size_t word = kHeaderWords; word < spirv.size(); word += spirv[word] >> 16)
        visit(Instruction{spirv[word] & 0xffffu, spirv.subspan(word, spirv[word] >> 16)});
}

inline bool is_access_chain(uint32_t opcode) {
    return opcode == kOpAccessChain || opcode == kOpInBoundsAccessChain;
}

// True for the opcodes that can come directly after the decorations of a module. New decorations must come
// before the first instruction with such an opcode.
inline bool ends_decorations(uint32_t opcode) {
    return (opcode >= kOpTypeVoid && opcode <= kOpTypeForwardPointer) || opcode == kOpLine;
}

inline void emit(std::vector<uint32_t>& out, uint32_t opcode, std::initializer_list<uint32_t> operands) {
    out.push_back(static_cast<uint32_t>(1 + operands.size()) << 16 | opcode);
    out.insert(out.end(), operands);
}

}  // namespace weft::vk::spirv
