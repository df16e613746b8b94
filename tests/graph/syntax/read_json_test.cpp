#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

class JsonFaultTest : public ::testing::TestWithParam<FaultCase> {};

TEST_P(JsonFaultTest, IsAtItsCharacterWithARemedy) {
    const MarkedText marked = unmark(GetParam().text);
    const Result<JsonDoc> result = read_text(marked.text);
    ASSERT_FALSE(result.ok());
    expect_faults(GetParam(), marked, result.errors());
}

INSTANTIATE_TEST_SUITE_P(
    Rules, JsonFaultTest,
    ::testing::Values(
        FaultCase{"Empty", "  // nothing\n$$", {"W001"}, "the file is empty"},
        FaultCase{"MissingComma", "{\"a\": 1$$\n \"b\": 2}", {"W001"}, "comma is missing", "add a comma"},
        FaultCase{"MissingCommaInArray", "[1$$ 2]", {"W001"}, "comma is missing", "add a comma"},
        FaultCase{"TwoCommas", "{\"a\": 1,$$, \"b\": 2}", {"W001"}, "found ','", "remove one"},
        FaultCase{"TwoCommasInArray", "[1,$$,2]", {"W001"}, "where a value was wanted"},
        FaultCase{"Truncated",
                  "{\"a\":\n {\"b\": [1,\n$$",
                  {"W001"},
                  "ends inside an array",
                  "close the bracket opened at line 2"},
        FaultCase{"TruncatedBehindKey", "{\"a\"$$", {"W001"}, "ends inside an object"},
        FaultCase{"TruncatedBehindColon", "{\"a\": $$", {"W001"}, "ends inside an object"},
        FaultCase{"WrongBracket",
                  "{\"a\":\n [1, 2\n $$}",
                  {"W001"},
                  "found '}' where ']'",
                  "close the bracket opened at line 2"},
        FaultCase{"WrongBrace", "[{\"a\": 1$$]", {"W001"}, "found ']' where '}'", "brace opened at line 1"},
        FaultCase{"MissingColon", "{\"a\" $$1}", {"W001"}, "where ':' was wanted", "put a ':'"},
        FaultCase{"BareKey", "{$$a: 1}", {"W001"}, "key without quotes"},
        FaultCase{"SingleQuotes", "{\"a\": $$'b'}", {"W001"}, "single quote", "double quotes"},
        FaultCase{"Capital", "{\"a\": $$True}", {"W001"}, "found True", "did you mean \"true\""},
        FaultCase{"Behind", "{} $$}", {"W001"}, "after the end"},
        FaultCase{
            "OpenString", "{\"a\": $$\"b\n}", {"W001"}, "no closing quote on its line", "closing quote"},
        FaultCase{"ControlCharacter", "[\"a$$\x01\"]", {"W001"}, "control character 0x01"},
        FaultCase{"UnknownEscape", "[\"a$$\\q\"]", {"W001"}, "unknown escape \\q"},
        FaultCase{"ShortUnicode", "[\"$$\\u12g4\"]", {"W001"}, "four hexadecimal digits"},
        FaultCase{"LoneSurrogate", "[\"$$\\ud800x\"]", {"W001"}, "surrogate"},
        FaultCase{"EscapedNul", "[\"$$\\u0000\"]", {"W001"}, "\\u0000"},
        FaultCase{"LeadingZero", "[$$01]", {"W001"}, "\"01\" is not a number", "leading zeros"},
        FaultCase{"NoDigitBehindPoint", "[$$1.]", {"W001"}, "not a number", "after the decimal point"},
        FaultCase{"Plus", "[$$+1]", {"W001"}, "not a number", "'+'"},
        FaultCase{"Hex", "[$$0x10]", {"W001"}, "not a number", "decimal"},
        FaultCase{"Huge", "[$$1e999]", {"W001"}, "out of range"},
        FaultCase{"OpenComment", "{} \n$$/* never", {"W001"}, "comment has no end", "*/"},
        FaultCase{
            "BadUtf8", "{\n\"a\": \"$$\xE9\"}", {"W005"}, "not UTF-8: found the invalid byte 0xE9", "UTF-8"},
        FaultCase{"OverlongUtf8", "[\"$$\xC0\xAF\"]", {"W005"}, "not UTF-8"},
        FaultCase{"EveryDuplicate",
                  "{\"a\": 1, \"b\": {\"c\": 1,\n  $$\"c\": 2},\n $$\"a\": 3, $$\"a\": 4}",
                  {"W003", "W003", "W003"},
                  "\"c\" occurs twice in this object"},
        FaultCase{"DuplicateAndSyntax", "[{\"a\": 1, $$\"a\": 2}, $$}", {"W003", "W001"}, "twice"},
        FaultCase{"TooDeep", std::string(64, '[') + "$$[", {"W004"}, "64 levels deep"},
        FaultCase{"LongString", "[$$\"" + std::string(5000, 'x') + "\"]", {"W004"}, "more than 4096"}),
    case_name);

