// Purpose: runs passes whose ports are arrays of mips or layers, and compares what they read and write with
// the numbers that the shaders of this file give to each mip and layer.
#include "tests/vulkan/executor_fixture.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kArraySide = 8, kArrayMips = 3, kArrayLayers = 3;

class ExecutorArraysVk : public ExecutorTest {
 protected:
    // Adds an image in which each texel of mip m and layer l has the value 10 m + l.
    ResourceId add_image(GraphBuilder& builder) {
        const ResourceId image = builder.image("x", Format::r32f, kArraySide, kArrayMips, kArrayLayers);
        for (uint32_t mip = 0; mip < kArrayMips; ++mip) {
            const std::string name = "fill" + std::to_string(mip);
            write_shader(name + ".comp",
                         "layout(local_size_x = 1) in;\nlayout(r32f) uniform writeonly image2DArray dst;\n"
                         "void main() { imageStore(dst, ivec3(gl_GlobalInvocationID), vec4(" +
                             std::to_string(10 * mip) + ".0 + gl_GlobalInvocationID.z)); }");
            PassDecl& fill =
                builder.compute(name, {{"dst", image, Access::storage_write,
                                        SubresourceRange{mip, 1, 0, kArrayLayers, aspect::kColor}, kNoId}});
            fill.groups = {kArraySide >> mip, kArraySide >> mip, kArrayLayers};
            use_shader(fill, name + ".comp", ProgramKind::compute);
        }
        return image;
    }

    // Reads texel (0, 0) of each of the four elements of an array.
    std::vector<float> elements(EachPart each, const SubresourceRange& range, const std::string& declaration,
                                const std::string& lookup) {
        GraphBuilder builder;
        const ResourceId image = add_image(builder);
        const ResourceId found = builder.buffer("found", 4 * sizeof(float));
        std::string body;
        for (const char* i : {"0", "1", "2", "3"})
            body += std::string("found[") + i + "] = " + lookup + "(src[" + i + "], ivec2(0)" +
                    (lookup == "texelFetch" ? ", 0" : "") + ").r;\n";
        write_shader("look.comp",
                     "layout(local_size_x = 1) in;\n" + declaration +
                         " src[4];\nlayout(std430) writeonly buffer Found { float found[]; };\n" +
                         "void main() {\n" + body + "}");
        const bool sampled = lookup == "texelFetch";
        PassDecl& pass = builder.compute(
            "look", {{"src", image, sampled ? Access::sampled_read : Access::storage_read, range, kNoId},
                     {"Found", found, Access::storage_write, {}, kNoId}});
        use_shader(pass, "look.comp", ProgramKind::compute);
        pass.uses[0].each = each;
        builder.pass("read", PassKind::readback, {{"src", found, Access::copy_read, {}, kNoId}});
        const auto executor = executor_for(input_for(compile_plan(builder)));
        if (executor == nullptr) return {};
        const std::vector<ReadbackData> read = run_frames(*executor, 1);
        return read.size() == 1 ? values_of<float>(read[0]) : std::vector<float>{};
    }
};

TEST_F(ExecutorArraysVk, each_element_is_one_mip_or_layer_and_spare_ones_show_the_last) {
    EXPECT_EQ(elements(EachPart::mip, {0, 3, 1, 1, aspect::kColor}, "uniform sampler2D", "texelFetch"),
              (std::vector<float>{1, 11, 21, 21}));
    EXPECT_EQ(elements(EachPart::layer, {1, 1, 0, 3, aspect::kColor}, "uniform sampler2D", "texelFetch"),
              (std::vector<float>{10, 11, 12, 12}));
    EXPECT_EQ(elements(EachPart::layer, {2, 1, 1, 2, aspect::kColor}, "layout(r32f) readonly uniform image2D",
                       "imageLoad"),
              (std::vector<float>{21, 22, 22, 22}));
}

TEST_F(ExecutorArraysVk, storage_images_are_modified_in_place) {
    GraphBuilder builder;
    const ResourceId image = add_image(builder);
    write_shader("add.comp",
                 "layout(local_size_x = 1) in;\nlayout(r32f) uniform image2DArray dst[3];\n"
                 "void add(ivec3 at) { const bvec3 in_1 = lessThan(at, imageSize(dst[1]));\n"
                 "imageStore(dst[0], at, imageLoad(dst[0], at) + 100.0);\n"
                 "if (all(in_1)) imageStore(dst[1], at, imageLoad(dst[1], at) + 200.0); }\n"
                 "void main() { add(ivec3(gl_GlobalInvocationID)); }");
    const SubresourceRange range{1, 2, 0, kArrayLayers, aspect::kColor};
    PassDecl& add = builder.compute("add", {{"dst", image, Access::storage_read_write, range, kNoId}});
    add.groups = {kArraySide / 2, kArraySide / 2, kArrayLayers};
    use_shader(add, "add.comp", ProgramKind::compute);
    add.uses[0].each = EachPart::mip;
    builder.pass("read", PassKind::readback, {{"src", image, Access::copy_read, {}, kNoId}});
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 2);
    ASSERT_EQ(read.size(), 2u);
    std::vector<float> wanted;
    for (uint32_t mip = 0; mip < kArrayMips; ++mip)
        for (uint32_t layer = 0; layer < kArrayLayers; ++layer)
            wanted.insert(wanted.end(), size_t{kArraySide >> mip} * (kArraySide >> mip),
                          static_cast<float>(10 * mip + layer + 100 * mip));
    for (const ReadbackData& data : read) EXPECT_EQ(values_of<float>(data), wanted);
}

}  // namespace
}  // namespace weft::vk
