// Tests the table of accesses: the stages, access bits and layout of each kind of access, and properties that
// hold for every kind.
#include "weft/access.h"

#include <gtest/gtest.h>

#include <set>

namespace weft::test {
namespace {

constexpr ShaderStageMask kCompute = stage_bit(ShaderStage::compute);

std::vector<Access> all_kinds() {
    std::vector<Access> kinds;
    for (int i = 0; i <= static_cast<int>(Access::present); ++i) kinds.push_back(static_cast<Access>(i));
    return kinds;
}

std::string text(const AccessState& state) {
    return stages_text(state.stages) + " " + access_text(state.access) + " " + layout_text(state.layout);
}

TEST(AccessTable, ImagesHaveTheStatesOfSynchronization2) {
    const auto image = [](Access a, AspectMask aspects) { return text(access_state(a, kCompute, aspects)); };
    EXPECT_EQ(image(Access::sampled_read, aspect::kColor), "compute_shader sampled_read shader_read_only");
    EXPECT_EQ(image(Access::sampled_read, aspect::kDepth), "compute_shader sampled_read depth_read_only");
    EXPECT_EQ(image(Access::storage_read_write, aspect::kColor),
              "compute_shader storage_read|storage_write general");
    EXPECT_EQ(image(Access::color_read_write, aspect::kColor),
              "color_output color_read|color_write color_attachment");
    EXPECT_EQ(image(Access::depth_write, aspect::kDepth),
              "early_fragment_tests|late_fragment_tests depth_stencil_read|depth_stencil_write "
              "depth_attachment");
    EXPECT_EQ(image(Access::copy_write, aspect::kColor), "copy transfer_write transfer_dst");
    EXPECT_EQ(image(Access::clear_write, aspect::kColor), "clear transfer_write transfer_dst");
}

TEST(AccessTable, BuffersHaveNoLayout) {
    for (const Access a : all_kinds())
        EXPECT_EQ(access_state(a, kCompute, aspect::kNone).layout, Layout::undefined) << access_name(a);
    EXPECT_EQ(text(access_state(Access::indirect_read, 0, aspect::kNone)),
              "draw_indirect indirect_read undefined");
    // Shaders read buffers as storage buffers, so a sampled access to a buffer becomes a storage read.
    EXPECT_EQ(text(access_state(Access::sampled_read, kCompute, aspect::kNone)),
              "compute_shader storage_read undefined");
}

TEST(AccessTable, ShaderAccessesHaveTheStagesOfTheShaders) {
    const ShaderStageMask both = stage_bit(ShaderStage::vertex) | stage_bit(ShaderStage::fragment);
    for (const Access a :
         {Access::uniform_read, Access::sampled_read, Access::storage_read, Access::storage_write})
        EXPECT_EQ(stages_text(access_state(a, both, aspect::kColor).stages), "vertex_shader|fragment_shader");
}

// Tests that a kind of access has a write bit if and only if it writes, and that every kind that reads has a
// read bit. The kind `present` is an exception, because the presentation engine needs no access bits.
TEST(AccessTable, AccessBitsAgreeWithReadsAndWrites) {
    for (const Access a : all_kinds()) {
        const AccessMask bits = access_state(a, kCompute, aspect::kColor).access;
        EXPECT_EQ((bits & access::kAllWrites) != 0, writes(a)) << access_name(a);
        if (reads(a) && a != Access::present) {
            EXPECT_NE(bits & ~access::kAllWrites, 0u) << access_name(a);
        }
    }
}

TEST(AccessTable, NamesAreUnique) {
    std::set<std::string> names;
    for (const Access a : all_kinds()) EXPECT_TRUE(names.insert(access_name(a)).second) << access_name(a);
    for (int i = 0; i < stage::kCount; ++i) EXPECT_TRUE(names.insert("stage " + stages_text(1u << i)).second);
    for (int i = 0; i < access::kCount; ++i) EXPECT_TRUE(names.insert("bit " + access_text(1u << i)).second);
}

}  // namespace
}  // namespace weft::test
