// Tests the texts that a GraphBuilder writes: their layout, their strings, the places of errors, and that
// graphs rebuilt with the builder have the same plans. Also tests files in memory.
#include "weft/graph_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "graph/builder/json_text.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_text.h"
#include "weft/compile.h"
#include "weft/memory_files.h"

namespace weft::test {
namespace {

Result<JsonDoc> read_built(const weft::GraphBuilder& graph) {
    MemoryFiles files;
    files.put(graph.file_name(), graph.to_json());
    return read_json(graph.file_name(), files.reader([](const std::string&) { return std::nullopt; }));
}

// Reads a graph that must have one fault.
Diagnostic fault_of(const weft::GraphBuilder& graph) {
    Result<JsonDoc> read = read_built(graph);
    Result<JsonDoc> merged = Diagnostics{};
    Result<GraphDesc> parsed = Diagnostics{};
    if (read) merged = merge(std::move(*read));
    if (merged) parsed = parse(*merged);
    Diagnostics faults = !read ? read.take_errors() : !merged ? merged.take_errors() : Diagnostics{};
    if (read && merged && !parsed) faults = parsed.take_errors();
    EXPECT_EQ(faults.size(), 1u) << to_text(faults) << graph.to_json();
    return faults.empty() ? Diagnostic{} : faults.front();
}

std::string line_of(const std::string& text, uint32_t number) {
    std::istringstream lines(text);
    std::string line;
    for (uint32_t i = 0; i < number; ++i) std::getline(lines, line);
    return line;
}

GraphValue value_of(const JsonNode& node) {
    return GraphValue::json(json_text(node));
}

// Adds a pass by the functions for its ports, and all its other keys by their names.
void rebuild_pass(const JsonMember& pass, weft::GraphBuilder& graph) {
    const JsonNode* type = pass.value.find("type");
    const PassBuilder built = graph.pass(pass.key, type != nullptr ? type->string : "compute");
    for (const JsonMember& key : pass.value.members) {
        const bool named = key.value.kind == JsonKind::object;
        for (const JsonMember& port : key.value.members) {
            if (key.key == "in") built.in(port.key, value_of(port.value));
            if (key.key == "out") built.out(port.key, value_of(port.value));
            if (key.key == "params") built.param(port.key, value_of(port.value));
        }
        if (key.key == "type" || (named && (key.key == "in" || key.key == "out" || key.key == "params")))
            continue;
        built.set(key.key, value_of(key.value));
    }
}

// Makes a graph with a builder from the text of a graph.
weft::GraphBuilder rebuild(const std::string& text) {
    const Result<JsonDoc> doc = read_json("text", [&](const std::string&) { return std::optional(text); });
    EXPECT_TRUE(doc) << to_text(doc.errors());
    const JsonNode* name = doc->root.find("name");
    weft::GraphBuilder graph(name != nullptr ? name->string : "random");
    for (const JsonMember& section : doc->root.members) {
        if (section.key == "version" || section.key == "name") continue;
        if (section.value.members.empty()) graph.set(section.key, value_of(section.value));
        for (const JsonMember& entry : section.value.members) {
            if (section.key == "imports" && entry.value.kind == JsonKind::string) {
                graph.import(entry.key, entry.value.string);
            } else if (section.key == "passes") {
                rebuild_pass(entry, graph);
            } else if (entry.value.kind == JsonKind::object) {
                const EntryBuilder built = graph.entry(section.key, entry.key);
                for (const JsonMember& key : entry.value.members) built.set(key.key, value_of(key.value));
            } else {
                graph.set_in(section.key, entry.key, value_of(entry.value));
            }
        }
    }
    return graph;
}

TEST(GraphBuilderText, HasOneKeyPerLine) {
    weft::GraphBuilder graph("fog");
    graph.import("backbuffer", "output").constant("half", 0.5).size("small", {64, "output.y / 2"});
    graph.param("reach", 12).range(1, 100);
    graph.image("far", "r32f|r16f").size("output.x", 9).mips("full").layers(2).history(1).keep();
    graph.buffer("tiles", "u32", "ceil(output.x / 16)");
    PassBuilder halve = graph.compute("halve", "halve.comp").threads("output.x", 4);
    graph.entry("views", "mirror").set("of", "camera");
    graph.set("frames", 8u);
    halve.in("src", "far[-1]").out("tiles").after({"a", "b"}).repeat("i", "0..3").set("rest", true);
    EXPECT_EQ(graph.to_json(), R"json({
  "version": 1,
  "name": "fog",
  "imports": {
    "backbuffer": "output"
  },
  "consts": {
    "half": 0.5
  },
  "sizes": {
    "small": [64, "output.y / 2"]
  },
  "params": {
    "reach": {
      "default": 12,
      "range": [1, 100]
    }
  },
  "resources": {
    "far": {
      "format": "r32f|r16f",
      "size": ["output.x", 9],
      "mips": "full",
      "layers": 2,
      "history": 1,
      "keep": true
    },
    "tiles": {
      "buffer": "u32",
      "count": "ceil(output.x / 16)"
    }
  },
  "passes": {
    "halve": {
      "type": "compute",
      "shader": "halve.comp",
      "threads": ["output.x", 4, 1],
      "in": { "src": "far[-1]" },
      "out": { "tiles": "tiles" },
      "after": ["a", "b"],
      "repeat": { "i": "0..3" },
      "rest": true
    }
  },
  "views": {
    "mirror": {
      "of": "camera"
    }
  },
  "frames": 8
}
)json");
}

TEST(GraphBuilderText, KeepsEveryCharacterAndDigit) {
    std::string all;
    for (char c = 1; c < 127; ++c) all += c;
    all += "\x7f\xc3\xa9\xf0\x9f\x8c\xab";
    weft::GraphBuilder graph("fog \"1\"\n");
    graph.set(all, all).set("tenth", 0.1).set("large", uint64_t{1} << 53).set("least", -1.5e-300);
    graph.set_json("state",
                   R"({ "blend": "add", /* a comment */ "writeMask": ["\"", null, 1.50,], "no": {} })");
    const Result<JsonDoc> read = read_built(graph);
    ASSERT_TRUE(read) << to_text(read.errors()) << graph.to_json();
    EXPECT_EQ(read->root.find("name")->string, "fog \"1\"\n");
    ASSERT_NE(read->root.find(all), nullptr);
    EXPECT_EQ(read->root.find(all)->string, all);
    EXPECT_EQ(read->root.find("tenth")->number, 0.1);
    EXPECT_EQ(read->root.find("large")->string, "9007199254740992");
    EXPECT_EQ(read->root.find("least")->number, -1.5e-300);
    EXPECT_NE(graph.to_json().find(R"("writeMask": ["\"", null, 1.50],)"), std::string::npos)
        << graph.to_json();
}

