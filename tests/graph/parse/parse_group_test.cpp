// Tests the section "groups": the full names of a group's passes and resources, and the errors for faults in
// a group. "$$" marks the place of each expected error; the tests remove the marks before they parse the
// text.
#include <map>

#include "graph/parse/debug_view.h"
#include "graph/syntax/read_graph.h"
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

constexpr const char* kRelight = R"json({
  "version": 1,
  "imports": { "probeTurns": "turns", "sky": "image" },
  "resources": { "probes": { "format": "rgba16f", "size": 128, "layers": 6, "keep": true }, "spare": "rgba16f" },
  "groups": { "relight": {
    "repeat": { "m": "0..5" }, "perFrame": 2, "turns": "probeTurns", "warmUp": 3, "rest": true, "settle": 1,
    "resources": {
      "raw": { "format": "rgba16f", "size": 128, "mips": "full" },
      "low": { "format": "rgba16f", "size": 64, "mips": "mips(raw)-1" },
      "ms": { "format": "rgba16f", "samples": 4 }, "args": { "buffer": "u32", "count": 3 }, "tmp": "r8"
    },
    "passes": {
      "light": { "type": "compute", "shader": "relight.comp", "in": { "bounce": { "ref": "probes", "wakes": false } },
                 "out": { "dst": "raw.mip(0)" } },
      "down": { "type": "compute", "shader": "down.comp", "repeat": { "k": "1..mips(raw)-1" },
                "in": { "src": "raw@down.mip(k-1)", "sky": { "ref": "tmp", "else": "sky@show" } },
                "out": { "dst": "raw.mip(k)" }, "groups": { "indirect": "args" }, "after": ["draw", "show"] },
      "draw": { "type": "raster", "shader": "draw", "draws": { "vertices": "mips(low)" }, "out": ["ms", "relight::tmp"],
                "resolve": { "low.mip(0)": "ms" }, "if": "mips(probes)" },
      "filter": { "type": "compute", "shader": "filter.comp", "in": ["raw@light", "low@relight::draw"],
                  "out": { "dst": "probes.layer(m)" }, "params": { "last": "mips(relight::raw)" } }
    } } },
  "passes": { "show": { "type": "compute", "shader": "show.comp", "in": ["probes@relight::filter"], "out": ["spare"],
              "after": ["relight::filter"] } },
  "debug": { "Raw": "relight::raw.mip(1)" }
})json";

GraphDesc relight() {
    Result<GraphDesc> graph = parse_text(kRelight);
    EXPECT_TRUE(graph.ok()) << (graph.ok() ? "" : to_text(graph.errors()));
    return graph.ok() ? std::move(graph).value() : GraphDesc{};
}

template <class T>
std::string names_of(const std::map<std::string, T>& map) {
    std::string text;
    for (const auto& [name, unused] : map) text += (text.empty() ? "" : " ") + name;
    return text;
}

std::string indices_of(const std::vector<RepeatDesc>& repeats) {
    std::string text;
    for (const RepeatDesc& repeat : repeats) text += repeat.index;
    return text;
}

std::string image_in(const Expr& expression) {
    for (const ExprNode& node : expression.postfix)
        if (node.op == ExprOp::mips_of) return node.name;
    return {};
}

TEST(ParseGroup, HasItsKeys) {
    const GraphDesc graph = relight();
    const GroupDesc& group = graph.groups.at("relight");
    EXPECT_EQ(group.name, "relight");
    EXPECT_EQ(indices_of(group.repeat), "m");
    EXPECT_EQ(number_of(group.per_frame), 2);
    EXPECT_EQ(group.turns, "probeTurns");
    EXPECT_EQ(number_of(group.warm_up), 3);
    EXPECT_TRUE(group.rests);
    EXPECT_EQ(number_of(group.settle), 1);
    EXPECT_EQ(graph.sources.describe(group.loc), "graph.json:5:15");
    EXPECT_EQ(graph.sources.describe(group.per_frame_loc), "graph.json:6:44");
    EXPECT_EQ(graph.sources.describe(group.turns_loc), "graph.json:6:56");
    EXPECT_EQ(graph.sources.describe(group.warm_up_loc), "graph.json:6:80");
    EXPECT_EQ(graph.sources.describe(group.rest_loc), "graph.json:6:91");
    EXPECT_EQ(graph.sources.describe(group.settle_loc), "graph.json:6:107");
}

