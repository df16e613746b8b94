// Tests that the JSON schema contains exactly the keys that the parser accepts. The tests read the schema
// from graphs/weft.schema.json. Another test compares the schema file with the output of `weft schema`.
#include "graph/parse/grammar_tables.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

namespace weft::test {
namespace {

using Json = nlohmann::json;
using Words = std::set<std::string>;

const Json& schema() {
    static const Json parsed = [] {
        std::ifstream in(WEFT_SOURCE_DIR "/graphs/weft.schema.json");
        return Json::parse(in);
    }();
    return parsed;
}

Words keys_of(const Json& object) {
    Words keys;
    for (const auto& [key, unused] : object.items()) keys.insert(key);
    return keys;
}

const Json& place(const std::string& name) {
    return name == "graph" ? schema() : schema().at("definitions").at(name);
}

Words words_of(const GrammarTable& list) {
    return {list.words.begin(), list.words.end()};
}

TEST(Schema, HasEveryKeyOfTheParserAndNoOther) {
    size_t places = 0;
    for (const GrammarTable& list : grammar_tables()) {
        if (!list.are_keys) continue;
        EXPECT_EQ(keys_of(place(list.place).at("properties")), words_of(list)) << list.place;
        EXPECT_EQ(place(list.place).at("additionalProperties"), false) << list.place;
        ++places;
    }
    EXPECT_GE(places, 30u);
}

TEST(Schema, HasEveryChoiceOfTheParserAndNoOther) {
    for (const GrammarTable& list : grammar_tables()) {
        if (list.are_keys || list.place == "formatName" || list.place == "plainElement") continue;
        EXPECT_EQ(place(list.place).at("enum").get<Words>(), words_of(list)) << list.place;
    }
}

// The other tests start from the tables of the parser, so they would not notice a definition that only the
// schema has.
TEST(Schema, DescribesNoObjectThatTheParserDoesNotList) {
    Words listed;
    for (const GrammarTable& list : grammar_tables())
        if (list.are_keys) listed.insert(list.place);
    for (const auto& [name, definition] : schema().at("definitions").items()) {
        const bool is_patch = name.ends_with(".patch");
        if (!definition.contains("properties") || is_patch || name == "pass") continue;
        EXPECT_TRUE(listed.contains(name)) << name;
    }
}

TEST(Schema, ExplainsEveryKey) {
    const Words plain{"front", "back",     "constant",  "slope",    "clamp",     "kind",
                      "fill",  "topology", "depthBias", "readMask", "writeMask", "reference"};
    for (const GrammarTable& list : grammar_tables()) {
        if (!list.are_keys || !list.kind_of.empty() || list.place == "patch" || list.place == "graph")
            continue;
        for (const auto& [key, property] : place(list.place).at("properties").items())
            EXPECT_TRUE(property.contains("markdownDescription") || plain.contains(key))
                << list.place << "." << key;
    }
}

}  // namespace
}  // namespace weft::test
