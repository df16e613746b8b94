// Purpose: compares blits of the device with reference filters, which this file computes on the CPU. The
// tests cover images of different sizes, mips and layers, volumes, integer formats and depth.
#include <algorithm>
#include <cmath>

#include "tests/vulkan/executor_fixture.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

// Returns the value that the shaders write to a texel of the source image, computed on the CPU.
uint32_t pattern(uint32_t x, uint32_t y, uint32_t z) {
    return (x * 73u + y * 151u + z * 37u) % 256u;
}
constexpr const char* kPattern =
    "uint pattern(uvec3 at) { return (at.x * 73u + at.y * 151u + at.z * 37u) % 256u; }";

// The source or the target of a blit, as a box of texels.
struct Box {
    Extent3D extent;
    [[nodiscard]] size_t count() const { return size_t{extent.width} * extent.height * extent.depth; }
};

float texel(const Box& box, int x, int y, int z) {
    const auto clamped = [](int at, uint32_t side) {
        return static_cast<uint32_t>(std::clamp(at, 0, static_cast<int>(side) - 1));
    };
    return static_cast<float>(pattern(clamped(x, box.extent.width), clamped(y, box.extent.height),
                                      clamped(z, box.extent.depth))) /
           255.0F;
}

// Returns the centre of a target texel along one axis, measured in source texels.
double place(uint32_t at, uint32_t target, uint32_t source) {
    return (at + 0.5) * source / target;
}

double linear(const Box& from, const Box& to, uint32_t x, uint32_t y, uint32_t z) {
    const std::array<double, 3> at{place(x, to.extent.width, from.extent.width) - 0.5,
                                   place(y, to.extent.height, from.extent.height) - 0.5,
                                   place(z, to.extent.depth, from.extent.depth) - 0.5};
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::array<int, 3> near{};
        for (size_t axis = 0; axis < 3; ++axis) {
            const double low = std::floor(at[axis]);
            const bool high = (corner >> axis & 1) != 0;
            near[axis] = static_cast<int>(low) + (high ? 1 : 0);
            weight *= high ? at[axis] - low : 1 - (at[axis] - low);
        }
        sum += weight * static_cast<double>(texel(from, near[0], near[1], near[2]));
    }
    return sum;
}

class ExecutorBlitVk : public ExecutorTest {
 protected:
    static ResourceId image(GraphBuilder& builder, const std::string& name, Format format, Extent3D extent,
                            uint32_t mips = 1, uint32_t layers = 1) {
        const ResourceId id = builder.image(name, format, extent.width, mips, layers);
        builder.edit(id).extent = extent;
        if (extent.depth > 1) builder.edit(id).image_kind = ImageKind::d3;
        return id;
    }

    static void add_blit(GraphBuilder& builder, ResourceId from, ResourceId to, SamplerFilter filter,
                         std::optional<SubresourceRange> from_part = {},
                         std::optional<SubresourceRange> to_part = {}, const std::string& name = "blit") {
        PassDecl& blit = builder.pass(name, PassKind::blit,
                                      {{"src", from, Access::blit_read, from_part, kNoId},
                                       {"dst", to, Access::blit_write, to_part, kNoId}});
        blit.uses[0].sampler.filter = filter;
    }

    // Adds a compute pass that fills one mip. `image_type`, `place` and `value` are GLSL text: the pass
    // stores `value` at the coordinates `place`. Both can use `at` (uvec3); at.z is the layer, or the z of a
    // volume.
    void add_fill(GraphBuilder& builder, const std::string& name, ResourceId target, uint32_t mip,
                  const std::string& image_type, const std::string& place, const std::string& value) {
        const ResourceDecl& decl = builder.resource(target);
        const Extent3D extent = mip_extent(decl.extent, mip);
        write_shader(name + ".comp", "layout(local_size_x = 1) in;\nlayout(" + image_type + " dst;\n" +
                                         kPattern + "void main() { uvec3 at = gl_GlobalInvocationID; " +
                                         "imageStore(dst, " + place + ", " + value + "); }");
        PassDecl& fill =
            builder.compute(name, {{"dst", target, Access::storage_write,
                                    SubresourceRange{mip, 1, 0, decl.layers, aspect::kColor}, kNoId}});
        fill.groups = {extent.width, extent.height, std::max(extent.depth, decl.layers)};
        use_shader(fill, name + ".comp", ProgramKind::compute);
    }