TEST(ParseGroup, PerFrameIsASwitchOrANumber) {
    const auto per_frame = [](const std::string& value) {
        const Result<GraphDesc> graph = parse_text(
            R"({"version": 1, "passes": {}, "groups": {"g": {"repeat": {"i": "0..1"}, "perFrame": )" + value +
            R"(, "passes": {"p": {"type": "clear", "out": ["x"]}}}}})");
        EXPECT_TRUE(graph.ok()) << value;
        return graph.ok() ? graph->groups.at("g").per_frame : Expr{};
    };
    EXPECT_EQ(number_of(per_frame("true")), 1);
    EXPECT_EQ(number_of(per_frame("0")), 0);
    EXPECT_TRUE(per_frame("false").empty());
    EXPECT_EQ(per_frame("\"1 + 1\"").text, "1 + 1");
}

TEST(ParseGroup, PartsJoinTheGraphUnderFullNames) {
    const GraphDesc graph = relight();
    EXPECT_EQ(names_of(graph.passes), "relight::down relight::draw relight::filter relight::light show");
    EXPECT_EQ(names_of(graph.resources),
              "probes relight::args relight::low relight::ms relight::raw relight::tmp spare");
    EXPECT_EQ(graph.passes.at("relight::down").name, "relight::down");
    EXPECT_EQ(graph.passes.at("relight::down").group, "relight");
    EXPECT_EQ(graph.resources.at("relight::raw").name, "relight::raw");
    EXPECT_EQ(graph.resources.at("relight::raw").group, "relight");
    EXPECT_EQ(graph.passes.at("show").group, "");
    EXPECT_EQ(graph.resources.at("probes").group, "");
    EXPECT_EQ(indices_of(graph.passes.at("relight::light").repeat), "m");
    EXPECT_EQ(indices_of(graph.passes.at("relight::down").repeat), "mk");
    EXPECT_EQ(indices_of(graph.passes.at("show").repeat), "");
}

TEST(ParseGroup, NamesInsideMeanItsOwnPartsFirst) {
    const GraphDesc graph = relight();
    const PassDesc& light = graph.passes.at("relight::light");
    EXPECT_EQ(light.in.at(0).ref.name, "probes");
    EXPECT_FALSE(light.in.at(0).wakes);
    EXPECT_EQ(light.out.at(0).ref.name, "relight::raw");
    EXPECT_EQ(light.out.at(0).ref.text, "raw.mip(0)") << "messages quote the author";
    const PassDesc& down = graph.passes.at("relight::down");
    EXPECT_EQ(down.in.at(0).ref.name, "relight::raw");
    EXPECT_EQ(down.in.at(0).ref.pass, "relight::down");
    EXPECT_EQ(down.in.at(1).ref.name, "relight::tmp");
    EXPECT_EQ(down.in.at(1).otherwise->name, "sky");
    EXPECT_EQ(down.in.at(1).otherwise->pass, "show");
    EXPECT_EQ(down.indirect->ref.name, "relight::args");
    EXPECT_EQ(down.after, (std::vector<std::string>{"relight::draw", "show"}));
    EXPECT_EQ(image_in(down.repeat.at(1).last), "relight::raw");
    const PassDesc& draw = graph.passes.at("relight::draw");
    EXPECT_EQ(image_in(draw.vertices), "relight::low");
    EXPECT_EQ(image_in(draw.condition), "probes");
    EXPECT_EQ(draw.resolves.at(0).target.ref.name, "relight::low");
    EXPECT_EQ(draw.resolves.at(0).target.port, "low");
    EXPECT_EQ(draw.out.at(0).ref.name, "relight::ms");
    EXPECT_EQ(draw.out.at(1).ref.name, "relight::tmp");
    EXPECT_EQ(draw.out.at(1).port, "tmp") << "a port has no group in its name";
    const PassDesc& filter = graph.passes.at("relight::filter");
    EXPECT_EQ(filter.in.at(0).port, "raw");
    EXPECT_EQ(filter.in.at(0).ref.pass, "relight::light");
    EXPECT_EQ(filter.in.at(1).ref.pass, "relight::draw");
    EXPECT_EQ(image_in(filter.params.at(0).components.at(0)), "relight::raw");
    EXPECT_EQ(image_in(graph.resources.at("relight::low").mips), "relight::raw");
}

