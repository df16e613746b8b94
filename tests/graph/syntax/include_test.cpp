// Tests included graph files: the order of merging, the message for each fault, and that no file outside the
// allowed folders is read.
#include <map>

#include "graph/syntax/read_graph.h"
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

using Files = std::map<std::string, std::string>;

// Graph files from which the marks "$$" are removed, and the places of the marks. A mark shows where an error
// is expected.
struct Marked {
    Files files;
    std::vector<std::string> places;
};

Marked unmark_all(const Files& files) {
    Marked out;
    for (const auto& [name, text] : files) {
        const MarkedText marked = unmark(text);
        out.files[name] = marked.text;
        for (const std::string& place : marked.places)
            out.places.push_back(name + place.substr(std::string("graph.json").size()));
    }
    return out;
}

Result<JsonDoc> read_files(const Files& files, const GraphLimits& limits = {}) {
    const FileReader reader = [&](const std::string& path) {
        const auto it = files.find(path);
        return it == files.end() ? std::nullopt : std::optional<std::string>(it->second);
    };
    return read_graph("pipes/main.json", reader, {"shipped", limits});
}

Result<GraphDesc> load(const Files& files, const std::string& tier = "") {
    Result<JsonDoc> document = read_files(files);
    if (!document) return document.take_errors();
    Result<JsonDoc> merged = merge(std::move(*document), tier);
    if (!merged) return merged.take_errors();
    return parse(*merged);
}

std::string codes_of(const Diagnostics& faults) {
    std::string text;
    for (const Diagnostic& fault : faults) text += (text.empty() ? "" : " ") + fault.code;
    return text;
}

void expect_fault(const Files& marked_files, const std::string& code, const std::string& message,
                  const std::string& help) {
    const Marked marked = unmark_all(marked_files);
    const Result<GraphDesc> graph = load(marked.files);
    ASSERT_FALSE(graph.ok()) << "no fault found";
    ASSERT_EQ(graph.errors().size(), 1u) << to_text(graph.errors());
    const Diagnostic& fault = graph.errors().front();
    EXPECT_EQ(fault.code, code) << to_text(fault);
    ASSERT_EQ(marked.places.size(), 1u);
    EXPECT_EQ(place(fault), marked.places.front()) << to_text(fault);
    EXPECT_NE(fault.message.find(message), std::string::npos) << to_text(fault);
    EXPECT_NE(joined_help(fault).find(help), std::string::npos) << to_text(fault);
}

const char* const kModule = R"({
  "consts": {"taps": 4, "sides": 2},
  "resources": {"hdr": "rgba16f", "spare": {"format": "r8", "mips": 2}},
  "passes": {"p": {"type": "clear", "out": ["hdr"], "clear": 0}}
})";

TEST(Include, LiesUnderTheIncludingFile) {
    const Result<GraphDesc> graph = load({{"pipes/main.json", R"({"version": 1, "include": ["parts/a.json"],
        "consts": {"taps": 8}, "resources": {"spare": "rg8", "own": "r16f"},
        "passes": {"p": {"after": ["q"], "out": ["own"]}}})"},
                                          {"pipes/parts/a.json", kModule}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->name, "main");
    EXPECT_EQ(number_of(graph->consts.at("taps")), 8);
    EXPECT_EQ(number_of(graph->consts.at("sides")), 2);
    EXPECT_EQ(graph->resources.at("spare").formats, std::vector<std::string>{"rg8"});
    EXPECT_FALSE(graph->resources.at("spare").mips.empty()) << "what isn't named stays";
    EXPECT_EQ(graph->resources.size(), 3u);
    EXPECT_EQ(graph->passes.at("p").after.size(), 1u);
    EXPECT_EQ(graph->passes.at("p").out.size(), 2u) << "ports are added, not replaced";
    ASSERT_EQ(graph->sources.files.size(), 2u);
    EXPECT_EQ(graph->sources.files[1].path, "pipes/parts/a.json");
    EXPECT_EQ(graph->sources.describe(graph->passes.at("p").loc), "pipes/parts/a.json:4:14");
}

TEST(Include, LaterFilesLieOverEarlierOnes) {
    const auto file = [](int taps) { return "{\"consts\": {\"taps\": " + std::to_string(taps) + "}}"; };
    const Files files{{"pipes/main.json", R"({"version": 1, "include": ["a.json", "b.json"], "passes": {}})"},
                      {"pipes/a.json", file(1)},
                      {"pipes/b.json", file(2)}};
    EXPECT_EQ(number_of(load(files)->consts.at("taps")), 2);
}

TEST(Include, AFileThatComesTwiceIsReadOnce) {
    const Files files{{"pipes/main.json", R"({"version": 1, "include": ["a.json", "b.json"], "passes": {}})"},
                      {"pipes/a.json", R"({"include": ["base.json"], "consts": {"taps": 5}})"},
                      {"pipes/b.json", R"({"include": ["base.json"]})"},
                      {"pipes/base.json", R"({"consts": {"taps": 1}})"}};
    EXPECT_EQ(number_of(load(files)->consts.at("taps")), 5)
        << "the base must not come back over what includes it";
    EXPECT_EQ(load(files)->sources.files.size(), 4u);
}

TEST(Include, IsFoundAmongTheShippedGraphs) {
    const Files files{{"pipes/main.json", R"({"version": 1, "include": ["modules/a.json"]})"},
                      {"shipped/modules/a.json", kModule}};
    EXPECT_TRUE(load(files).ok());
    Files nearer = files;
    nearer["pipes/modules/a.json"] = R"({"passes": {}})";
    EXPECT_TRUE(load(nearer)->resources.empty()) << "the one beside the graph comes first";
}

