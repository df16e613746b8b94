// Purpose: tests raster passes: a pipeline for every variant of a draw list, vertex streams and descriptor
// sets that fit the shader, and the rasterisation state of the pass.
#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/triangle_source.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kRasterSide = 8;

class ExecutorRasterVk : public ExecutorTest {
 protected:
    // Adds the raster pass "draw", which draws to an rgba32f image and a d32f depth image after clearing
    // them. run() adds a readback of the colour image.
    PassDecl& add_draw(GraphBuilder& builder, const std::string& shader) {
        target_ = builder.image("target", Format::rgba32f, kRasterSide);
        const ResourceId depth = builder.image("depth", Format::d32f, kRasterSide);
        PassDecl& draw = builder.pass("draw", PassKind::raster,
                                      {{"color", target_, Access::color_write, {}, kNoId},
                                       {"depth", depth, Access::depth_write, {}, kNoId}});
        draw.colors[0].clear = {-1, -1, -1, -1};
        draw.state.depth_test = draw.state.depth_write = true;
        draw.state.depth_compare = CompareOp::greater_equal;
        draw.draw_lists = {"opaque"};
        use_shader(draw, shader, ProgramKind::raster);
        return draw;
    }

    void write_flat_shader() const {
        write_shader("flat/flat.vert", R"(
            layout(location = 0) in float weight;
            layout(location = 1) in vec2 position;
            layout(set = 0, binding = 0) uniform View { vec4 color; } view;
            layout(location = 0) out vec4 color;
            void main() {
                color = view.color * weight;
                gl_Position = vec4(position, 0.5, 1.0);
            })");
        write_shader("flat/flat.frag", R"(
            layout(constant_id = 3) const bool TINT = false;
            layout(set = 3, binding = 0) uniform Draw { vec4 color; } draw;
            layout(location = 0) in vec4 color;
            layout(location = 0) out vec4 target;
            void main() { target = TINT ? color * draw.color : color; })");
    }

    std::vector<float> run(GraphBuilder& builder, const TriangleSource& source) {
        builder.pass("read", PassKind::readback, {{"src", target_, Access::copy_read, {}, kNoId}});
        ExecutorInput input = input_for(compile_plan(builder));
        imports_.imports.emplace("opaque", TriangleSource::draw_list("opaque"));
        input.imports = &imports_;
        input.draws = &source;
        const auto executor = executor_for(std::move(input));
        if (executor == nullptr) return {};
        const std::vector<ReadbackData> read = run_frames(*executor, 1);
        return read.empty() ? std::vector<float>{} : values_of<float>(read[0]);
    }

    // Checks the colour image: the triangle must cover the texels above the diagonal from bottom left to top
    // right.
    static void expect_triangle(const std::vector<float>& texels, const std::array<float, 4>& inside) {
        ASSERT_EQ(texels.size(), kRasterSide * kRasterSide * 4);
        for (uint32_t y = 0; y < kRasterSide; ++y)
            for (uint32_t x = 0; x < kRasterSide; ++x)
                for (uint32_t c = 0; c < 4; ++c) {
                    // Texels whose centre is exactly on the triangle's edge are skipped, because the
                    // rasteriser's fill rule decides about them.
                    if (x + y == kRasterSide - 1) continue;
                    ASSERT_EQ(texels[(y * kRasterSide + x) * 4 + c], x + y < kRasterSide - 1 ? inside[c] : -1)
                        << x << ", " << y;
                }
    }

    ResourceId target_ = kNoId;
    ImportCatalog imports_;
};

TEST_F(ExecutorRasterVk, draws_every_variant_of_a_list_with_its_constants) {
    write_flat_shader();
    const TriangleSource source(device());
    GraphBuilder builder;
    add_draw(builder, "flat");
    // Variant 1 of the list draws over variant 0. The colour of variant 1 is the product of the colours in
    // set 3 and set 0.
    expect_triangle(run(builder, source), {0.25F * 4, 0.5F * 3, 0.75F * 2, 1});
    EXPECT_EQ(source.drawn, (std::vector<std::string>{"opaque/0", "opaque/1"}));
}

TEST_F(ExecutorRasterVk, the_view_of_the_pass_chooses_the_frame_set) {
    write_flat_shader();
    const TriangleSource source(device());
    GraphBuilder builder;
    add_draw(builder, "flat").view = "sun(0)";
    expect_triangle(run(builder, source), {16, 9, 4, 1});
}

TEST_F(ExecutorRasterVk, cull_mode_and_front_face_come_from_the_pass_or_the_draw) {
    write_flat_shader();
    TriangleSource source(device());
    struct Case {
        CullMode cull;
        FrontFace pass_face, draw_face;
        bool seen;
    };
    const FrontFace ccw = FrontFace::counter_clockwise, cw = FrontFace::clockwise;
    for (const Case& c :
         {Case{CullMode::none, ccw, ccw, true}, Case{CullMode::back, ccw, cw, true},
          Case{CullMode::back, cw, ccw, false}, Case{CullMode::front, cw, cw, true},
          Case{CullMode::material, cw, ccw, true}, Case{CullMode::material, ccw, cw, false}}) {
        GraphBuilder builder;
        PassDecl& draw = add_draw(builder, "flat");
        draw.state.cull = c.cull;
        draw.state.front_face = c.pass_face;
        source.front_face = c.draw_face;
        const std::vector<float> texels = run(builder, source);
        ASSERT_FALSE(texels.empty());
        EXPECT_EQ(texels[0] > 0, c.seen) << static_cast<int>(c.cull) << static_cast<int>(c.pass_face);
    }
}

TEST_F(ExecutorRasterVk, scissor_and_viewport_are_the_pass_s) {
    write_flat_shader();
    const TriangleSource source(device());
    GraphBuilder builder;
    PassDecl& draw = add_draw(builder, "flat");
    draw.state.viewport = RectPx{4, 0, 4, 4};
    draw.state.scissor = RectPx{5, 0, 8 - 5, 1};
    const std::vector<float> texels = run(builder, source);
    ASSERT_EQ(texels.size(), kRasterSide * kRasterSide * 4);
    for (uint32_t i = 0; i < kRasterSide * kRasterSide; ++i)
        // The centre of texel 7 is exactly on the triangle's edge, so the rasteriser's fill rule decides
        // about this texel.
        if (i != 7) {
            EXPECT_EQ(texels[i * 4] > 0, i == 5 || i == 6) << i;
        }
}

TEST_F(ExecutorRasterVk, a_failing_depth_test_draws_nothing) {
    write_flat_shader();
    const TriangleSource source(device());
    GraphBuilder builder;
    PassDecl& draw = add_draw(builder, "flat");
    draw.depth->clear = {1, 0, 0, 0};
    const std::vector<float> texels = run(builder, source);
    ASSERT_FALSE(texels.empty());
    EXPECT_EQ(texels[0], -1);
}

TEST_F(ExecutorRasterVk, a_pass_without_draw_lists_clears) {
    write_flat_shader();
    const TriangleSource source(device());
    GraphBuilder builder;
    add_draw(builder, "flat").draw_lists.clear();
    EXPECT_EQ(run(builder, source), std::vector<float>(kRasterSide * kRasterSide * 4, -1));
    EXPECT_TRUE(source.drawn.empty());
}

}  // namespace
}  // namespace weft::vk
