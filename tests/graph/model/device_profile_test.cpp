// Tests the reader of device profile files, and the memory requirements of a graph's resources that follow
// from a profile.
#include "weft/device_profile.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"
#include "weft/report/memory_report.h"
#include "weft/report/plan_dump.h"

namespace weft::test {
namespace {

Result<DeviceProfile> shipped(const std::string& name) {
    const std::string path = std::string(WEFT_SOURCE_DIR) + "/framework/profiles/" + name + ".json";
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return parse_profile(text.str(), path);
}

FramePlan planned(const ResolvedGraph& graph, const DeviceProfile& profile, uint32_t queues) {
    return compile(graph, profile_needs(graph, profile), compile_options(profile, queues));
}

class ShippedProfile : public testing::TestWithParam<const char*> {};

TEST_P(ShippedProfile, ReadsWritesAndReadsTheSame) {
    const Result<DeviceProfile> profile = shipped(GetParam());
    ASSERT_TRUE(profile.ok()) << to_text(profile.errors());
    const std::string written = profile_to_json(*profile);
    const Result<DeviceProfile> again = parse_profile(written, "written.json");
    ASSERT_TRUE(again.ok()) << to_text(again.errors());
    EXPECT_EQ(profile_to_json(*again), written);
    EXPECT_EQ(again->memory_heaps, profile->memory_heaps);
    EXPECT_EQ(again->memory_types, profile->memory_types);
    EXPECT_EQ(again->image_alignment_bytes, profile->image_alignment_bytes);
    EXPECT_EQ(again->image_extra_bytes, profile->image_extra_bytes);
    EXPECT_EQ(again->formats, profile->formats);
    for (const Format format : {Format::rgba8, Format::r32u, Format::d32f})
        EXPECT_EQ(again->samples(format), profile->samples(format));
}

TEST_P(ShippedProfile, PlansOfRandomFramesAreSoundOnIt) {
    const Result<DeviceProfile> profile = shipped(GetParam());
    ASSERT_TRUE(profile.ok()) << to_text(profile.errors());
    for (uint32_t seed = 1; seed <= 12; ++seed) {
        const ResolvedGraph graph = random_graph(seed, all_features());
        const FramePlan plan = planned(graph, *profile, 1 + seed % 4);
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << "seed " << seed << "\n" << to_text(faults);
        for (const Placement& p : plan.memory.placements) {
            const MemoryNeed need = profile_needs(graph, *profile)[p.resource];
            EXPECT_EQ(p.offset_bytes % need.alignment_bytes, 0u);
            EXPECT_GE(p.size_bytes, content_bytes(graph.resources[p.resource]));
            EXPECT_NE(need.type_bits & plan.memory.heaps[p.heap].type_bits, 0u);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProfile,
                         testing::Values("lavapipe", "discrete", "integrated", "tiler", "hostile"),
                         [](const auto& row) { return std::string(row.param); });

TEST(DeviceProfile, SamplesAreThoseOfTheFormatsNumbers) {
    const Result<DeviceProfile> profile = parse_profile(
        R"j({"colorSamples": [1, 2, 16], "integerSamples": [1, 8], "depthSamples": [64, 1]})j", "p.json");
    ASSERT_TRUE(profile.ok()) << to_text(profile.errors());
    EXPECT_EQ(profile->samples(Format::b10g11r11f), 1u | 2 | 16);
    EXPECT_EQ(profile->samples(Format::rgba8_srgb), 1u | 2 | 16);
    EXPECT_EQ(profile->samples(Format::rg16u), 1u | 8);
    EXPECT_EQ(profile->samples(Format::r32i), 1u | 8);
    EXPECT_EQ(profile->samples(Format::d32f_s8), 1u | 64);
    EXPECT_EQ(profile->samples(Format::s8), 1u | 64);
    for (const char* bad : {"[1, 3]", "[1, 128]", "[4]", "4", "[1, \"4\"]", "[1, -4]"}) {
        const Result<DeviceProfile> faulty =
            parse_profile(std::string("{\"colorSamples\": ") + bad + "}", "p.json");
        ASSERT_FALSE(faulty.ok()) << bad;
        ASSERT_EQ(faulty.errors().size(), 1u) << to_text(faulty.errors());
        EXPECT_EQ(faulty.errors()[0].code, "W140");
        EXPECT_EQ(faulty.errors()[0].pointer, "/colorSamples");
    }
}

TEST(DeviceProfile, DiscreteHasAFamilyForEachKindOfQueue) {
    const Result<DeviceProfile> profile = shipped("discrete");
    ASSERT_TRUE(profile.ok());
    const std::vector<LogicalQueue> queues = logical_queues(*profile, 3);
    EXPECT_NE(queues[0].family, queues[1].family);
    EXPECT_NE(queues[1].family, queues[2].family);
}

TEST(DeviceProfile, OnATilerAttachmentsThatNobodyReadsGoIntoLazyMemory) {
    const Result<DeviceProfile> profile = shipped("tiler");
    ASSERT_TRUE(profile.ok());
    GraphBuilder b;
    const ResourceId color = b.image("color", Format::rgba8, 64), depth = b.image("depth", Format::d32f, 64);
    b.pass(
        "draw", PassKind::raster,
        {{"color", color, Access::color_write, {}, kNoId}, {"depth", depth, Access::depth_write, {}, kNoId}});
    b.pass("out", PassKind::readback, {{"src", color, Access::copy_read, {}, kNoId}});
    ResolvedGraph graph = b.build();
    for (PassDecl& pass : graph.passes)
        for (const UseDecl& use : pass.uses) graph.resources[use.resource].usage |= usage_of(use.access);
    const MemoryNeeds needs = profile_needs(graph, *profile);
    const auto lazy = [&](const char* name) {
        const ResourceId id = find_resource(graph, name);
        return profile->memory_types[static_cast<size_t>(std::countr_zero(needs[id].type_bits))]
            .lazily_allocated;
    };
    EXPECT_TRUE(lazy("depth"));
    EXPECT_FALSE(lazy("color")) << "it is copied, so that it must be somewhere";
    const FramePlan plan = planned(graph, *profile, 1);
    EXPECT_NE(plan_to_text(plan, &*profile).find("lazily allocated"), std::string::npos);
}

TEST(DeviceProfile, OddSizesAreThoseOfTheProfile) {
    const Result<DeviceProfile> profile = shipped("hostile");
    ASSERT_TRUE(profile.ok());
    GraphBuilder b;
    b.image("image", Format::r32u, 3);
    b.buffer("words", 12);
    const ResolvedGraph graph = b.build();
    const MemoryNeeds needs = profile_needs(graph, *profile);
    EXPECT_EQ(needs[0].size_bytes, 3 * 512 + 4099u);
    EXPECT_EQ(needs[0].alignment_bytes, 131072u);
    EXPECT_EQ(needs[1].size_bytes, 12u);
    EXPECT_EQ(needs[0].type_bits & needs[1].type_bits, 0u) << "they live in memory of different types";
}

TEST(DeviceProfile, TooLittleMemoryIsAWarningThatNamesTheLargest) {
    DeviceProfile small;
    small.name = "small";
    small.memory_heaps = {{4096, true}};
    small.memory_types = {{}};
    GraphBuilder b;
    const ResourceId big = b.image("big", Format::r32u, 64), little = b.image("little", Format::r32u, 4);
    b.compute("make", {{"dst", big, Access::storage_write, {}, kNoId}});
    b.compute("shrink", {{"src", big, Access::sampled_read, {}, kNoId},
                         {"dst", little, Access::storage_write, {}, kNoId}});
    b.pass("out", PassKind::readback, {{"src", little, Access::copy_read, {}, kNoId}});
    const FramePlan plan = planned(b.build(), small, 1);
    const Diagnostics faults = memory_faults(plan, small, "graph.json");
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].code, "W142");
    EXPECT_EQ(faults[0].severity, Severity::warning);
    EXPECT_NE(to_text(faults).find("big 16.0 KiB"), std::string::npos) << to_text(faults);
    small.memory_heaps[0].size_bytes = 1 << 20;
    EXPECT_TRUE(memory_faults(plan, small, "graph.json").empty());
}

struct BadProfile {
    const char* name;
    const char* json;
    const char* message;
};
void PrintTo(const BadProfile& bad, std::ostream* out) {
    *out << bad.name;
}

class BadProfileTest : public testing::TestWithParam<BadProfile> {};

TEST_P(BadProfileTest, IsRefused) {
    const Result<DeviceProfile> profile = parse_profile(GetParam().json, "bad.json");
    ASSERT_FALSE(profile.ok());
    EXPECT_NE(to_text(profile.errors()).find(GetParam().message), std::string::npos)
        << to_text(profile.errors());
}

INSTANTIATE_TEST_SUITE_P(
    All, BadProfileTest,
    testing::Values(
        BadProfile{"NoSuchHeap", R"({"memoryTypes": [{"heap": 1}], "memoryHeaps": [{"bytes": 1}]})",
                   "heap 1"},
        BadProfile{"OddAlignment", R"({"imageAlignmentBytes": 48})", "power of two"},
        BadProfile{"NoAlignment", R"({"bufferAlignmentBytes": 0})", "power of two"},
        BadProfile{"OddGranularity", R"({"bufferImageGranularityBytes": 3})", "power of two"},
        BadProfile{"UnknownContent", R"({"memoryHeaps": [{"bytes": 1}], "memoryTypes": [{"holds": ["x"]}]})",
                   "\"x\""},
        BadProfile{"NothingForBuffers",
                   R"({"memoryHeaps": [{"bytes": 1}], "memoryTypes": [{"holds": ["colorImages"]}]})",
                   "do not cover all kinds of resources"},
        BadProfile{"TypesAreNoList", R"({"memoryTypes": 7})", "memoryTypes"},
        BadProfile{"HeapIsNoObject", R"({"memoryHeaps": [7]})", "type_error"}),
    [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace weft::test
