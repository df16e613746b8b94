// Tests randomly changed SPIR-V. spirv-val must not crash on any changed module. Reflection must not crash on
// a changed module that spirv-val accepts.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

#include "shader/gate/validate_spirv.h"
#include "shader/reflect/interface_merge.h"
#include "tests/shader/shader_folder.h"

namespace weft {
namespace {

constexpr uint32_t kMutants = 150;

ShaderProgram compile_shipped(const char* reference, ProgramKind kind) {
    const std::filesystem::path folder = std::filesystem::path(WEFT_SOURCE_DIR) / "shaders";
    auto program = compile_shader(reference, kind, {{folder}, folder / "include", {}});
    if (!program) {
        ADD_FAILURE() << to_text(program.errors());
        return {};
    }
    return std::move(*program);
}

// Chooses a random word after the header of five words. Then changes the word, duplicates it, or cuts the
// module off before it.
std::vector<uint32_t> mutant(std::vector<uint32_t> words, std::mt19937& random) {
    const size_t at = 5 + random() % (words.size() - 5);
    switch (random() % 4) {
        case 0:
            words[at] ^= 1u << (random() % 32);
            break;
        case 1:
            words[at] = random();
            break;
        case 2:
            words.resize(at);
            break;
        default:
            words.insert(words.begin() + static_cast<std::ptrdiff_t>(at), words[at]);
            break;
    }
    return words;
}

TEST(SpirvMutants, NoneGetsPastTheGateUnlessItIsValid) {
    std::mt19937 random(20'240'115);
    uint32_t refused = 0, seen = 0;
    for (const auto& [reference, kind] : {std::pair("lighting/deferred_light.comp", ProgramKind::compute),
                                          std::pair("tonemap/tonemap.frag", ProgramKind::fullscreen)}) {
        const ShaderProgram program = compile_shipped(reference, kind);
        ASSERT_FALSE(program.modules.empty());
        const ShaderModule& whole = program.modules.back();
        ASSERT_FALSE(shader::spirv_fault(whole.spirv).has_value());
        for (uint32_t i = 0; i < kMutants; ++i, ++seen) {
            const ShaderModule changed{whole.stage, mutant(whole.spirv, random)};
            if (shader::spirv_fault(changed.spirv)) {
                ++refused;
                continue;
            }
            shader::InterfaceFaults faults;
            (void)shader::reflect_program({changed}, faults);
        }
    }
    EXPECT_GE(refused, seen / 2) << "most changes matter";
    EXPECT_LT(refused, seen) << "some only rename a thing";
}

// For this module, SPIRV-Cross threw an exception through its C interface, which ended the process.
// reflect_program() must report a fault instead.
TEST(SpirvMutants, WhatCannotBeReflectedIsAFault) {
    std::ifstream file(std::filesystem::path(WEFT_SOURCE_DIR) / "tests/fuzz/corpus/spirv/no_local_size.spv",
                       std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<uint32_t> words(bytes.size() / sizeof(uint32_t));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint32_t));
    ASSERT_FALSE(words.empty());
    ASSERT_FALSE(shader::spirv_fault(words).has_value());
    shader::InterfaceFaults faults;
    (void)shader::reflect_program({{ShaderStage::compute, words}}, faults);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].code, "W206");
}

}  // namespace
}  // namespace weft
