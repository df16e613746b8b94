// Tests the rewriting of shaders for passes that draw several views. The rewritten modules must be valid,
// also after with_opaque_uniforms(), and must select the view or write the layer.
#include "vulkan/pipelines/lowered_views.h"

#include <algorithm>

#include "shader/gate/spirv_words.h"
#include "shader/gate/validate_spirv.h"
#include "tests/shader/shader_folder.h"
#include "vulkan/pipelines/opaque_uniforms.h"

namespace weft::vk {
namespace {

enum class How { multiview, layers };

ShaderProgram lowered(ShaderProgram program, How how) {
    for (ShaderModule& module : program.modules) {
        if (how == How::multiview) module.spirv = with_multiview(module.spirv, module.stage, 6);
        if (how == How::layers && module.stage == ShaderStage::vertex)
            module.spirv = with_layer_output(module.spirv, 2);
    }
    return program;
}

void expect_valid_program(const ShaderProgram& program) {
    for (const ShaderModule& module : program.modules)
        EXPECT_EQ(shader::spirv_fault(module.spirv), std::nullopt) << program.reference;
}

// Returns how many variables of the module are the built-in variable with this number.
size_t built_ins(const ShaderModule& module, uint32_t number) {
    constexpr uint32_t kDecorate = 71, kBuiltIn = 11;
    size_t count = 0;
    shader::SpirvReader reader(module.spirv);
    for (shader::SpirvInstruction i; reader.next(i);)
        count += i.opcode == kDecorate && i.operand(1) == kBuiltIn && i.operand(2) == number ? 1 : 0;
    return count;
}

class LoweredViews : public ShaderFolder {};

TEST_F(LoweredViews, LeaveShippedShadersValid) {
    const std::filesystem::path folder = std::filesystem::path(WEFT_SOURCE_DIR) / "shaders";
    const ShaderRoots roots{{folder}, folder / "include", {}};
    const std::pair<const char*, ProgramKind> shaders[]{{"forward", ProgramKind::raster},
                                                        {"gbuffer", ProgramKind::raster},
                                                        {"depth", ProgramKind::raster},
                                                        {"tonemap/tonemap.frag", ProgramKind::fullscreen}};
    for (const auto& [reference, kind] : shaders)
        for (const How how : {How::multiview, How::layers}) {
            const Result<ShaderProgram> program = compile_shader(reference, kind, roots);
            ASSERT_TRUE(program) << to_text(program.errors());
            for (const ShaderModule& module : program->modules) EXPECT_TRUE(can_select_view(module.spirv));
            const ShaderProgram now = lowered(*program, how);
            expect_valid_program(now);
            expect_valid_program(with_opaque_uniforms(now));
        }
}

TEST_F(LoweredViews, SelectTheViewInEachStageThatReadsIt) {
    constexpr uint32_t kViewIndex = 4440, kLayer = 9;
    const std::string block =
        "#version 460\nlayout(set = 0, binding = 1, std140) uniform View { mat4 matrix; vec4 more[2]; } "
        "view;\n"
        "layout(set = 0, binding = 0, std140) uniform Frame { vec4 color; } frame;\n";
    write("graph/a/a.vert", block + R"(
vec4 corner(int i) { return view.matrix * view.more[i & 1]; }
void main() { gl_Position = gl_VertexIndex > 2 ? corner(gl_VertexIndex) : vec4(0); }
)");
    write("graph/a/a.frag",
          "#version 460\nlayout(location = 0) out vec4 color; void main() { color = vec4(1); }\n");
    const ShaderProgram program = ShaderFolder::program("a", ProgramKind::raster);
    const ShaderProgram multiview = lowered(program, How::multiview), layers = lowered(program, How::layers);
    expect_valid_program(multiview);
    expect_valid_program(layers);
    for (size_t m = 0; m < program.modules.size(); ++m) {
        const bool vertex = program.modules[m].stage == ShaderStage::vertex;
        EXPECT_EQ(built_ins(multiview.modules[m], kViewIndex), vertex ? 1u : 0u);
        EXPECT_EQ(built_ins(layers.modules[m], kLayer), vertex ? 1u : 0u);
        // A stage that does not read the view stays as it is.
        if (!vertex) {
            EXPECT_EQ(multiview.modules[m].spirv, program.modules[m].spirv);
        }
    }
}

// The vertex stage of a fullscreen pass reads no view, but it must write the layer.
TEST_F(LoweredViews, WriteTheLayerEvenIfTheStageReadsNoView) {
    write("graph/a.frag",
          "#version 460\nlayout(location = 0) out vec4 color; void main() { color = vec4(1); }\n");
    const ShaderProgram layers =
        lowered(ShaderFolder::program("a.frag", ProgramKind::fullscreen), How::layers);
    expect_valid_program(layers);
    EXPECT_TRUE(std::ranges::any_of(layers.modules,
                                    [](const ShaderModule& module) { return built_ins(module, 9) == 1; }));
}

TEST_F(LoweredViews, CannotSelectFromACopyOfTheWholeBlock) {
    // OpCapability, OpMemoryModel and so on are left out: only the instructions that matter are here.
    constexpr uint32_t kPointer = 1, kVariable = 2, kBlock = 3, kCopy = 4;
    const std::vector<uint32_t> module{
        0x07230203, 0x00010600,    0,         5,         0, 4u << 16 | 71, kVariable, 34,
        0,          4u << 16 | 71, kVariable, 33,        1, 4u << 16 | 32, kPointer,  2,
        kBlock,     4u << 16 | 59, kPointer,  kVariable, 2, 4u << 16 | 61, kBlock,    kCopy,
        kVariable};
    EXPECT_FALSE(can_select_view(module));
}

}  // namespace
}  // namespace weft::vk
