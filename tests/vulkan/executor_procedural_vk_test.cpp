// Purpose: tests draws without a draw list: vertices differ only in their index, and instances are drawn in
// order.
#include "tests/vulkan/executor_fixture.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;
using ExecutorProceduralVk = ExecutorTest;

constexpr uint32_t kProceduralSide = 8;

// Instance i covers all columns from column i on. Each column must show the last instance that covers it.
TEST_F(ExecutorProceduralVk, instances_are_drawn_one_after_the_other) {
    write_shader("strip/strip.vert", R"(
        layout(location = 0) flat out uint shade;
        void main() {
            const vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 2.0;
            gl_Position = vec4(corner.x * 2.0 - 1.0 + float(gl_InstanceIndex) / 4.0, corner.y * 2.0 - 1.0, 0.5, 1.0);
            shade = uint(gl_InstanceIndex) + 1u;
        })");
    write_shader("strip/strip.frag", R"(
        layout(location = 0) flat in uint shade;
        layout(location = 0) out uint color;
        void main() { color = shade; })");
    GraphBuilder builder;
    const ResourceId target = builder.image("target", Format::r32u, kProceduralSide);
    PassDecl& draw =
        builder.pass("draw", PassKind::raster, {{"color", target, Access::color_write, {}, kNoId}});
    draw.vertices = 3;
    draw.instances = 5;
    use_shader(draw, "strip", ProgramKind::raster);
    builder.pass("read", PassKind::readback, {{"src", target, Access::copy_read, {}, kNoId}});
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 1);
    ASSERT_EQ(read.size(), 1u);
    const std::vector<uint32_t> texels = values_of<uint32_t>(read[0]);
    ASSERT_EQ(texels.size(), kProceduralSide * kProceduralSide);
    for (uint32_t y = 0; y < kProceduralSide; ++y)
        for (uint32_t x = 0; x < kProceduralSide; ++x)
            ASSERT_EQ(texels[y * kProceduralSide + x], std::min(x + 1, 5u)) << x << ", " << y;
}

}  // namespace
}  // namespace weft::vk
