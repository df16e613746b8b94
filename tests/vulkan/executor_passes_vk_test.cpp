// Purpose: tests the results of compute, fullscreen, clear, copy and readback passes, byte by byte. There
// must be no validation messages.
#include "tests/vulkan/executor_fixture.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;
using ExecutorPassesVk = ExecutorTest;

constexpr const char* kFill = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui) uniform writeonly uimage2D dst;
void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(at, uvec2(imageSize(dst))))) return;
    imageStore(dst, ivec2(at), uvec4(at.y * 100u + at.x));
})";

void add_readback(GraphBuilder& builder, const std::string& name, ResourceId source) {
    builder.pass(name, PassKind::readback, {{"src", source, Access::copy_read, {}, kNoId}});
}

TEST_F(ExecutorPassesVk, compute_then_fullscreen_then_readback) {
    write_shader("fill.comp", kFill);
    write_shader("double.frag", R"(
        uniform usampler2D src;
        layout(location = 0) out uint dst;
        void main() { dst = 2u * texelFetch(src, ivec2(gl_FragCoord.xy), 0).r; })");
    GraphBuilder builder;
    const ResourceId filled = builder.image("filled", Format::r32u, 13);
    const ResourceId doubled = builder.image("doubled", Format::r32u, 13);
    PassDecl& fill = builder.compute("fill", {{"dst", filled, Access::storage_write, {}, kNoId}});
    use_shader(fill, "fill.comp", ProgramKind::compute);
    fill.groups = {2, 2, 1};
    use_shader(builder.pass("double", PassKind::fullscreen,
                            {{"src", filled, Access::sampled_read, {}, kNoId},
                             {"dst", doubled, Access::color_write, {}, kNoId}}),
               "double.frag", ProgramKind::fullscreen);
    add_readback(builder, "read", doubled);
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    EXPECT_EQ(executor->transient_bytes(), executor->plan().memory.heap_bytes);
    const std::vector<ReadbackData> read = run_frames(*executor, 1);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].pass, "read");
    EXPECT_EQ(read[0].format, Format::r32u);
    EXPECT_EQ(read[0].extent, (Extent3D{13, 13, 1}));
    const std::vector<uint32_t> texels = values_of<uint32_t>(read[0]);
    ASSERT_EQ(texels.size(), 13u * 13u);
    for (uint32_t i = 0; i < texels.size(); ++i) ASSERT_EQ(texels[i], 2 * (i / 13 * 100 + i % 13)) << i;
}

TEST_F(ExecutorPassesVk, clear_and_copy_of_images_with_mips_and_layers) {
    GraphBuilder builder;
    const ResourceId from = builder.image("from", Format::rgba8, 5, 3, 2);
    const ResourceId to = builder.image("to", Format::rgba8, 5, 3, 2);
    builder.pass("clear", PassKind::clear, {{"dst", from, Access::clear_write, {}, kNoId}}).clear = {1, 0, 1,
                                                                                                     0};
    builder.pass("copy", PassKind::copy,
                 {{"src", from, Access::copy_read, {}, kNoId}, {"dst", to, Access::copy_write, {}, kNoId}});
    add_readback(builder, "read", to);
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 1);
    ASSERT_EQ(read.size(), 1u);
    const std::vector<uint32_t> texels = values_of<uint32_t>(read[0]);
    ASSERT_EQ(texels.size(), 2u * (25 + 4 + 1));
    for (const uint32_t texel : texels) ASSERT_EQ(texel, 0x00FF00FFu);
}

TEST_F(ExecutorPassesVk, clear_values_of_integer_images_and_buffers_are_integers) {
    GraphBuilder builder;
    const ResourceId image = builder.image("image", Format::r32i, 4);
    const ResourceId words = builder.buffer("words", 64);
    const ResourceId copied = builder.buffer("copied", 64);
    builder.pass("clear_image", PassKind::clear, {{"dst", image, Access::clear_write, {}, kNoId}}).clear = {
        -7, 0, 0, 0};
    builder.pass("clear_words", PassKind::clear, {{"dst", words, Access::clear_write, {}, kNoId}}).clear = {
        9, 0, 0, 0};
    builder.pass(
        "copy", PassKind::copy,
        {{"src", words, Access::copy_read, {}, kNoId}, {"dst", copied, Access::copy_write, {}, kNoId}});
    add_readback(builder, "read_image", image);
    add_readback(builder, "read_words", copied);
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 1);
    ASSERT_EQ(read.size(), 2u);
    for (const ReadbackData& data : read) {
        const std::vector<int32_t> values = values_of<int32_t>(data);
        ASSERT_EQ(values.size(), 16u);
        for (const int32_t value : values) ASSERT_EQ(value, data.pass == "read_image" ? -7 : 9);
    }
}