TEST(ParseGroup, OutsideFullNamesAreNeeded) {
    const GraphDesc graph = relight();
    const PassDesc& show = graph.passes.at("show");
    EXPECT_EQ(show.in.at(0).port, "probes");
    EXPECT_EQ(show.in.at(0).ref.pass, "relight::filter");
    EXPECT_EQ(show.after, (std::vector<std::string>{"relight::filter"}));
    EXPECT_EQ(graph.debug.at("Raw").show.name, "relight::raw");
    EXPECT_TRUE(debug_view_faults(graph).empty());
    GraphDesc shown = graph;
    EXPECT_TRUE(add_debug_view(shown, {}, "relight::raw").ok());
}

using Files = std::map<std::string, std::string>;

Result<GraphDesc> load(const Files& files, const std::string& tier = "") {
    const FileReader reader = [&](const std::string& path) {
        const auto it = files.find(path);
        return it == files.end() ? std::nullopt : std::optional<std::string>(it->second);
    };
    Result<JsonDoc> document = read_graph("pipes/main.json", reader, {"shipped", {}});
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(*document), tier);
    if (!merged) return merged.take_errors();
    return parse(*merged);
}

TEST(ParseGroup, IncludesAndTiersChangeItsParts) {
    Files files{{"pipes/base.json", kRelight}};
    files["pipes/main.json"] = R"json({ "version": 1, "include": ["base.json"],
      "groups": { "relight": { "perFrame": null, "resources": { "ms": null, "raw": { "size": 32 } },
        "passes": { "draw": null, "down": { "after": ["light"] }, "filter": { "in": null, "shader": "f.comp" },
                    "extra": { "type": "copy", "in": ["raw"], "out": { "dst": "tmp" } } } } },
      "tiers": { "low": { "patch": { "groups": { "relight": { "warmUp": 1, "resources": { "tmp": "r16f" },
        "passes": { "filter": { "in": ["tmp"] }, "extra": null } } } } } } })json";
    const Result<GraphDesc> plain = load(files);
    ASSERT_TRUE(plain.ok()) << to_text(plain.errors());
    EXPECT_EQ(names_of(plain->passes), "relight::down relight::extra relight::filter relight::light show");
    EXPECT_TRUE(plain->groups.at("relight").per_frame.empty());
    EXPECT_EQ(number_of(plain->resources.at("relight::raw").size), 32);
    EXPECT_EQ(plain->passes.at("relight::filter").shader, "f.comp");
    EXPECT_EQ(plain->passes.at("relight::down").after, (std::vector<std::string>{"relight::light"}));
    const Result<GraphDesc> low = load(files, "low");
    ASSERT_TRUE(low.ok()) << to_text(low.errors());
    EXPECT_FALSE(low->passes.contains("relight::extra"));
    EXPECT_EQ(number_of(low->groups.at("relight").warm_up), 1);
    EXPECT_EQ(low->resources.at("relight::tmp").formats, (std::vector<std::string>{"r16f"}));
    EXPECT_EQ(low->passes.at("relight::filter").in.at(0).port, "tmp");
    EXPECT_EQ(low->passes.at("relight::filter").in.at(0).ref.name, "relight::tmp");
}

class ParseGroupFaultTest : public ::testing::TestWithParam<FaultCase> {};
TEST_P(ParseGroupFaultTest, IsAtItsValueWithARemedy) {
    check_parse_fault(GetParam());
}