// Other members are added, so that the vectors that contain the pass grow. Then the builder is moved.
TEST(GraphBuilderText, ObjectsStayValid) {
    weft::GraphBuilder first("fog");
    const PassBuilder pass = first.compute("halve", "halve.comp").param("early", 1);
    for (int i = 0; i < 100; ++i) {
        first.compute("pass" + std::to_string(i), "other.comp");
        first.entry("section" + std::to_string(i), "entry");
    }
    const weft::GraphBuilder moved = std::move(first);
    const PassBuilder copy = pass;
    copy.param("late", 3);
    EXPECT_NE(moved.to_json().find(R"("params": { "early": 1, "late": 3 })"), std::string::npos)
        << moved.to_json();
}

TEST(GraphBuilderText, ValuesAreWrittenAsJson) {
    const std::vector<GraphValue> none, some{1, "output.x"};
    EXPECT_EQ(GraphValue(true).to_json(), "true");
    EXPECT_EQ(GraphValue(-3).to_json(), "-3");
    EXPECT_EQ(GraphValue(0.25f).to_json(), "0.25");
    EXPECT_EQ(GraphValue(none).to_json(), "[]");
    EXPECT_EQ(GraphValue({some, "b", false}).to_json(), R"([[1, "output.x"], "b", false])");
    EXPECT_EQ(GraphValue({GraphValue::json(""), 1}).to_json(), "[, 1]") << "the fault is kept";
}

// The parser reports a key that it does not know.
TEST(GraphBuilderText, EveryFunctionAddsAKeyOfTheFormat) {
    weft::GraphBuilder graph("all");
    graph.import("backbuffer", "output").import("opaque", "drawlist");
    graph.constant("half", 0.5).size("small", {64, "output.y * half"}).set_in("debug", "Depth", "far");
    graph.param("reach", 12).range(1, 100).set("unit", "m");
    graph.image("far", "r32f").size("small").mips(2).layers(6).history(1).keep();
    graph.image("depth", "d32f").size(64, 32);
    graph.buffer("tiles", "u32", 16);
    graph.entry("views", "faces").set_json("cube", R"({ "at": [0, 1.5, 0], "near": 0.1 })");
    graph.compute("make", "make.comp").in("old", "far[-1]").out("far").threads(64).repeat("i", "0..1");
    graph.compute("count", "count.comp")
        .in("far")
        .out("tiles")
        .groups(8, 8)
        .param("reach", 2)
        .after({"make"});
    graph.raster("draw", "draw").draws({"opaque"}).view("camera").depth("depth").constant("kMode", 1);
    graph.raster("all", "draw").draws({"opaque"}).views("faces", "layers").out("color", "far");
    graph.fullscreen("show", "show.frag").in("tiles").out("color", "backbuffer");
    graph.pass("wipe", "clear").set("out", {"far"}).clear({0, 0, 0, 1});
    Result<JsonDoc> read = read_built(graph);
    ASSERT_TRUE(read) << to_text(read.errors()) << graph.to_json();
    const Result<JsonDoc> merged = merge(std::move(*read));
    ASSERT_TRUE(merged) << to_text(merged.errors());
    const Result<GraphDesc> parsed = parse(*merged);
    EXPECT_TRUE(parsed) << to_text(parsed.errors()) << graph.to_json();
}

