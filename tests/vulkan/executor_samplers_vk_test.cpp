// Purpose: compares lookups through samplers with results that this file computes on the CPU: the least and
// the greatest texel of a footprint, limits and bias of the level of detail, comparisons, and anisotropy.
#include <algorithm>
#include <cmath>

#include "tests/vulkan/executor_fixture.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

// Returns the value that the shaders write to a texel of the sampled image, computed on the CPU.
float shade(int x, int y, uint32_t mip) {
    return static_cast<float>((x * 73 + y * 151 + static_cast<int>(mip) * 57) % 256);
}
constexpr const char* kShade =
    "float shade(ivec2 at, int mip) { return (at.x * 73 + at.y * 151 + mip * 57) % 256; }";

constexpr uint32_t kSampledSide = 8, kSampledMips = 4;

// One lookup: the position in texels of mip 0, and the level of detail that the shader asks for. All numbers
// are exact in binary, so that the CPU computes with the same ones.
struct Lookup {
    double x, y, lod;
};

class ExecutorSamplersVk : public ExecutorTest {
 protected:
    // Adds a square image whose texels have the values of shade(), and passes that fill its mips.
    ResourceId add_image(GraphBuilder& builder, uint32_t side, uint32_t mips, const std::string& value) {
        const ResourceId image = builder.image("source", Format::r32f, side, mips);
        for (uint32_t mip = 0; mip < mips; ++mip) {
            const std::string name = "fill" + std::to_string(mip);
            write_shader(name + ".comp",
                         "layout(local_size_x = 1) in;\nlayout(r32f) uniform writeonly image2D dst;\n" +
                             std::string(kShade) +
                             "void main() { ivec2 at = ivec2(gl_GlobalInvocationID.xy);" +
                             "const int mip = " + std::to_string(mip) + "; imageStore(dst, at, vec4(" +
                             value + ")); }");
            PassDecl& fill =
                builder.compute(name, {{"dst", image, Access::storage_write, test::one_cell(mip), kNoId}});
            fill.groups = {side >> mip, side >> mip, 1};
            use_shader(fill, name + ".comp", ProgramKind::compute);
        }
        return image;
    }

    // Samples `image` once for each index below `count`. `expression` is GLSL text with the index `i`.
    std::vector<float> look(GraphBuilder& builder, ResourceId image, const SamplerDecl& sampler,
                            uint32_t count, const std::string& type, const std::string& functions,
                            const std::string& expression) {
        const ResourceId found = builder.buffer("found", count * sizeof(float));
        write_shader("look.comp", "layout(local_size_x = 1) in;\nuniform " + type +
                                      " src;\nlayout(std430) writeonly buffer Found { float found[]; };\n" +
                                      functions + "void main() { uint i = gl_GlobalInvocationID.x; " +
                                      "found[i] = " + expression + "; }");
        PassDecl& pass = builder.compute("look", {{"src", image, Access::sampled_read, {}, kNoId},
                                                  {"Found", found, Access::storage_write, {}, kNoId}});
        pass.groups = {count, 1, 1};
        use_shader(pass, "look.comp", ProgramKind::compute);
        pass.uses[0].sampler = sampler;
        builder.pass("read", PassKind::readback, {{"src", found, Access::copy_read, {}, kNoId}});
        const auto executor = executor_for(input_for(compile_plan(builder)));
        if (executor == nullptr) return {};
        const std::vector<ReadbackData> read = run_frames(*executor, 1);
        return read.size() == 1 ? values_of<float>(read[0]) : std::vector<float>{};
    }

    std::vector<float> look_up(const SamplerDecl& sampler, const std::vector<Lookup>& lookups) {
        GraphBuilder builder;
        const ResourceId image = add_image(builder, kSampledSide, kSampledMips, "shade(at, mip)");
        std::string table = "const vec3 kAt[" + std::to_string(lookups.size()) + "] = vec3[](";
        for (const Lookup& l : lookups)
            table += (&l == &lookups.front() ? "" : ", ") + std::string("vec3(") + std::to_string(l.x) +
                     ", " + std::to_string(l.y) + ", " + std::to_string(l.lod) + ")";
        return look(builder, image, sampler, static_cast<uint32_t>(lookups.size()), "sampler2D",
                    table + ");\n",
                    "textureLod(src, kAt[i].xy / " + std::to_string(kSampledSide) + ".0, kAt[i].z).r");
    }
};

