// Tests the errors of instances of modules. Each cause gives one message, at the place of the cause.
#include "tests/graph/modules/module_files.h"

namespace weft::test {
namespace {

const char* const kBlur = R"({
  "ports": {"source": "the image to blur", "taps": "number of taps"},
  "params": {"taps": 4, "bias": 1}, "resources": {"half": "r8"},
  "passes": {"blur": {"type": "compute", "shader": "b.comp", "in": ["source"], "out": ["half"]}}
})";

ModuleFiles including(const std::string& items, const std::string& rest = R"("passes": {})") {
    return {{"main.json", "{\"version\": 1, \"resources\": {\"hdr\": \"r8\"},\n \"include\": [" + items +
                              "],\n " + rest + "}"},
            {"blur.json", kBlur},
            {"other.json", "{}"}};
}

TEST(ModuleFaults, OnlyPortsMayBeReplaced) {
    expect_module_fault(
        including(R"({"file": "blur.json", "as": "a", "with": {"source": "hdr", $$"bais": "hdr"}})"), "W238",
        "\"blur.json\" has no port \"bais\"", "the ports are \"source\" and \"taps\"");
    expect_module_fault(
        including(R"({"file": "blur.json", "as": "a", "with": {"source": "hdr", $$"bias": "hdr"}})"), "W238",
        "no port \"bias\"", "the ports are");
    expect_module_fault(including(R"({"file": "blur.json", "as": "a", "with": {$$"sorce": "hdr"}})"), "W238",
                        "no port \"sorce\"", "did you mean \"source\"");
    expect_module_fault(including(R"({"file": "other.json", "as": "a", "with": {$$"source": "hdr"}})"),
                        "W238", "\"other.json\" has no port", "the file has no ports");
}

TEST(ModuleFaults, TheNameOfAModuleIsAName) {
    for (const char* name : {"", "1a", "a-b", "a::b", "ä"})
        expect_module_fault(including(std::string(R"({"file": "other.json", "as": $$")") + name + "\"}"),
                            "W239", "is not a valid name for a module", "begin with a letter");
}

TEST(ModuleFaults, OneNameStandsForOneModule) {
    expect_module_fault(including(R"({"file": "blur.json", "as": "a", "with": {"source": "hdr"}},
                                     {"file": "other.json", "as": $$"a"})"),
                        "W239", "\"a\" already stands for another module", "choose another name");
    expect_module_fault(including(R"({"file": "blur.json", "as": "a", "with": {"source": "hdr"}},
                                     {"file": "blur.json", "as": $$"a", "with": {"source": "hdr", "taps": "hdr"}})"),
                        "W239", "included twice with different \"with\"", "write the same");
    expect_module_fault(
        including(R"({"file": "other.json", "as": $$"a"})",
                  R"("groups": {"a": {"passes": {"p": {"type": "clear", "out": ["hdr"]}}}}, "passes": {})"),
        "W239", "already the name of a group", "choose another name");
}

TEST(ModuleFaults, EachPortNeedsATarget) {
    expect_module_fault(including(R"({"file": "blur.json", "as": $$"a"})"), "W240",
                        "the port \"source\" of module \"a\" has no target",
                        "\"with\": { \"source\": \"…\" }; the port means: the image to blur");
    expect_module_fault(including(R"({"file": "blur.json", "as": "a", "with": {"source": $$"hrd"}})"), "W240",
                        "has no \"hrd\" for this port", "did you mean \"hdr\"");
}

TEST(ModuleFaults, APortMayBeDeclaredFromOutside) {
    ModuleFiles files = including(R"({"file": "blur.json", "as": "a"})");
    files["main.json"] = R"({"version": 1, "include": [{"file": "blur.json", "as": "a"}],
                             "resources": {"a::source": "r8"}, "passes": {}})";
    const Result<GraphDesc> graph = load_modules(files);
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->passes.at("a::blur").in.at(0).ref.name, "a::source");
}

TEST(ModuleFaults, ModulesThatIncludeEachOther) {
    ModuleFiles files = including(R"({"file": "other.json", "as": "a"})");
    files["other.json"] = R"({"include": [{"file": $$"main.json", "as": "b"}]})";
    expect_module_fault(files, "W127", "main.json -> other.json -> main.json", "remove one");
    files["other.json"] = R"({"include": [{"file": $$"other.json", "as": "b"}]})";
    expect_module_fault(files, "W127", "other.json -> other.json", "remove one");
}

