// Interprets the fuzzer's bytes as the words of a SPIR-V module. The module passes through all checks for
// modules from the compiler or the cache: the gate (shader/gate/spirv_gate.h), spirv-val and reflection. If
// the gate and spirv-val accept a module, all its capabilities must be allowed by the capability table.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "shader/gate/capability_table.h"
#include "shader/gate/spirv_gate.h"
#include "shader/gate/spirv_words.h"
#include "shader/gate/validate_spirv.h"
#include "shader/reflect/interface_merge.h"

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

namespace {

using namespace weft;

constexpr size_t kHeaderWords = 5;
constexpr uint32_t kEntryPoint = 15, kCapability = 17;
constexpr uint32_t kVertex = 0, kFragment = 4;

std::vector<uint32_t> words_of(const uint8_t* data, size_t size) {
    std::vector<uint32_t> words(size / sizeof(uint32_t));
    if (!words.empty()) std::memcpy(words.data(), data, words.size() * sizeof(uint32_t));
    return words;
}

ShaderStage stage_of(const std::vector<uint32_t>& words) {
    shader::SpirvReader reader(words);
    for (shader::SpirvInstruction i; reader.next(i);) {
        if (i.opcode != kEntryPoint) continue;
        if (i.operand(0) == kVertex) return ShaderStage::vertex;
        if (i.operand(0) == kFragment) return ShaderStage::fragment;
    }
    return ShaderStage::compute;
}

void expect_listed(const std::vector<uint32_t>& words) {
    shader::SpirvReader reader(words);
    for (shader::SpirvInstruction i; reader.next(i);) {
        if (i.opcode != kCapability) continue;
        const shader::CapabilityRow* row = shader::find_capability(i.operand(0));
        if (row == nullptr || row->rule == shader::CapabilityRule::never) std::abort();
    }
}

// Returns the index of the first word of each instruction. The mutator changes whole instructions, so that
// most mutants are still valid modules.
std::vector<size_t> instructions_of(const std::vector<uint32_t>& words) {
    std::vector<size_t> begins;
    for (size_t at = kHeaderWords; at < words.size() && (words[at] >> 16) != 0; at += words[at] >> 16)
        begins.push_back(at);
    return begins;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::vector<uint32_t> words = words_of(data, size);
    const ShaderStage stage = stage_of(words);
    const bool allowed = shader::gate_faults(stage, words, {}).empty();
    if (shader::spirv_fault(words) || !allowed) return 0;
    expect_listed(words);
    shader::InterfaceFaults faults;
    (void)shader::reflect_program({{stage, words}}, faults);
    return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t most, unsigned int seed) {
    std::mt19937 random(seed);
    std::vector<uint32_t> words = words_of(data, size);
    const std::vector<size_t> begins = instructions_of(words);
    if (begins.empty() || random() % 8 == 0) return LLVMFuzzerMutate(data, size, most);
    const size_t begin = begins[random() % begins.size()];
    const size_t end = std::min<size_t>(begin + (words[begin] >> 16), words.size());
    const auto at = [&](size_t i) { return words.begin() + static_cast<std::ptrdiff_t>(i); };
    const size_t operand =
        std::min(begin + 1 + random() % std::max<size_t>(1, end - begin), words.size() - 1);
    switch (random() % 5) {
        // Adds a small number to an operand, so that ids and enumerators usually remain in range.
        case 0:
            words[operand] += 1 + random() % 3;
            break;
        case 1:
            words[operand] = random() % 2 == 0 ? random() % 8192 : uint32_t{1} << (random() % 32);
            break;
        case 2:
            words.erase(at(begin), at(end));
            break;
        case 3: {
            const std::vector<uint32_t> copied(at(begin), at(end));
            const size_t to = begins[random() % begins.size()];
            words.insert(at(to), copied.begin(), copied.end());
            break;
        }
        // Inserts a random capability after the header, where SPIR-V allows capabilities.
        default:
            words.insert(at(kHeaderWords),
                         {(2u << 16) | kCapability, static_cast<uint32_t>(random() % 6200)});
    }
    const size_t bytes =
        std::min(words.size() * sizeof(uint32_t), most / sizeof(uint32_t) * sizeof(uint32_t));
    std::memcpy(data, words.data(), bytes);
    return bytes;
}
