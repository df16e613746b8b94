// Purpose: tests with_opaque_uniforms(), which hides the values of uniforms from the shader compiler. The
// changed shaders must be valid and keep their interface.
#include "vulkan/pipelines/opaque_uniforms.h"

#include <map>
#include <set>

#include "shader/gate/spirv_words.h"
#include "shader/gate/validate_spirv.h"
#include "shader/reflect/interface_merge.h"
#include "tests/shader/shader_folder.h"

namespace weft::vk {
namespace {

void expect_valid(const ShaderProgram& program) {
    for (const ShaderModule& module : program.modules)
        EXPECT_EQ(shader::spirv_fault(module.spirv), std::nullopt) << program.reference;
}

// Returns the interface of a program that with_opaque_uniforms() changed. Faults about push constants are
// expected: Weft requires the name Params for a push constant block, but with_opaque_uniforms() adds a push
// constant block without this name. It also replaces each single uniform block by an array of one block; the
// returned interface has the single block.
ShaderInterface reflected(const ShaderProgram& program) {
    shader::InterfaceFaults faults;
    ShaderInterface interface = shader::reflect_program(program.modules, faults);
    for (const shader::InterfaceFault& fault : faults)
        EXPECT_NE(fault.message.find("push constant"), std::string::npos) << fault.message;
    for (ShaderBinding& binding : interface.bindings)
        if (binding.kind == BindingKind::uniform_buffer && binding.count == 1) binding.is_array = false;
    return interface;
}

// Returns the SPIR-V id of the first index of each access to an array of uniform blocks, in order.
// with_opaque_uniforms() replaces each such index i by the sum of i and a push constant that is always 0. If
// `module` is the result of with_opaque_uniforms(), set `hidden`: then the function returns each i, not the
// sum.
std::vector<uint32_t> first_indices(const ShaderModule& module, bool hidden) {
    constexpr uint32_t kVariable = 59, kAccessChain = 65, kIAdd = 128, kUniform = 2;
    std::set<uint32_t> blocks;
    std::map<uint32_t, uint32_t> summands;  // Id of the index i by the id of the sum with i.
    std::vector<uint32_t> indices;
    shader::SpirvReader reader(module.spirv);
    for (shader::SpirvInstruction i; reader.next(i);) {
        if (i.opcode == kVariable && i.operand(2) == kUniform) blocks.insert(i.operand(1));
        if (i.opcode == kIAdd) summands[i.operand(1)] = i.operand(2);
        if (i.opcode == kAccessChain && blocks.contains(i.operand(2)))
            indices.push_back(hidden ? summands[i.operand(3)] : i.operand(3));
    }
    return indices;
}

class OpaqueUniforms : public ShaderFolder {};

TEST_F(OpaqueUniforms, LeaveShippedShadersValid) {
    const std::filesystem::path folder = std::filesystem::path(WEFT_SOURCE_DIR) / "shaders";
    const ShaderRoots roots{{folder}, folder / "include", {}};
    const std::pair<const char*, ProgramKind> shaders[]{
        {"forward", ProgramKind::raster},
        {"gbuffer", ProgramKind::raster},
        {"lighting/deferred_light.comp", ProgramKind::compute},
        {"light_tiles/tiles.comp", ProgramKind::compute},
        {"taa/resolve.comp", ProgramKind::compute},
        {"tonemap/tonemap.frag", ProgramKind::fullscreen}};
    for (const auto& [reference, kind] : shaders) {
        const Result<ShaderProgram> program = compile_shader(reference, kind, roots);
        ASSERT_TRUE(program) << to_text(program.errors());
        const ShaderProgram hidden = with_opaque_uniforms(*program);
        expect_valid(hidden);
        const ShaderInterface now = reflected(hidden);
        EXPECT_EQ(now.bindings, program->interface.bindings) << reference;
        EXPECT_EQ(now.fragment_outputs.size(), program->interface.fragment_outputs.size()) << reference;
    }
}

TEST_F(OpaqueUniforms, MakePushConstantsABlock) {
    write("graph/a.comp", R"(#version 460
layout(local_size_x = 1) in;
layout(push_constant) uniform Params { float gain; uvec2 size; } params;
uniform Weights { vec4 items[2]; } weights;
buffer Sums { float items[]; } sums;
void main() { sums.items[params.size.x] = params.gain * weights.items[params.size.y].x; }
)");
    const ShaderProgram program = ShaderFolder::program("a.comp", ProgramKind::compute);
    const ShaderProgram hidden = with_opaque_uniforms(program);
    expect_valid(hidden);
    const ParamsBlock& params = hidden.interface.params;
    EXPECT_FALSE(params.push_constants);
    for (const ShaderBinding& binding : hidden.interface.bindings) EXPECT_NE(binding.binding, params.binding);
    const ShaderInterface now = reflected(hidden);
    ASSERT_TRUE(now.has_params);
    EXPECT_EQ(now.params, params);
    EXPECT_EQ(now.bindings, program.interface.bindings);
}

TEST_F(OpaqueUniforms, KeepArraysOfBlocks) {
    write("graph/a.comp", R"(#version 460
layout(local_size_x = 1) in;
uniform Choice { uint first; } choices[3];
buffer Sums { uint items[]; } sums;
void main() { for (int i = 0; i < 3; ++i) sums.items[i] = choices[i].first + choices[1].first; }
)");
    const ShaderProgram program = ShaderFolder::program("a.comp", ProgramKind::compute);
    const ShaderProgram hidden = with_opaque_uniforms(program);
    EXPECT_NE(hidden.modules[0].spirv, program.modules[0].spirv);
    expect_valid(hidden);
    const std::vector<uint32_t> indices = first_indices(program.modules[0], false);
    EXPECT_EQ(indices.size(), 2u);
    EXPECT_EQ(first_indices(hidden.modules[0], true), indices);
    EXPECT_EQ(reflected(hidden).bindings, program.interface.bindings);
}

TEST_F(OpaqueUniforms, LeaveShadersWithoutUniformsAsTheyAre) {
    write("graph/a.comp", R"(#version 460
layout(local_size_x = 1) in;
buffer Sums { uint items[]; } sums;
void main() { sums.items[0] = 1u; }
)");
    const ShaderProgram program = ShaderFolder::program("a.comp", ProgramKind::compute);
    EXPECT_EQ(with_opaque_uniforms(program).modules[0].spirv, program.modules[0].spirv);
}

// The module loads a variable of storage class Uniform (2) as a whole. glslang never produces this, so the
// SPIR-V words are written by hand.
TEST_F(OpaqueUniforms, LeaveProgramsThatTakeABlockAsOneValue) {
    ShaderProgram program;
    program.modules.push_back(
        {ShaderStage::compute,
         {0x07230203, 0x10600, 0, 9, 0, 4u << 16 | 59, 6, 7, 2, 4u << 16 | 61, 5, 8, 7}});
    EXPECT_FALSE(can_hide_uniforms(program.modules[0].spirv));
    EXPECT_EQ(with_opaque_uniforms(program).modules[0].spirv, program.modules[0].spirv);
}

}  // namespace
}  // namespace weft::vk
