// Purpose: tests passes that share a rendering scope (vkCmdBeginRendering to vkCmdEndRendering). The passes
// must draw in order, each with its own state. The scope must use the store operations of its last pass.
#include <cmath>

#include "tests/graph/compile/naive_plan.h"
#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/triangle_source.h"
#include "weft/check/check_plan.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kScopesSide = 8;
constexpr uint32_t kScopesFrames = 3;

float from_half(uint16_t bits) {
    const int exponent = bits >> 10 & 31;
    if (exponent == 0) return std::ldexp(static_cast<float>(bits & 1023), -24);
    return std::ldexp(static_cast<float>(1024 | (bits & 1023)), exponent - 25);
}

uint32_t continued(const FramePlan& plan) {
    uint32_t count = 0;
    for (const PassStep& step : plan.barriers.steps) count += step.merges_render_pass ? 1 : 0;
    return count;
}

class ExecutorScopesVk : public ExecutorTest {
 protected:
    std::vector<ReadbackData> run(FramePlan plan, bool timestamps, const TriangleSource* source = nullptr) {
        ExecutorInput input = input_for(std::move(plan));
        input.timestamps = timestamps;
        if (source != nullptr) {
            imports_.imports.emplace("opaque", TriangleSource::draw_list("opaque"));
            input.imports = &imports_;
            input.draws = source;
        }
        const auto executor = executor_for(std::move(input));
        if (executor == nullptr) return {};
        std::vector<ReadbackData> read = run_frames(*executor, kScopesFrames);
        EXPECT_EQ(read.size(), kScopesFrames);
        for (const FrameTiming& frame : executor->take_timings())
            for (const auto& pass : frame.passes) EXPECT_EQ(pass.gpu_ms >= 0, timestamps) << pass.pass;
        EXPECT_EQ(device().messages().count(), 0u);
        return read;
    }

    // Adds a fullscreen pass that writes `value` to all texels inside its scissor.
    void add_fill(GraphBuilder& builder, const char* name, const char* value, ResourceId target,
                  const BlendState& blend, const std::optional<RectPx>& scissor) {
        const std::string file = std::string(name) + ".frag";
        write_shader(file, "layout(location = 0) out vec4 dst;\nvoid main() { dst = vec4(" +
                               std::string(value) + "); }");
        const Access access = blend.enabled ? Access::color_read_write : Access::color_write;
        PassDecl& pass = builder.pass(name, PassKind::fullscreen, {{"dst", target, access, {}, kNoId}});
        pass.colors.front().blend = blend;
        pass.state.scissor = scissor;
        use_shader(pass, file, ProgramKind::fullscreen);
    }

    // Adds a raster pass that draws the triangle of the draw list at the depth `z`.
    PassDecl& add_draw(GraphBuilder& builder, const std::string& name, const char* z, const char* color,
                       const std::vector<test::BuilderUse>& uses) {
        write_shader(name + "/" + name + ".vert",
                     "layout(location = 0) in vec2 position;\n"
                     "void main() { gl_Position = vec4(position, " +
                         std::string(z) + ", 1.0); }");
        write_shader(name + "/" + name + ".frag",
                     "layout(constant_id = 3) const bool TINT = false;\n"
                     "layout(location = 0) out vec4 target;\n"
                     "void main() { target = vec4(" +
                         std::string(color) + " + (TINT ? 1.0 : 0.0)); }");
        PassDecl& draw = builder.pass(name, PassKind::raster, uses);
        draw.state.depth_test = draw.state.depth_write = true;
        draw.state.depth_compare = CompareOp::greater_equal;
        draw.draw_lists = {"opaque"};
        use_shader(draw, name, ProgramKind::raster);
        return draw;
    }

    ImportCatalog imports_;
};

