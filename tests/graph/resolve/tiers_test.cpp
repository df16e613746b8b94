// Tests quality tiers: the effects of `set` and `patch`, and the errors for faults in them.
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

Result<GraphDesc> parse_tier(const std::string& text, const std::string& tier) {
    Result<JsonDoc> document = read_text(text);
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(*document), tier);
    if (!merged) return merged.take_errors();
    return parse(*merged);
}

const char* const kGraph = R"({
  "version": 1,
  "params": {"scale": {"default": 1, "range": [0.5, 1]}, "ssr": true},
  "resources": {"hdr": "rgba16f", "rays": "rgba16f"},
  "passes": {
    "light": {"type": "clear", "out": ["hdr"]},
    "trace": {"type": "clear", "out": ["rays"], "if": "ssr"},
    "show":  {"type": "copy", "in": ["hdr"], "out": ["rays"]}
  },
  "tiers": {
    "low":  {"set": {"scale": 0.5, "ssr": false}},
    "high": {"patch": {"resources": {"bloom": {"format": "r8", "mips": 3}, "hdr": "rgba32f"},
                       "passes": {"light": {"out": ["bloom"], "clear": 1}, "trace": null}}},
    "base": {}
  }
})";

TEST(Tiers, NoneNamedIsTheFileAsItIs) {
    const Result<GraphDesc> graph = parse_tier(kGraph, "");
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->params.at("scale").default_value, 1);
    EXPECT_EQ(graph->passes.size(), 3u);
    ASSERT_EQ(graph->tiers.size(), 3u);
    EXPECT_EQ(graph->tiers[0].name, "low");
    EXPECT_EQ(tier_names(*read_text(kGraph)), (std::vector<std::string>{"low", "high", "base"}));
}

TEST(Tiers, SetChangesDefaults) {
    const Result<GraphDesc> graph = parse_tier(kGraph, "low");
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->params.at("scale").default_value, 0.5);
    EXPECT_EQ(graph->params.at("ssr").default_value, 0);
    EXPECT_TRUE(graph->params.at("ssr").is_bool);
}

TEST(Tiers, PatchAddsChangesAndRemoves) {
    const Result<GraphDesc> graph = parse_tier(kGraph, "high");
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->resources.size(), 3u);
    EXPECT_EQ(graph->resources.at("hdr").formats, std::vector<std::string>{"rgba32f"});
    EXPECT_EQ(graph->passes.size(), 2u);
    EXPECT_EQ(graph->passes.at("light").out.size(), 2u) << "ports are added, not replaced";
    EXPECT_TRUE(graph->passes.at("light").clear);
    EXPECT_EQ(graph->params.at("scale").default_value, 1);
}

TEST(Tiers, AnUnknownOneIsNamedWithThoseThereAre) {
    const Result<GraphDesc> graph = parse_tier(kGraph, "hgih");
    ASSERT_FALSE(graph.ok());
    EXPECT_EQ(graph.errors().front().code, "W129");
    EXPECT_EQ(place(graph.errors().front()), "graph.json:10:12");
    EXPECT_NE(joined_help(graph.errors().front()).find("did you mean \"high\""), std::string::npos);
}

TEST(Tiers, AFileWithoutTiersSaysSo) {
    const Result<GraphDesc> graph = parse_tier(R"({"version": 1, "passes": {}})", "low");
    ASSERT_FALSE(graph.ok());
    EXPECT_NE(joined_help(graph.errors().front()).find("no tiers"), std::string::npos);
}

// Parses a small graph whose tier "t" has the text `tier`. Expects exactly one error, at the place that "$$"
// marks in `tier`.
void expect_tier_fault(const std::string& tier, const std::string& code, const std::string& message,
                       const std::string& help) {
    const MarkedText marked = unmark(
        "{\"version\": 1, \"params\": {\"a\": {\"default\": 1, \"range\": [0, 2]}},\n"
        "\"resources\": {\"x\": \"r8\"}, \"passes\": {\"p\": {\"type\": \"clear\", "
        "\"out\": [\"x\"]}},\n\"tiers\": {\"t\": " +
        tier + "}}");
    const Result<GraphDesc> graph = parse_tier(marked.text, "t");
    ASSERT_FALSE(graph.ok()) << tier;
    ASSERT_EQ(graph.errors().size(), 1u) << to_text(graph.errors());
    const Diagnostic& fault = graph.errors().front();
    EXPECT_EQ(fault.code, code) << to_text(fault);
    EXPECT_EQ(place(fault), marked.places.front()) << to_text(fault);
    EXPECT_NE(fault.message.find(message), std::string::npos) << to_text(fault);
    EXPECT_NE(joined_help(fault).find(help), std::string::npos) << to_text(fault);
}

TEST(Tiers, FaultsAreWhereTheTierSaysSo) {
    expect_tier_fault(R"({"set": {$$"b": 1}})", "W131", "not a parameter", "\"a\"");
    expect_tier_fault(R"({"set": {"a": $$5}})", "W109", "", "");
    expect_tier_fault(R"({"set": {"a": $$"high"}})", "W102", "found string", "");
    expect_tier_fault(R"({$$"sett": {"a": 1}})", "W101", "sett", "\"set\"");
    expect_tier_fault(R"({"patch": {$$"pases": {}}})", "W101", "pases", "\"passes\"");
    expect_tier_fault(R"({"patch": {"resources": {"y": $$null}}})", "W128", "", "");
    expect_tier_fault(R"({"patch": {"resources": {"x": {$$"mip": 2}}}})", "W101", "mip", "\"mips\"");
    expect_tier_fault(R"({"patch": {"passes": {$$"q": {"out": ["x"]}}}})", "W108", "type",
                      "did you mean \"p\"");
    expect_tier_fault(R"($$3)", "W102", "", "");
}

TEST(Tiers, AReplacedValueShowsBothPlaces) {
    const Result<GraphDesc> graph =
        parse_tier(R"({"version": 1, "params": {"a": {"default": 1, "range": [0, 2]}},
 "passes": {}, "tiers": {"t": {"set": {"a": 5}}}})",
                   "t");
    ASSERT_FALSE(graph.ok());
    const Diagnostic& fault = graph.errors().front();
    EXPECT_EQ(place(fault), "graph.json:2:45");
    ASSERT_EQ(fault.notes.size(), 1u) << to_text(fault);
    EXPECT_EQ(fault.notes[0].line, 1u);
}

}  // namespace
}  // namespace weft::test