TEST(Include, NullTakesAway) {
    const Result<GraphDesc> graph = load({{"pipes/main.json", R"({"version": 1, "include": ["a.json"],
        "resources": {"spare": null}, "passes": {"p": {"clear": null}}})"},
                                          {"pipes/a.json", kModule}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->resources.size(), 1u);
    EXPECT_FALSE(graph->passes.at("p").clear);
}

TEST(Include, FaultsAreWhereTheyWereWritten) {
    const Marked marked =
        unmark_all({{"pipes/main.json", "{\"version\": 1,\n \"include\": [\"a.json\"], \"passes\": {}}"},
                    {"pipes/a.json", "{\n  \"resources\": {\"x\": {\"format\": \"r8\", $$\"mip\": 2}}}"}});
    const Result<GraphDesc> graph = load(marked.files);
    ASSERT_FALSE(graph.ok());
    const Diagnostic& fault = graph.errors().front();
    EXPECT_EQ(fault.code, "W101");
    EXPECT_EQ(place(fault), marked.places.front());
    ASSERT_EQ(fault.notes.size(), 1u) << to_text(fault);
    EXPECT_EQ(fault.notes[0].message, "included here");
    EXPECT_EQ(fault.notes[0].file, "pipes/main.json");
    EXPECT_EQ(fault.notes[0].line, 2u);
    EXPECT_EQ(fault.notes[0].column, 14u);
}

TEST(Include, ASyntaxFaultOfAnIncludedFileIsInThatFile) {
    expect_fault({{"pipes/main.json", R"({"version": 1, "include": ["a.json"], "passes": {}})"},
                  {"pipes/a.json", "{\n  \"consts\": {\"a\": $$}}"}},
                 "W001", "", "");
}

TEST(Include, AValueThatReplacesOneShowsBothPlaces) {
    const Result<GraphDesc> graph = load({{"pipes/main.json",
                                           "{\"version\": 1, \"include\": [\"a.json\"],\n"
                                           " \"passes\": {\"p\": {\"clear\": true}}}"},
                                          {"pipes/a.json", kModule}});
    ASSERT_FALSE(graph.ok());
    const Diagnostic& fault = graph.errors().front();
    EXPECT_EQ(place(fault), "pipes/main.json:2:28");
    ASSERT_EQ(fault.notes.size(), 1u) << to_text(fault);
    EXPECT_EQ(fault.notes[0].file, "pipes/a.json");
    EXPECT_EQ(fault.notes[0].line, 4u);
    EXPECT_NE(fault.notes[0].message.find("replaces the value here"), std::string::npos);
}

TEST(Include, AFileThatIsNotThere) {
    expect_fault({{"pipes/main.json", R"({"version": 1, "include": [$$"a.jsn"], "passes": {}})"}}, "W126",
                 "the file \"a.jsn\" does not exist or cannot be read",
                 "\"pipes/a.jsn\" and \"shipped/a.jsn\"");
}

TEST(Include, NothingOutsideIsRead) {
    for (const char* name : {"../secret.json", "/etc/passwd", "a/../../secret.json", ""})
        expect_fault({{"pipes/main.json", std::string(R"({"version": 1, "include": [$$")") + name + R"("]})"},
                      {"secret.json", kModule},
                      {"/etc/passwd", kModule}},
                     "W126", "not a path inside the folder of the graph", "without \"..\"");
}

TEST(Include, FilesThatIncludeEachOther) {
    expect_fault({{"pipes/main.json", R"({"version": 1, "include": ["a.json"], "passes": {}})"},
                  {"pipes/a.json", R"({"include": ["b.json"]})"},
                  {"pipes/b.json", R"({"include": [$$"a.json"]})"}},
                 "W127", "pipes/a.json -> pipes/b.json -> pipes/a.json", "remove one");
    expect_fault({{"pipes/main.json", R"({"version": 1, "include": [$$"main.json"], "passes": {}})"}}, "W127",
                 "pipes/main.json -> pipes/main.json", "");
}

TEST(Include, OfTheWrongType) {
    expect_fault({{"pipes/main.json", R"({"version": 1, "include": $$"a.json", "passes": {}})"}}, "W102",
                 "a list of files", "");
    expect_fault({{"pipes/main.json", R"({"version": 1, "include": [$$3], "passes": {}})"}}, "W102",
                 "the name of a file", "");
}

TEST(Include, NullWithNothingToTakeAway) {
    expect_fault(
        {{"pipes/main.json", R"({"version": 1, "include": ["a.json"], "resources": {"spair": $$null}})"},
         {"pipes/a.json", kModule}},
        "W128", "no key of this name", "correct the name");
    expect_fault({{"pipes/main.json",
                   R"({"version": 1, "include": ["a.json"], "resources": {"n": {"size": $$null}}})"},
                  {"pipes/a.json", kModule}},
                 "W128", "no key of this name", "");
}

TEST(Include, FilesAreCounted) {
    Files files{{"pipes/main.json", R"({"version": 1, "include": ["f1.json"], "passes": {}})"}};
    for (int i = 1; i <= 6; ++i)
        files["pipes/f" + std::to_string(i) + ".json"] =
            i < 6 ? "{\"include\": [\"f" + std::to_string(i + 1) + ".json\"]}" : "{}";
    GraphLimits limits;
    limits.include_files = 6;
    EXPECT_TRUE(read_files(files, limits).ok());
    limits.include_files = 5;
    EXPECT_EQ(codes_of(read_files(files, limits).errors()), "W004");
    limits = {};
    limits.json_bytes = 100;
    EXPECT_EQ(codes_of(read_files(files, limits).errors()), "W004") << "their bytes together";
}

}  // namespace
}  // namespace weft::test