TEST(ReadJson, AMissingFileSaysWhatWasLookedFor) {
    const auto nothing = [](const std::string&) { return std::optional<std::string>(); };
    const Result<JsonDoc> result = read_json("graphs/none.json", nothing);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.errors().front().code, "W002");
    EXPECT_EQ(result.errors().front().file, "graphs/none.json");
    EXPECT_NE(result.errors().front().message.find("graphs/none.json"), std::string::npos);
}

TEST(ReadJson, ADuplicatePointsAtBothPlaces) {
    const Result<JsonDoc> result = read_text("{\"a\": 1,\n   \"a\": 2}");
    ASSERT_FALSE(result.ok());
    const Diagnostic& error = result.errors().front();
    EXPECT_EQ(place(error), "graph.json:2:4");
    ASSERT_EQ(error.notes.size(), 1u);
    EXPECT_EQ(error.notes[0].line, 1u);
    EXPECT_EQ(error.notes[0].column, 2u);
    EXPECT_EQ(error.notes[0].file, "graph.json");
}

TEST(ReadJson, AnUnclosedBracePointsAtItsOpening) {
    const Result<JsonDoc> result = read_text("{\"a\": 1,\n   \"b\": {\n");
    ASSERT_FALSE(result.ok());
    ASSERT_EQ(result.errors().front().notes.size(), 1u);
    EXPECT_EQ(result.errors().front().notes[0].line, 2u);
    EXPECT_EQ(result.errors().front().notes[0].column, 9u);
}

TEST(ReadJson, FilesThatAreTooLargeAreRefusedUnread) {
    EXPECT_EQ(read_text(std::string((8u << 20) + 1, ' ')).errors().front().code, "W004");
    std::string many = "[";
    for (int i = 0; i < 300'000; ++i) many += "0,";
    EXPECT_EQ(read_text(many + "]").errors().front().code, "W004");
}

TEST(ReadJson, EveryValueKnowsItsPlace) {
    const Result<JsonDoc> result = read_text(
        "\xEF\xBB\xBF// first\r\n{ \"a\": [1, -2.5e1, \"x\\n\\u00e9\\ud83d\\ude00\",],\n\t/* b */ \"b\": "
        "null, }");
    ASSERT_TRUE(result.ok()) << to_text(result.errors());
    const JsonNode* a = result->root.find("a");
    ASSERT_NE(a, nullptr);
    ASSERT_EQ(a->items.size(), 3u);
    EXPECT_EQ(a->items[1].number, -25);
    EXPECT_EQ(a->items[1].string, "-2.5e1");
    EXPECT_EQ(a->items[1].loc.line, 2u);
    EXPECT_EQ(a->items[1].loc.column, 12u);
    EXPECT_EQ(a->items[1].loc.length, 6u);
    EXPECT_EQ(a->items[2].string, "x\n\xC3\xA9\xF0\x9F\x98\x80");
    EXPECT_EQ(result->root.members[1].key_loc.line, 3u);
    EXPECT_EQ(result->root.members[1].key_loc.column, 10u);
    EXPECT_EQ(result->root.members[1].key_loc.length, 3u);
}

}  // namespace
}  // namespace weft::test