// Returns positions at which a bilinear lookup touches four texels of mips 0 and 1 with weights above 0.
std::vector<Lookup> positions(double lod) {
    std::vector<Lookup> all;
    for (int i = 0; i < 24; ++i) all.push_back({(i * 5 % 8) + 0.125 + i % 2 * 0.5, (i * 3 % 8) + 0.875, lod});
    return all;
}

// Returns the least or greatest of the 2 × 2 texels of a mip around a position.
float reduce(const Lookup& at, uint32_t mip, bool take_greatest) {
    const int side = static_cast<int>(kSampledSide >> mip);
    const auto left = static_cast<int>(std::floor(at.x / (1 << mip) - 0.5));
    const auto top = static_cast<int>(std::floor(at.y / (1 << mip) - 0.5));
    std::vector<float> texels;
    for (int y = top; y < top + 2; ++y)
        for (int x = left; x < left + 2; ++x)
            texels.push_back(shade(std::clamp(x, 0, side - 1), std::clamp(y, 0, side - 1), mip));
    return take_greatest ? std::ranges::max(texels) : std::ranges::min(texels);
}

TEST_F(ExecutorSamplersVk, reductions_return_the_least_or_greatest_texel_of_the_footprint) {
    if ((device().profile().features(Format::r32f) & format_feature::kSampledMinMax) == 0)
        GTEST_SKIP() << "the device cannot reduce r32f";
    for (const SamplerReduction reduction : {SamplerReduction::min, SamplerReduction::max}) {
        const bool greatest = reduction == SamplerReduction::max;
        const std::vector<Lookup> in_one = positions(0), in_two = positions(0.5);
        const std::vector<float> one = look_up({.reduction = reduction}, in_one);
        const std::vector<float> two = look_up({.reduction = reduction}, in_two);
        ASSERT_EQ(one.size(), in_one.size());
        ASSERT_EQ(two.size(), in_two.size());
        for (size_t i = 0; i < one.size(); ++i) {
            const float first = reduce(in_one[i], 0, greatest), second = reduce(in_one[i], 1, greatest);
            EXPECT_EQ(one[i], first) << "lookup " << i;
            // llvmpipe blends the results of the two mips, and other devices reduce them too.
            EXPECT_GE(two[i], std::min(first, second)) << "lookup " << i << " between two mips";
            EXPECT_LE(two[i], std::max(first, second)) << "lookup " << i << " between two mips";
        }
    }
}

// Each lookup is at the centre of texel (0, 0) of mip 3, so that the nearest texel of each mip is known.
TEST_F(ExecutorSamplersVk, limits_and_bias_select_the_mip) {
    struct Case {
        float bias, least, most;
    };
    std::vector<Lookup> lookups;
    for (const double lod : {-1.0, 0.0, 0.25, 0.75, 1.0, 1.75, 2.25, 3.0, 9.0})
        lookups.push_back({4.5, 4.5, lod});
    for (const Case& c :
         {Case{0, 0, kNoMaxLod}, Case{0, 1, 2}, Case{0, 2, 2}, Case{0, 0, 0}, Case{1, 0, kNoMaxLod},
          Case{-1, 0, kNoMaxLod}, Case{2, 0, 1}, Case{-2, 1, kNoMaxLod}}) {
        const SamplerDecl sampler{.filter = SamplerFilter::nearest,
                                  .mip_filter = SamplerFilter::nearest,
                                  .lod_bias = c.bias,
                                  .min_lod = c.least,
                                  .max_lod = c.most};
        const std::vector<float> found = look_up(sampler, lookups);
        ASSERT_EQ(found.size(), lookups.size());
        for (size_t i = 0; i < found.size(); ++i) {
            const double level = std::clamp(lookups[i].lod + static_cast<double>(c.bias),
                                            static_cast<double>(c.least), static_cast<double>(c.most));
            const auto mip = static_cast<uint32_t>(std::lround(std::clamp(level, 0.0, kSampledMips - 1.0)));
            const int at = 4 >> mip;
            EXPECT_EQ(found[i], shade(at, at, mip))
                << "lod " << lookups[i].lod << ", bias " << c.bias << ", " << c.least << " to " << c.most;
        }
    }
}