// Returns a graph with the group `body`. The passes of the graph come last in the file.
std::string graph_with(const std::string& body, const std::string& sections = "") {
    return "{\"version\": 1, " + sections + "\"resources\": {\"x\": \"r8\"},\n \"groups\": {" + body +
           "},\n \"consts\": {\"c\": 1}, \"imports\": {\"list\": \"drawlist\"},\n"
           " \"passes\": {\"show\": {\"type\": \"clear\", \"out\": [\"x\"]}}}";
}
std::string one_group(const std::string& keys) {
    return graph_with("\"g\": {" + keys + ", \"passes\": {\"p\": {\"type\": \"clear\", \"out\": [\"x\"]}}}");
}
std::string with_rounds(const std::string& keys) {
    return one_group("\"repeat\": {\"i\": \"0..3\"}, " + keys);
}
std::string with_passes(const std::string& passes) {
    return graph_with("\"g\": {\"repeat\": {\"i\": \"0..3\"}, \"passes\": {" + passes + "}}");
}
std::string with_resource(const std::string& keys) {
    return one_group("\"resources\": {\"raw\": {\"format\": \"r8\", " + keys + "}}");
}

INSTANTIATE_TEST_SUITE_P(
    Keys, ParseGroupFaultTest,
    ::testing::Values(
        FaultCase{"NoPasses",
                  graph_with("$$\"g\": {\"rest\": true}"),
                  {"W108"},
                  "a group needs the key \"passes\""},
        FaultCase{"EmptyPasses",
                  graph_with("\"g\": {\"passes\": $${}}"),
                  {"W109"},
                  "no passes",
                  "remove the group"},
        FaultCase{
            "UnknownKey", one_group("$$\"turn\": 1"), {"W101"}, "in a group", "did you mean \"turns\"?"},
        FaultCase{"BadName", graph_with("$$\"g::h\": {}"), {"W109"}, "not a valid name for a group"},
        FaultCase{"NoObject", graph_with("\"g\": $$[]"), {"W102"}, "found"},
        FaultCase{"PerFrameAlone",
                  one_group("$$\"perFrame\": 1"),
                  {"W109"},
                  "only for groups with \"repeat\"",
                  "\"repeat\""},
        FaultCase{"TurnsAlone",
                  one_group("$$\"turns\": $$\"list\""),
                  {"W109", "W109"},
                  "only for groups with \"repeat\""},
        FaultCase{
            "WarmUpAlone", one_group("$$\"warmUp\": 1"), {"W109"}, "\"warmUp\" is only for", "\"repeat\""},
        FaultCase{"SettleAlone",
                  one_group("\"rest\": true, $$\"settle\": 1"),
                  {"W109"},
                  "only for groups with \"repeat\""},
        FaultCase{"SettleAwake",
                  with_rounds("$$\"settle\": 1"),
                  {"W109"},
                  "only for groups with \"rest\"",
                  "\"rest\": true"},
        FaultCase{"SettleRestless",
                  with_rounds("\"rest\": false, $$\"settle\": 1"),
                  {"W109"},
                  "only for groups with \"rest\""},
        FaultCase{"RestNumber", with_rounds("\"rest\": $$1"), {"W102"}, "wanted true or false"},
        FaultCase{"WarmUpBool", with_rounds("\"warmUp\": $$true"), {"W102"}, "found"},
        FaultCase{"NoImport",
                  with_rounds("\"turns\": $$\"spin\""),
                  {"W109"},
                  "no import \"spin\"",
                  "\"imports\": { \"spin\": \"turns\" }"},
        FaultCase{"WrongImport",
                  with_rounds("\"turns\": $$\"list\""),
                  {"W109"},
                  "of kind \"drawlist\", not \"turns\""},
        FaultCase{"IndexOfAConstant",
                  graph_with("\"g\": {\"repeat\": {$$\"c\": \"0..3\"}, \"passes\": {"
                             "\"p\": {\"type\": \"clear\", \"out\": [\"x\"]}, \"q\": {\"type\": \"clear\", "
                             "\"out\": [\"x\"]}}}"),
                  {"W109"},
                  "already a constant"}),
    case_name);