TEST(ModuleFaults, ItemsOfTheWrongForm) {
    expect_module_fault(including(R"($${"file": "other.json"})"), "W108", "needs the key \"as\"",
                        "\"as\": \"name\"");
    expect_module_fault(including(R"($${"as": "a"})"), "W108", "needs the key \"file\"", "");
    expect_module_fault(including(R"({"file": "other.json", "as": "a", $$"wiht": {}})"), "W101",
                        "unknown key \"wiht\"", "did you mean \"with\"");
    expect_module_fault(including(R"({"file": $$3, "as": "a"})"), "W102", "the name of a file",
                        "double quotes");
    expect_module_fault(including(R"({"file": "other.json", "as": $$3})"), "W102", "a name for the module",
                        "");
    expect_module_fault(including(R"({"file": "other.json", "as": "a", "with": $$["hdr"]})"), "W102",
                        "an object", "");
    expect_module_fault(including(R"({"file": "blur.json", "as": "a", "with": {"source": $$1}})"), "W102",
                        "the name of a part", "");
    for (const char* file : {"../other.json", "/etc/passwd", ""})
        expect_module_fault(including(std::string(R"({"file": $$")") + file + R"(", "as": "a"})"), "W126",
                            "not a path inside the folder", "without \"..\"");
}

TEST(ModuleFaults, PortsOfTheWrongForm) {
    expect_module_fault({{"main.json", R"({"version": 1, "ports": $$3, "passes": {}})"}}, "W102",
                        "a list of names", "");
    expect_module_fault({{"main.json", R"({"version": 1, "ports": [$$3], "passes": {}})"}}, "W102", "a name",
                        "");
    expect_module_fault({{"main.json", R"({"version": 1, "ports": {"a": $$3}, "passes": {}})"}}, "W102",
                        "a description", "");
    expect_module_fault({{"main.json", R"({"version": 1, "ports": [$$"a b"], "passes": {}})"}}, "W109",
                        "not a valid name for a port", "");
}

TEST(ModuleFaults, OtherNamesWithColonsAreNoNames) {
    const std::string module = R"({"file": "blur.json", "as": "a", "with": {"source": "hdr"}})";
    expect_module_fault(including(module, R"("passes": {$$"b::blur": {"type": "clear", "out": ["hdr"]}})"),
                        "W109", "\"b::blur\" is not a valid name", "");
    expect_module_fault(including(module, R"("passes": {$$"a::1": {"type": "clear", "out": ["hdr"]}})"),
                        "W109", "\"1\" is not a valid name", "");
    expect_module_fault(including(module, R"("passes": {$$"a::blurr": {"after": []}})"), "W108",
                        "needs the key \"type\"", "did you mean \"a::blur\"");
}

TEST(ModuleFaults, AnErrorInAModuleIsReportedOnce) {
    ModuleFiles files = including(R"({"file": "other.json", "as": "a"}, {"file": "other.json", "as": "b"})");
    files["other.json"] = R"({"resources": {"x": {"format": "r8", $$"mip": 2}}})";
    expect_module_fault(files, "W101", "unknown key \"mip\"", "");
    files["other.json"] = R"({"consts": {"x": $$}})";
    expect_module_fault(files, "W001", "", "");
}

TEST(ModuleFaults, AnErrorNamesThePlaceOfTheInclude) {
    ModuleFiles files = including(R"({"file": "other.json", "as": "a"})");
    files["other.json"] = R"({"resources": {"x": {"format": "r8", "mip": 2}}})";
    const Result<GraphDesc> graph = load_modules(files);
    ASSERT_FALSE(graph.ok());
    const Diagnostic& fault = graph.errors().front();
    EXPECT_EQ(fault.file, "other.json");
    ASSERT_EQ(fault.notes.size(), 1u);
    EXPECT_EQ(fault.notes[0].file + ":" + std::to_string(fault.notes[0].line), "main.json:2");
    EXPECT_EQ(fault.notes[0].message, "included here");
}

TEST(ModuleFaults, APlaceHasOnePointer) {
    ModuleFiles files = including(R"({"file": "other.json", "as": "a"}, {"file": "other.json", "as": "b"})");
    files["other.json"] = R"({"consts": {"x": 1}})";
    const Result<JsonDoc> document = read_modules(files);
    ASSERT_TRUE(document.ok()) << to_text(document.errors());
    EXPECT_EQ(pointer_at(*document, "other.json", 1, 13), "/consts/x");
}

TEST(ModuleFaults, AnIndexHasNoNameOfAValue) {
    ModuleFiles files =
        including(R"({"file": "other.json", "as": "a"})", R"("consts": {"i": 3}, "passes": {})");
    const std::string begin =
        R"({"consts": {"j": 2}, "resources": {"r": "r8"}, "passes": {"p": {"type": "clear",
        "out": ["r"], "repeat": {$$")";
    files["other.json"] = begin + R"(j": "0..1"}}}})";
    expect_module_fault(files, "W109", "the index \"j\" is already a constant", "");
    files["other.json"] = unmark(begin + R"(i": "0..1"}}}})").text;
    EXPECT_TRUE(load_modules(files).ok()) << "i is a constant of the graph, not of the module";
}

}  // namespace
}  // namespace weft::test