TEST_F(ExecutorSamplersVk, linear_mips_blend_at_the_limit) {
    const std::vector<float> found =
        look_up({.filter = SamplerFilter::nearest, .min_lod = 1.5F, .max_lod = 1.5F}, {{4.5, 4.5, 0}});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], (shade(2, 2, 1) + shade(1, 1, 2)) / 2, 0.5);
}

bool holds(CompareOp op, double reference, double texel) {
    switch (op) {
        case CompareOp::never:
            return false;
        case CompareOp::less:
            return reference < texel;
        case CompareOp::equal:
            return reference == texel;
        case CompareOp::less_equal:
            return reference <= texel;
        case CompareOp::greater:
            return reference > texel;
        case CompareOp::not_equal:
            return reference != texel;
        case CompareOp::greater_equal:
            return reference >= texel;
        case CompareOp::always:
            return true;
    }
    return false;
}

TEST_F(ExecutorSamplersVk, each_comparison_compares_the_reference_with_the_texel) {
    for (int i = 0; i <= static_cast<int>(CompareOp::always); ++i) {
        const auto op = static_cast<CompareOp>(i);
        GraphBuilder builder;
        const ResourceId depth = builder.image("depth", Format::d32f, 4);
        builder.pass("clear", PassKind::clear, {{"dst", depth, Access::clear_write, {}, kNoId}}).clear = {
            0.5F, 0, 0, 0};
        const std::vector<float> found =
            look(builder, depth,
                 {.filter = SamplerFilter::nearest, .mip_filter = SamplerFilter::nearest, .compare = op}, 3,
                 "sampler2DShadow", "", "textureLod(src, vec3(0.5, 0.5, 0.25 * float(i + 1u)), 0)");
        ASSERT_EQ(found.size(), 3u);
        for (int at = 0; at < 3; ++at)
            EXPECT_EQ(found[static_cast<size_t>(at)], holds(op, 0.25 * (at + 1), 0.5) ? 1.0F : 0.0F)
                << "comparison " << i << ", reference " << 0.25 * (at + 1);
    }
}

// Each mip has one value, its number. The footprint of the lookup has 8 × 1 texels. Vulkan recommends the
// level log2(8 / n) for n samples along the longer axis, but devices may choose a sharper one.
TEST_F(ExecutorSamplersVk, anisotropy_keeps_a_stretched_lookup_sharp) {
    if (device().profile().max_sampler_anisotropy < 8)
        GTEST_SKIP() << "the device cannot filter anisotropically";
    const auto level_of = [&](float anisotropy) {
        GraphBuilder builder;
        const ResourceId image = add_image(builder, 64, 5, "float(mip)");
        const std::vector<float> found =
            look(builder, image, {.anisotropy = anisotropy}, 1, "sampler2D", "",
                 "textureGrad(src, vec2(0.5), vec2(8.0 / 64.0, 0), vec2(0, 1.0 / 64.0)).r");
        return found.size() == 1 ? found[0] : -1.0F;
    };
    const float one = level_of(1), two = level_of(2), eight = level_of(8);
    EXPECT_NEAR(one, 3, 0.25);
    EXPECT_LT(two, one - 0.5);
    EXPECT_LE(eight, two);
    EXPECT_GE(eight, 0);
    EXPECT_LE(eight, 0.5);
}

}  // namespace
}  // namespace weft::vk