    void add_float_fill(GraphBuilder& builder, ResourceId target) {
        const bool volume = builder.resource(target).extent.depth > 1;
        add_fill(builder, "fill", target, 0,
                 volume ? "r32f) uniform writeonly image3D" : "r32f) uniform writeonly image2D",
                 volume ? "ivec3(at)" : "ivec2(at.xy)", "vec4(float(pattern(at)) / 255.0)");
    }

    std::vector<ReadbackData> run(const GraphBuilder& builder, uint32_t frames = 1) {
        const auto executor = executor_for(input_for(compile_plan(builder)));
        return executor == nullptr ? std::vector<ReadbackData>{} : run_frames(*executor, frames);
    }

    static void add_readback(GraphBuilder& builder, ResourceId source,
                             std::optional<SubresourceRange> part = {}) {
        builder.pass("read", PassKind::readback, {{"src", source, Access::copy_read, part, kNoId}});
    }

    void expect_linear(Extent3D from, Extent3D to) {
        GraphBuilder builder;
        const ResourceId source = image(builder, "source", Format::r32f, from);
        const ResourceId target = image(builder, "target", Format::r32f, to);
        add_float_fill(builder, source);
        add_blit(builder, source, target, SamplerFilter::linear);
        add_readback(builder, target);
        const std::vector<ReadbackData> read = run(builder, 2);
        ASSERT_EQ(read.size(), 2u);
        for (const ReadbackData& data : read) {
            const std::vector<float> texels = values_of<float>(data);
            ASSERT_EQ(texels.size(), Box{to}.count());
            size_t i = 0;
            for (uint32_t z = 0; z < to.depth; ++z)
                for (uint32_t y = 0; y < to.height; ++y)
                    for (uint32_t x = 0; x < to.width; ++x, ++i)
                        // A device may have only eight bits of precision for positions between two texels.
                        ASSERT_NEAR(texels[i], linear({from}, {to}, x, y, z), 1.0 / 256)
                            << x << ", " << y << ", " << z;
        }
    }
};

TEST_F(ExecutorBlitVk, scales_down_linearly) {
    expect_linear({16, 12, 1}, {5, 7, 1});
    expect_linear({16, 16, 1}, {8, 8, 1});
}

TEST_F(ExecutorBlitVk, scales_up_linearly) {
    expect_linear({5, 3, 1}, {16, 13, 1});
}

TEST_F(ExecutorBlitVk, scales_volumes_linearly) {
    expect_linear({6, 4, 8}, {3, 8, 5});
}

TEST_F(ExecutorBlitVk, integers_take_the_nearest_texel) {
    for (const auto& [from, to] :
         {std::pair{Extent3D{7, 9, 1}, Extent3D{3, 5, 1}}, std::pair{Extent3D{3, 5, 1}, Extent3D{7, 9, 1}}}) {
        GraphBuilder builder;
        const ResourceId source = image(builder, "source", Format::r32u, from);
        const ResourceId target = image(builder, "target", Format::r32u, to);
        add_fill(builder, "fill", source, 0, "r32ui) uniform writeonly uimage2D", "ivec2(at.xy)",
                 "uvec4(pattern(at))");
        add_blit(builder, source, target, SamplerFilter::nearest);
        add_readback(builder, target);
        const std::vector<ReadbackData> read = run(builder);
        ASSERT_EQ(read.size(), 1u);
        const std::vector<uint32_t> texels = values_of<uint32_t>(read[0]);
        ASSERT_EQ(texels.size(), Box{to}.count());
        for (uint32_t i = 0; i < texels.size(); ++i) {
            const auto x = static_cast<uint32_t>(place(i % to.width, to.width, from.width));
            const auto y = static_cast<uint32_t>(place(i / to.width, to.height, from.height));
            ASSERT_EQ(texels[i], pattern(x, y, 0)) << i;
        }
    }
}

