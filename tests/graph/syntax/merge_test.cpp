#include "graph/parse/grammar_tables.h"
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

Result<JsonDoc> merge_text(const std::string& text) {
    Result<JsonDoc> document = read_text(text);
    if (!document) return document.take_errors();
    return merge(std::move(document).value());
}

// Returns the structure of a JSON node as a short text such as {a:{ref:b}}, so that tests can compare
// documents.
std::string shape(const JsonNode& node) {
    if (node.kind == JsonKind::string || node.kind == JsonKind::number) return node.string;
    if (node.kind == JsonKind::boolean) return node.boolean ? "true" : "false";
    const bool object = node.kind == JsonKind::object;
    std::string text(1, object ? '{' : '[');
    for (const JsonMember& member : node.members)
        text.append(member.key).append(":").append(shape(member.value)).append(",");
    for (const JsonNode& item : node.items) text.append(shape(item)).append(",");
    if (text.back() == ',') text.pop_back();
    return text.append(1, object ? '}' : ']');
}

TEST(Merge, ShorthandBecomesObjects) {
    const Result<JsonDoc> merged = merge_text(R"json({
        "imports": {"opaque": "drawlist"}, "params": {"a": 1, "b": true},
        "resources": {"hdr": "rgba16f", "z": {"format": "d32f"}},
        "passes": {"p": {"depth": "z", "draws": ["opaque"], "in": ["hiz@q.mip(0)", "a"], "out": {"dst": "b.mip(1)"}}}
    })json");
    ASSERT_TRUE(merged.ok()) << to_text(merged.errors());
    EXPECT_EQ(shape(merged->root),
              "{imports:{opaque:{kind:drawlist}},params:{a:{default:1},b:{default:true}},"
              "resources:{hdr:{format:rgba16f},z:{format:d32f}},"
              "passes:{p:{depth:{ref:z},draws:[opaque],in:{hiz:{ref:hiz@q.mip(0)},a:{ref:a}},"
              "out:{dst:{ref:b.mip(1)}}}}}");
}

TEST(Merge, ShorthandInGroupsBecomesObjects) {
    const Result<JsonDoc> merged = merge_text(R"json({
        "groups": {"g": {"resources": {"raw": "r8"}, "passes": {"p": {"in": ["raw@q", "g::low"], "depth": "z"}}}},
        "tiers": {"t": {"patch": {"groups": {"g": {"resources": {"raw": "r16f"}, "passes": {"p": {"out": ["b"]}}}}}}}
    })json");
    ASSERT_TRUE(merged.ok()) << to_text(merged.errors());
    EXPECT_EQ(shape(merged->root),
              "{groups:{g:{resources:{raw:{format:r8}},"
              "passes:{p:{in:{raw:{ref:raw@q},low:{ref:g::low}},depth:{ref:z}}}}},"
              "tiers:{t:{patch:{groups:{g:{resources:{raw:{format:r16f}},passes:{p:{out:{b:{ref:b}}}}}}}}}}");
}

// The parser accepts these sections in the patch of a tier, so merge() must apply each of them.
TEST(Merge, ATierChangesEachSectionThatItMayPatch) {
    size_t sections = 0;
    for (const GrammarTable& list : grammar_tables()) {
        if (list.place != "patch") continue;
        for (const std::string& section : list.words) {
            const std::string text = R"({"tiers": {"low": {"patch": {")" + section + R"(": {"new": {}}}}}})";
            Result<JsonDoc> document = read_text(text);
            ASSERT_TRUE(document.ok());
            const Result<JsonDoc> merged = merge(std::move(document).value(), "low");
            ASSERT_TRUE(merged.ok()) << to_text(merged.errors());
            EXPECT_NE(merged->root.find(section), nullptr) << section;
            ++sections;
        }
    }
    EXPECT_GE(sections, 11u);
}

TEST(Merge, WhatWasMovedKeepsItsPlace) {
    const Result<JsonDoc> merged = merge_text("{\"passes\": {\"p\": {\n  \"in\": [\"a\",\n    \"b\"]}}}");
    ASSERT_TRUE(merged.ok());
    const JsonNode* in = merged->root.find("passes")->find("p")->find("in");
    ASSERT_EQ(in->members.size(), 2u);
    EXPECT_EQ(in->members[1].key_loc.line, 3u);
    EXPECT_EQ(in->members[1].key_loc.column, 5u);
    EXPECT_EQ(in->members[1].value.find("ref")->loc.line, 3u);
    EXPECT_EQ(in->loc.line, 2u);
}

TEST(Merge, MergingTwiceChangesNothing) {
    const Result<JsonDoc> once =
        merge_text(R"({"resources": {"a": "r8"}, "passes": {"p": {"in": ["a"], "depth": "a"}}})");
    ASSERT_TRUE(once.ok());
    const Result<JsonDoc> twice = merge(*once);
    ASSERT_TRUE(twice.ok());
    EXPECT_EQ(shape(once->root), shape(twice->root));
}

TEST(Merge, TwoPortsOfOneNameAreAnErrorAtTheSecond) {
    check_parse_fault(
        {"",
         "{\"version\": 1, \"passes\": {\"p\": {\"in\": [\"hiz.mip(0)\",\n $$\"hiz.mip(1)\"]}}}",
         {"W003"},
         "two ports would have the name \"hiz\"",
         "give each port a name"});
}

TEST(Merge, UnexpectedKindsPassThrough) {
    for (const char* text : {"[]", "1", "{\"passes\": 3}", "{\"passes\": {\"p\": 1}}", "{\"resources\": []}",
                             "{\"passes\": {\"p\": {\"in\": [1, \"a\"], \"out\": 2, \"depth\": []}}}"})
        EXPECT_TRUE(merge_text(text).ok()) << text;
}

}  // namespace
}  // namespace weft::test
