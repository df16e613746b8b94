// Tests the table of accesses: the stages, access bits and layout of each kind of access, and properties that
// hold for every kind.
#include "weft/access.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

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

// The expected stages, access bits and layout of each kind of access, separated by spaces. The aspect is
// colour, and accesses by a shader are by a compute shader here. Source: the table of access types of
// VK_KHR_synchronization2 in the Vulkan specification, "Access Types".
TEST(AccessTable, ImagesHaveTheStatesOfSynchronization2) {
    const std::map<std::string, std::string> expected{
        {"none", "none none undefined"},
        {"indirect_read", "draw_indirect indirect_read undefined"},
        {"index_read", "vertex_input index_read undefined"},
        {"vertex_read", "vertex_input vertex_read undefined"},
        {"uniform_read", "compute_shader uniform_read undefined"},
        {"sampled_read", "compute_shader sampled_read shader_read_only"},
        {"storage_read", "compute_shader storage_read general"},
        {"storage_write", "compute_shader storage_write general"},
        {"storage_read_write", "compute_shader storage_read|storage_write general"},
        {"color_write", "color_output color_write color_attachment"},
        {"color_read_write", "color_output color_read|color_write color_attachment"},
        {"depth_write",
         "early_fragment_tests|late_fragment_tests depth_stencil_read|depth_stencil_write depth_attachment"},
        {"depth_read_write",
         "early_fragment_tests|late_fragment_tests depth_stencil_read|depth_stencil_write depth_attachment"},
        {"depth_read", "early_fragment_tests|late_fragment_tests depth_stencil_read depth_read_only"},
        {"copy_read", "copy transfer_read transfer_src"},
        {"copy_write", "copy transfer_write transfer_dst"},
        {"blit_read", "blit transfer_read transfer_src"},
        {"blit_write", "blit transfer_write transfer_dst"},
        {"clear_write", "clear transfer_write transfer_dst"},
        {"host_read", "host host_read general"},
        {"present", "none none present"}};
    for (const Access a : all_kinds()) {
        ASSERT_TRUE(expected.contains(access_name(a))) << access_name(a);
        EXPECT_EQ(text(access_state(a, kCompute, aspect::kColor)), expected.at(access_name(a)))
            << access_name(a);
    }
    EXPECT_EQ(text(access_state(Access::sampled_read, kCompute, aspect::kDepth)),
              "compute_shader sampled_read depth_read_only");
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