INSTANTIATE_TEST_SUITE_P(
    Parts, ParseGroupFaultTest,
    ::testing::Values(
        FaultCase{"PassPerFrame",
                  with_passes("\"p\": {\"type\": \"clear\", \"out\": [\"x\"], $$\"perFrame\": 1}"),
                  {"W109"},
                  "cannot have \"perFrame\"",
                  "move the key to the group"},
        FaultCase{"PassRest",
                  with_passes("\"p\": {\"type\": \"clear\", \"out\": [\"x\"], $$\"rest\": true}"),
                  {"W109"},
                  "cannot have \"rest\""},
        FaultCase{"Readback",
                  with_passes("\"p\": {\"type\": $$\"readback\", \"in\": [\"x\"]}"),
                  {"W109"},
                  "readback",
                  "\"passes\" of the graph"},
        FaultCase{
            "SameIndex",
            with_passes("\"p\": {\"type\": \"clear\", \"out\": [\"x\"], \"repeat\": {$$\"i\": \"0..1\"}}"),
            {"W109"},
            "already an index of the group"},
        FaultCase{
            "OwnIndexOfAConstant",
            with_passes("\"p\": {\"type\": \"clear\", \"out\": [\"x\"], \"repeat\": {$$\"c\": \"0..1\"}}"),
            {"W109"},
            "already a constant"},
        FaultCase{
            "Keep", with_resource("$$\"keep\": true"), {"W109"}, "cannot have \"keep\"", "of the graph"},
        FaultCase{"History", with_resource("$$\"history\": 1"), {"W109"}, "lasts only for one round"},
        FaultCase{"FirstFrame", with_resource("$$\"firstFrame\": 1"), {"W109"}, "\"firstFrame\""},
        FaultCase{"OnResize", with_resource("$$\"onResize\": \"clear\""), {"W109"}, "\"onResize\""},
        FaultCase{"NameOfAPass",
                  with_passes("$$\"show\": {\"type\": \"clear\", \"out\": [\"x\"]}"),
                  {"W109"},
                  "\"show\" is already used"},
        FaultCase{"NameOfAResource",
                  one_group("\"resources\": {$$\"x\": \"r8\"}"),
                  {"W109"},
                  "\"x\" is already used",
                  "another name"},
        FaultCase{
            "NameOfAnImport", one_group("\"resources\": {$$\"list\": \"r8\"}"), {"W109"}, "already used"},
        FaultCase{"HalfAName",
                  with_passes("\"p\": {\"type\": \"clear\", \"out\": [\"g::$$\"]}"),
                  {"W106"},
                  "the reference ends where the name of a resource"},
        FaultCase{"NoPassType", with_passes("$$\"p\": {}"), {"W108"}, "\"type\""}),
    case_name);

TEST(ParseGroup, ANameInUseSaysWhere) {
    const Result<GraphDesc> graph = parse_text(one_group("\"resources\": {\"x\": \"r8\"}"));
    ASSERT_FALSE(graph.ok());
    const Diagnostic& error = graph.errors().front();
    EXPECT_EQ(error.pointer, "/groups/g/resources/x");
    ASSERT_EQ(error.notes.size(), 1u);
    EXPECT_EQ(error.notes.front().file, "graph.json");
    EXPECT_EQ(error.notes.front().line, 1u);
}

TEST(ParseGroup, PointersGoThroughTheGroup) {
    const Result<GraphDesc> one = parse_text(
        with_passes("\"p\": {\"type\": \"clear\", \"out\": [\"x\"], \"repeat\": {\"c\": \"0..1\"}}"));
    ASSERT_FALSE(one.ok());
    EXPECT_EQ(one.errors().front().pointer, "/groups/g/passes/p/repeat/c");
    const Result<GraphDesc> two = parse_text(with_rounds("\"turns\": \"spin\""));
    ASSERT_FALSE(two.ok());
    EXPECT_EQ(two.errors().front().pointer, "/groups/g/turns");
}

TEST(ParseGroup, TwoGroupsMayUseTheSameNames) {
    const std::string body =
        "{\"resources\": {\"raw\": \"r8\"}, \"passes\": {"
        "\"p\": {\"type\": \"clear\", \"out\": [\"raw\"]}}}";
    const Result<GraphDesc> two = parse_text(graph_with("\"g\": " + body + ", \"h\": " + body));
    ASSERT_TRUE(two.ok()) << to_text(two.errors());
    EXPECT_EQ(names_of(two->resources), "g::raw h::raw x");
    EXPECT_EQ(two->passes.at("h::p").out.at(0).ref.name, "h::raw");
}

}  // namespace
}  // namespace weft::test