// One blit scales mips 1 and 2 of the source to mips 0 and 1 of the target, in layers 1 and 2. Layer 0 of the
// target must keep the clear value 7.
TEST_F(ExecutorBlitVk, mips_and_layers_are_those_of_the_uses) {
    GraphBuilder builder;
    const ResourceId source = image(builder, "source", Format::r32u, {12, 12, 1}, 3, 3);
    const ResourceId target = image(builder, "target", Format::r32u, {2, 2, 1}, 2, 3);
    const auto fill = [&](uint32_t mip) {
        add_fill(builder, "fill" + std::to_string(mip), source, mip, "r32ui) uniform writeonly uimage2DArray",
                 "ivec3(at)", "uvec4(pattern(at) + " + std::to_string(1000 * mip) + "u)");
    };
    fill(0);
    fill(1);
    fill(2);
    builder.pass("clear", PassKind::clear, {{"dst", target, Access::clear_write, {}, kNoId}}).clear = {7, 0,
                                                                                                       0, 0};
    add_blit(builder, source, target, SamplerFilter::nearest, SubresourceRange{1, 2, 1, 2, aspect::kColor},
             SubresourceRange{0, 2, 1, 2, aspect::kColor});
    add_readback(builder, target);
    const std::vector<ReadbackData> read = run(builder);
    ASSERT_EQ(read.size(), 1u);
    std::vector<uint32_t> wanted;
    for (uint32_t mip = 0; mip < 2; ++mip)
        for (uint32_t layer = 0; layer < 3; ++layer)
            for (uint32_t y = 0; y < 2u >> mip; ++y)
                for (uint32_t x = 0; x < 2u >> mip; ++x) {
                    // Mip 1 of the source is reduced from 6 × 6 to 2 × 2 texels, mip 2 from 3 × 3 to 1 × 1.
                    // The nearest source texel is the centre of a block of 3 × 3 texels.
                    wanted.push_back(layer == 0 ? 7
                                                : pattern(3 * x + 1, 3 * y + 1, layer) + 1000 * (mip + 1));
                }
    EXPECT_EQ(values_of<uint32_t>(read[0]), wanted);
}

// Each of the mips 1 to 3 is made from the previous mip of the same image.
TEST_F(ExecutorBlitVk, a_chain_of_mips_is_blitted_within_an_image) {
    constexpr uint32_t kSide = 8, kMips = 4;
    GraphBuilder builder;
    const ResourceId chain = image(builder, "chain", Format::r32f, {kSide, kSide, 1}, kMips);
    add_float_fill(builder, chain);
    for (uint32_t mip = 1; mip < kMips; ++mip)
        add_blit(builder, chain, chain, SamplerFilter::linear, test::one_cell(mip - 1), test::one_cell(mip),
                 "blit" + std::to_string(mip));
    add_readback(builder, chain, test::one_cell(kMips - 1));
    const std::vector<ReadbackData> read = run(builder, 3);
    ASSERT_EQ(read.size(), 3u);
    double sum = 0;
    for (int y = 0; y < static_cast<int>(kSide); ++y)
        for (int x = 0; x < static_cast<int>(kSide); ++x)
            sum += static_cast<double>(texel({{kSide, kSide, 1}}, x, y, 0));
    for (const ReadbackData& data : read) {
        const std::vector<float> texels = values_of<float>(data);
        ASSERT_EQ(texels.size(), 1u);
        EXPECT_NEAR(texels[0], sum / (kSide * kSide), 1.0 / 256) << "the average of all";
    }
}

TEST_F(ExecutorBlitVk, depth_takes_the_nearest_texel) {
    constexpr FormatFeatureMask kBlit = format_feature::kBlitSrc | format_feature::kBlitDst;
    if ((device().profile().features(Format::d32f) & kBlit) != kBlit)
        GTEST_SKIP() << "the device blits no depth";
    write_shader("depth.frag", std::string(kPattern) + R"(
        void main() { gl_FragDepth = float(pattern(uvec3(gl_FragCoord.xy, 0))) / 255.0; })");
    GraphBuilder builder;
    const ResourceId source = image(builder, "source", Format::d32f, {6, 6, 1});
    const ResourceId target = image(builder, "target", Format::d32f, {2, 4, 1});
    PassDecl& fill =
        builder.pass("fill", PassKind::fullscreen, {{"depth", source, Access::depth_write, {}, kNoId}});
    fill.state.depth_test = fill.state.depth_write = true;
    fill.state.depth_compare = CompareOp::always;
    use_shader(fill, "depth.frag", ProgramKind::fullscreen);
    add_blit(builder, source, target, SamplerFilter::nearest);
    add_readback(builder, target);
    const std::vector<ReadbackData> read = run(builder);
    ASSERT_EQ(read.size(), 1u);
    const std::vector<float> texels = values_of<float>(read[0]);
    ASSERT_EQ(texels.size(), 8u);
    for (uint32_t i = 0; i < texels.size(); ++i)
        ASSERT_NEAR(
            texels[i],
            texel({{6, 6, 1}}, static_cast<int>(place(i % 2, 2, 6)), static_cast<int>(place(i / 2, 4, 6)), 0),
            1e-6)
            << i;
}

}  // namespace
}  // namespace weft::vk