// Vulkan requires that the buffer offset of a depth copy is a multiple of four bytes. This d16 image has
// 3 × 3 texels and two mips. Mip 0 has 18 bytes, so mip 1 cannot follow directly in the buffer. But the data
// that the executor returns must have no gap between the mips.
TEST_F(ExecutorPassesVk, depth_reads_back_tightly_packed) {
    GraphBuilder builder;
    const ResourceId depth = builder.image("depth", Format::d16, 3, 2);
    builder.pass("clear", PassKind::clear, {{"dst", depth, Access::clear_write, {}, kNoId}}).clear = {1, 0, 0,
                                                                                                      0};
    add_readback(builder, "read", depth);
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 1);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(values_of<uint16_t>(read[0]), std::vector<uint16_t>(9 + 1, 0xFFFF));
}

// Blending adds to the previous content of the image. The colour mask excludes the blue channel, which must
// not change.
TEST_F(ExecutorPassesVk, fullscreen_blends_onto_what_is_there) {
    write_shader("add.frag", R"(
        layout(location = 0) out vec4 dst;
        void main() { dst = vec4(0.25, 0.5, 0.125, 0.0); })");
    GraphBuilder builder;
    const ResourceId image = builder.image("image", Format::rgba32f, 4);
    builder.pass("clear", PassKind::clear, {{"dst", image, Access::clear_write, {}, kNoId}}).clear = {1, 2, 3,
                                                                                                      4};
    PassDecl& add =
        builder.pass("add", PassKind::fullscreen, {{"dst", image, Access::color_read_write, {}, kNoId}});
    use_shader(add, "add.frag", ProgramKind::fullscreen);
    add.colors[0].blend.enabled = true;
    add.colors[0].blend.src_color = add.colors[0].blend.dst_color = BlendFactor::one;
    add.colors[0].blend.write_mask = 1 | 2 | 8;
    add.colors[0].blend.dst_alpha = BlendFactor::one;
    add_readback(builder, "read", image);
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 1);
    ASSERT_EQ(read.size(), 1u);
    const std::vector<float> values = values_of<float>(read[0]);
    ASSERT_EQ(values.size(), 64u);
    for (size_t i = 0; i < values.size(); i += 4) {
        ASSERT_EQ(values[i], 1.25F);
        ASSERT_EQ(values[i + 1], 2.5F);
        ASSERT_EQ(values[i + 2], 3.0F);
        ASSERT_EQ(values[i + 3], 4.0F);
    }
}

// A graph may leave bindings of a shader without a resource. The descriptors of such bindings must still be
// valid.
TEST_F(ExecutorPassesVk, bindings_that_the_graph_leaves_out_have_dummies) {
    write_shader("optional.comp", R"(
        layout(local_size_x = 1) in;
        layout(constant_id = 0) const bool HAS_extra = true;
        uniform sampler2D extra;
        uniform samplerCube environment;
        uniform sampler2DShadow shadow;
        uniform usampler2DArray ids;
        layout(rgba16f) uniform readonly image2D store;
        layout(std430) readonly buffer Table { vec4 rows[]; } table;
        uniform Settings { vec4 tint; } settings;
        layout(std430) writeonly buffer Words { uint words[]; } dst;
        void main() {
            uint value = 5u;
            if (HAS_extra) {
                vec4 sum = texture(extra, vec2(0)) + textureLod(environment, vec3(1), 0.0) + settings.tint;
                sum += imageLoad(store, ivec2(0)) + table.rows[0] + texture(shadow, vec3(0));
                value = uint(sum.x) + texelFetch(ids, ivec3(0), 0).r;
            }
            dst.words[0] = value;
        })");
    GraphBuilder builder;
    const ResourceId words = builder.buffer("words", 4);
    PassDecl& pass = builder.compute("optional", {{"dst", words, Access::storage_write, {}, kNoId}});
    use_shader(pass, "optional.comp", ProgramKind::compute);
    pass.spec_values.push_back({0, ScalarType::boolean, 0});
    add_readback(builder, "read", words);
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 1);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(values_of<uint32_t>(read[0]), std::vector<uint32_t>{5});
}

}  // namespace
}  // namespace weft::vk
