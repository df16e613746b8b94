// Random texts are understood, and mean what their generator means by them.
#include "random_text.h"

#include <gtest/gtest.h>

#include <iostream>

#include "resolve_fixture.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Hashes leave out where in the file things stand.
std::string meaning(const ResolvedGraph& graph) {
    return compile(graph, content_needs(graph), {}).hash;
}

TEST(RandomText, MeansTheSameWithoutItsConditions) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 5000 : 200;
    uint32_t left_out = 0;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const RandomText made = random_text(seed);
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Result<ResolvedGraph> graph = resolve_text(made.text, made.params, fake_profile());
        ASSERT_TRUE(graph.ok()) << to_text(graph.errors()) << made.text;
        const Result<ResolvedGraph> plain = resolve_text(made.plain, made.params, fake_profile());
        ASSERT_TRUE(plain.ok()) << to_text(plain.errors()) << made.plain;
        ASSERT_EQ(meaning(*graph), meaning(*plain)) << made.text << made.plain;
        left_out += made.left_out ? 1 : 0;
    }
    std::cout << "seeds 0.." << seeds - 1 << ": " << left_out << " texts leave something out\n";
    EXPECT_GE(left_out * 2, seeds);
}

}  // namespace
}  // namespace weft::test