// "base" writes x, "plus" adds y inside its scissor, and "times" multiplies by 3 inside its scissor. Inside
// both scissors the result must be (x + y) * 3. Another order of the passes would give another value.
TEST_F(ExecutorScopesVk, blends_in_one_scope_keep_their_order_and_their_scissors) {
    BlendState add, multiply;
    add.enabled = multiply.enabled = true;
    add.dst_color = add.dst_alpha = BlendFactor::one;
    multiply.src_color = BlendFactor::dst_color;
    multiply.src_alpha = BlendFactor::dst_alpha;
    GraphBuilder builder;
    const ResourceId target = builder.image("target", Format::rgba16f, kScopesSide);
    add_fill(builder, "base", "gl_FragCoord.x - 0.5", target, {}, {});
    add_fill(builder, "plus", "gl_FragCoord.y - 0.5", target, add,
             RectPx{0, 0, kScopesSide / 2, kScopesSide});
    add_fill(builder, "times", "3.0", target, multiply, RectPx{0, 2, kScopesSide, kScopesSide - 2});
    builder.pass("read", PassKind::readback, {{"src", target, Access::copy_read, {}, kNoId}});
    const FramePlan plan = compile_plan(builder);
    ASSERT_EQ(continued(plan), 2u);
    ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    const std::vector<ReadbackData> naive =
        run(test::naive_plan(plan.graph, query_memory_needs(device(), plan.graph)), false);
    for (const bool timestamps : {false, true}) {
        const std::vector<ReadbackData> read = run(plan, timestamps);
        for (size_t frame = 0; frame < read.size() && frame < naive.size(); ++frame) {
            EXPECT_TRUE(read[frame].bytes == naive[frame].bytes);
            const std::vector<uint16_t> halves = values_of<uint16_t>(read[frame]);
            ASSERT_EQ(halves.size(), kScopesSide * kScopesSide * 4);
            for (uint32_t i = 0; i < halves.size(); ++i) {
                const uint32_t x = i / 4 % kScopesSide, y = i / 4 / kScopesSide;
                const uint32_t sum = x < kScopesSide / 2 ? x + y : x;
                ASSERT_EQ(from_half(halves[i]), static_cast<float>(y < 2 ? sum : sum * 3)) << x << ", " << y;
            }
        }
    }
}

// The near triangle is clipped to the left half of the image. The far triangle is drawn later and must be
// visible only in the right half, because the depth test hides it on the left.
TEST_F(ExecutorScopesVk, a_depth_tested_pair_in_one_scope_sees_its_depth) {
    const TriangleSource source(device());
    GraphBuilder builder;
    const ResourceId target = builder.image("target", Format::rgba32f, kScopesSide);
    const ResourceId depth = builder.image("depth", Format::d32f, kScopesSide);
    PassDecl& near = add_draw(builder, "near", "0.75", "3.0",
                              {{"color", target, Access::color_write, {}, kNoId},
                               {"depth", depth, Access::depth_write, {}, kNoId}});
    near.colors[0].clear = {-1, -1, -1, -1};
    near.state.scissor = RectPx{0, 0, kScopesSide / 2, kScopesSide};
    add_draw(builder, "far", "0.25", "5.0",
             {{"color", target, Access::color_read_write, {}, kNoId},
              {"depth", depth, Access::depth_read_write, {}, kNoId}});
    builder.pass("read", PassKind::readback, {{"src", target, Access::copy_read, {}, kNoId}});
    const FramePlan plan = compile_plan(builder);
    ASSERT_EQ(continued(plan), 1u);
    ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    const std::vector<ReadbackData> naive =
        run(test::naive_plan(plan.graph, query_memory_needs(device(), plan.graph)), false, &source);
    for (const bool timestamps : {false, true}) {
        const std::vector<ReadbackData> read = run(plan, timestamps, &source);
        for (size_t frame = 0; frame < read.size() && frame < naive.size(); ++frame) {
            EXPECT_TRUE(read[frame].bytes == naive[frame].bytes);
            const std::vector<float> texels = values_of<float>(read[frame]);
            ASSERT_EQ(texels.size(), kScopesSide * kScopesSide * 4);
            for (uint32_t i = 0; i < texels.size(); ++i) {
                const uint32_t x = i / 4 % kScopesSide, y = i / 4 / kScopesSide;
                // Texels whose centre is exactly on the triangle's edge are skipped, because the rasteriser's
                // fill rule decides about them.
                if (x + y == kScopesSide - 1) continue;
                // Each pass also draws the second variant of the list, which adds 1 to the colour: 3 + 1 on
                // the left, 5 + 1 on the right.
                const float inside = x < kScopesSide / 2 ? 4 : 6;
                ASSERT_EQ(texels[i], x + y < kScopesSide - 1 ? inside : -1) << x << ", " << y;
            }
        }
    }
}

}  // namespace
}  // namespace weft::vk
