// Tests that both texts of a RandomText resolve and give the same plan, and that resolve() finds the fault in
// each FaultyText.
#include "tests/graph/samples/random_text.h"

#include <gtest/gtest.h>

#include <iostream>
#include <set>
#include <sstream>

#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/compile.h"
#include "weft/report/plan_dump.h"

namespace weft::test {
namespace {

// Returns the hash of the graph's plan. The hash does not depend on line and column numbers, so two texts
// with the same meaning have the same hash. Only the text with "views" has a reason for its lowering.
std::string meaning(ResolvedGraph graph) {
    for (PassDecl& pass : graph.passes) pass.lowering_reason.clear();
    return plan_hash(compile(graph, content_needs(graph), {}));
}

// Returns the profile of a device with all optional features that the texts can use.
DeviceProfile all_of_device() {
    DeviceProfile profile = fake_profile();
    profile.draw_indirect_count = true;
    profile.max_sampler_anisotropy = 16;
    for (auto& [format, features] : profile.formats)
        if (features & format_feature::kSampledLinear) features |= format_feature::kSampledMinMax;
    profile.formats[Format::d32f] |= format_feature::kSampledMinMax;
    return profile;
}

TEST(RandomText, MeansTheSameWithoutItsConditions) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 5000 : 200;
    const DeviceProfile profile = all_of_device();
    uint32_t omitted = 0;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const RandomText made = random_text(seed, profile);
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Result<ResolvedGraph> graph = resolve_text(made.text, made.params, profile);
        ASSERT_TRUE(graph.ok()) << to_text(graph.errors()) << made.text;
        const Result<ResolvedGraph> plain = resolve_text(made.plain, made.params, profile);
        ASSERT_TRUE(plain.ok()) << to_text(plain.errors()) << made.plain;
        ASSERT_EQ(meaning(*graph), meaning(*plain)) << made.text << made.plain;
        omitted += made.omitted ? 1 : 0;
    }
    std::cout << "seeds 0.." << seeds - 1 << ": " << omitted << " texts leave something out\n";
    EXPECT_GE(omitted * 2, seeds);
}

// Returns the plan as text without the prefix of the module and without the hash, which depends on names. The
// lines of each step are sorted, because imports have no prefix and so have another place among the names.
std::string text_without_prefix(const ResolvedGraph& graph) {
    std::istringstream lines(plan_to_text(compile(graph, content_needs(graph), {})));
    std::string text;
    std::set<std::string> step;
    const auto end_step = [&] {
        for (const std::string& line : step) text += line + "\n";
        step.clear();
    };
    for (std::string line; std::getline(lines, line);) {
        for (size_t at = line.find("m::"); at != std::string::npos; at = line.find("m::", at))
            line.erase(at, 3);
        if (line.empty()) end_step();
        if (!line.starts_with("hash") && !line.starts_with("plan of")) step.insert(line);
    }
    end_step();
    return text;
}

TEST(RandomText, MeansTheSameAsAModule) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 5000 : 200;
    uint32_t compared = 0;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const RandomText made = random_text(seed, fake_profile());
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Result<ResolvedGraph> graph = resolve_text(made.text, made.params, fake_profile());
        ASSERT_TRUE(graph.ok()) << to_text(graph.errors()) << made.text;
        const Result<ResolvedGraph> module = resolve_as_module(made.text, made.params, fake_profile());
        ASSERT_TRUE(module.ok()) << to_text(module.errors()) << made.text;
        const std::string expected = text_without_prefix(*graph);
        // The names of carry passes have no prefix, so their place among the other names changes, and with it
        // the order of passes that do not depend on each other.
        if (expected.find("carry:") != std::string::npos) continue;
        ASSERT_EQ(expected, text_without_prefix(*module)) << made.text;
        ++compared;
    }
    EXPECT_GE(compared * 3, seeds);
}

// Expects exactly one error for each faulty text, with the code of the fault that the generator has inserted.
TEST(RandomText, EachFaultIsFound) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 5000 : 300;
    const DeviceProfile profile = all_of_device();
    std::map<std::string, uint32_t> found;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const FaultyText made = random_faulty_text(seed, profile);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.how);
        const Result<ResolvedGraph> graph = resolve_text(made.text, made.params, profile);
        ASSERT_FALSE(graph.ok()) << "accepted\n" << made.text;
        ASSERT_EQ(graph.errors().size(), 1u) << to_text(graph.errors()) << made.text;
        const Diagnostic& fault = graph.errors().front();
        ASSERT_EQ(fault.code, made.code) << to_text(fault) << made.text;
        EXPECT_GT(fault.line, 0u) << to_text(fault);
        EXPECT_FALSE(fault.help.empty()) << to_text(fault);
        ++found[fault.code];
    }
    for (const auto& [code, count] : found) std::cout << code << " " << count << ", ";
    std::cout << "seeds 0.." << seeds - 1 << "\n";
    EXPECT_EQ(found.size(), 9u);
}

}  // namespace
}  // namespace weft::test