TEST(GraphBuilderText, ErrorsNameTheLineOfTheKey) {
    weft::GraphBuilder graph("fog");
    graph.image("made", "r32f");
    graph.compute("make", "make.comp").out("made").set("shadr", "other.comp");
    const Diagnostic unknown = fault_of(graph);
    EXPECT_EQ(unknown.code, "W101");
    EXPECT_EQ(unknown.file, "fog (made in C++)");
    EXPECT_EQ(unknown.source_line, "      \"shadr\": \"other.comp\"");
    EXPECT_EQ(line_of(graph.to_json(), unknown.line), unknown.source_line);
}

TEST(GraphBuilderText, WhatIsAddedTwiceIsAnError) {
    weft::GraphBuilder passes("fog");
    passes.compute("make", "make.comp");
    passes.compute("make", "other.comp");
    EXPECT_EQ(fault_of(passes).code, "W003");
    weft::GraphBuilder keys("fog");
    keys.compute("make", "make.comp").set("rest", true).set("rest", false);
    EXPECT_EQ(fault_of(keys).code, "W003");
    EXPECT_EQ(fault_of(keys).source_line, "      \"rest\": false");
    weft::GraphBuilder sections("fog");
    sections.compute("make", "make.comp");
    sections.set_json("passes", "{}");
    EXPECT_EQ(fault_of(sections).code, "W003");
    EXPECT_EQ(fault_of(sections).source_line, "  \"passes\": {}");
}

TEST(GraphBuilderText, ValuesThatJsonLacksAreErrorsAtTheirPlace) {
    weft::GraphBuilder json("fog");
    json.compute("make", "make.comp").set_json("state", "{ \"cull\": none }");
    EXPECT_EQ(fault_of(json).code, "W001");
    EXPECT_EQ(fault_of(json).source_line, "      \"state\": { \"cull\": none }");
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        weft::GraphBuilder number("fog");
        number.compute("make", "make.comp").param("far", value);
        EXPECT_EQ(fault_of(number).code, "W001");
        EXPECT_EQ(fault_of(number).line, 8u);
    }
    weft::GraphBuilder text("fog");
    text.compute("make", "\xff.comp");
    EXPECT_EQ(fault_of(text).code, "W005");
}

TEST(GraphBuilderText, RandomGraphsHaveTheSamePlan) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 2000 : 100;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const RandomText made = random_text(seed, fake_profile());
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::string built = rebuild(made.text).to_json();
        const Result<ResolvedGraph> expected = resolve_text(made.text, made.params, fake_profile());
        const Result<ResolvedGraph> graph = resolve_text(built, made.params, fake_profile());
        ASSERT_TRUE(expected.ok()) << to_text(expected.errors());
        ASSERT_TRUE(graph.ok()) << to_text(graph.errors()) << built;
        ASSERT_EQ(plan_hash(compile(*graph, content_needs(*graph), {})),
                  plan_hash(compile(*expected, content_needs(*expected), {})))
            << made.text << built;
    }
}

TEST(GraphBuilderText, RandomFaultsAreReportedAtTheirLines) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 2000 : 100;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const FaultyText made = random_faulty_text(seed, fake_profile());
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.how);
        const std::string built = rebuild(made.text).to_json();
        const Result<ResolvedGraph> graph = resolve_text(built, made.params, fake_profile());
        const Result<ResolvedGraph> original = resolve_text(made.text, made.params, fake_profile());
        ASSERT_FALSE(graph.ok()) << built;
        ASSERT_EQ(graph.errors().size(), original.errors().size());
        const Diagnostic& fault = graph.errors().front();
        EXPECT_EQ(fault.code, original.errors().front().code);
        EXPECT_EQ(fault.message, original.errors().front().message);
        EXPECT_EQ(fault.source_line, line_of(built, fault.line));
    }
}

TEST(MemoryFiles, ComeBeforeOtherFiles) {
    MemoryFiles files;
    const FileReader reader = files.reader([](const std::string& path) -> std::optional<std::string> {
        if (path == "none.json") return std::nullopt;
        return "disk " + path;
    });
    EXPECT_EQ(reader("a/fog.json"), "disk a/fog.json");
    files.put("a/./fog.json", "one");
    EXPECT_EQ(reader("a/b/../fog.json"), "one");
    files.put("a/fog.json", "two");
    EXPECT_EQ(reader("a/fog.json"), "two");
    EXPECT_EQ(reader("a/mist.json"), "disk a/mist.json");
    EXPECT_EQ(reader("none.json"), std::nullopt);
}

}  // namespace
}  // namespace weft::test
