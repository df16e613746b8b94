// Purpose: reads the instructions of a SPIR-V module one after the other. Any input is safe: reading ends at
// an instruction that is incomplete or has length 0. Units: words of 32 bits.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace weft::shader {

struct SpirvInstruction {
    uint32_t opcode = 0;
    std::span<const uint32_t> operands;

    // Returns operand i, or 0 if the instruction has fewer operands.
    [[nodiscard]] uint32_t operand(size_t i) const { return i < operands.size() ? operands[i] : 0; }
};

class SpirvReader {
 public:
    explicit SpirvReader(std::span<const uint32_t> module)
        : rest_(module.subspan(module.size() < kHeaderWords ? module.size() : kHeaderWords)) {}

    // Reads the next instruction. Returns false at the end of the module.
    [[nodiscard]] bool next(SpirvInstruction& instruction) {
        if (rest_.empty()) return false;
        const size_t words = rest_.front() >> 16;
        if (words == 0 || words > rest_.size()) return false;
        instruction = {rest_.front() & 0xffffu, rest_.subspan(1, words - 1)};
        rest_ = rest_.subspan(words);
        return true;
    }

 private:
    static constexpr size_t kHeaderWords = 5;
    std::span<const uint32_t> rest_;
};

// Decodes a literal string of SPIR-V. Each word contains four characters, the first one in the lowest byte.
// The string ends at the first zero byte.
[[nodiscard]] inline std::string spirv_string(std::span<const uint32_t> words) {
    std::string text;
    for (const uint32_t word : words) {
        for (uint32_t i = 0; i < 4; ++i) {
            const char c = static_cast<char>(static_cast<uint8_t>(word >> (8 * i)));
            if (c == '\0') return text;
            text += c;
        }
    }
    return text;
}

}  // namespace weft::shader
