// Tests instances of modules: the names of their parts, and what names inside of their files mean.
#include "graph/parse/module_scope.h"
#include "tests/graph/modules/module_files.h"

namespace weft::test {
namespace {

const char* const kTiles = R"json({
  "ports": ["depth", "most"],
  "imports": {"opaque": "drawlist"},
  "sizes": {"tiles": "ceil(output / side)"},
  "consts": {"side": 16},
  "params": {"bias": 1, "most": 8},
  "resources": {"lists": {"buffer": "u32", "count": "tiles.x * most"}, "facts": "r32f"},
  "passes": {
    "cull": {"type": "compute", "shader": "cull.comp", "in": ["depth"], "out": ["lists"],
             "params": {"bias": "bias * 2"}, "threads": "tiles", "after": ["draw"]},
    "draw": {"type": "raster", "shader": "draw", "draws": ["opaque"], "out": ["facts"],
             "in": ["lists@cull.range(0..side - 1)"]}
  },
  "debug": {"Facts": "facts"}
})json";

ModuleFiles with_tiles(const std::string& rest, const std::string& with = R"({"depth": "z"})") {
    return {{"main.json", R"({"version": 1, "include": [{"file": "tiles.json", "as": "glass", "with": )" +
                              with + R"(}], "resources": {"z": "d32f"}, )" + rest + "}"},
            {"tiles.json", kTiles}};
}

TEST(Module, PartsHaveTheNameOfTheInstance) {
    const Result<GraphDesc> graph = load_modules(with_tiles(R"("passes": {})"));
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(keys_text(graph->passes), "glass::cull glass::draw");
    EXPECT_EQ(keys_text(graph->resources), "glass::facts glass::lists z");
    EXPECT_EQ(keys_text(graph->params), "glass::bias glass::most");
    EXPECT_EQ(keys_text(graph->consts), "glass::side");
    EXPECT_EQ(keys_text(graph->sizes), "glass::tiles");
    EXPECT_EQ(keys_text(graph->debug), "glass::Facts");
    EXPECT_EQ(keys_text(graph->imports), "opaque") << "imports are shared";
    EXPECT_EQ(graph->sources.describe(graph->passes.at("glass::cull").loc), "tiles.json:9:5");
}

TEST(Module, NamesInsideMeanItsOwnParts) {
    const Result<GraphDesc> graph = load_modules(with_tiles(R"("passes": {}, "consts": {"other": 3})"));
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    const PassDesc& cull = graph->passes.at("glass::cull");
    EXPECT_EQ(cull.module, "glass");
    EXPECT_EQ(cull.name, "glass::cull");
    EXPECT_EQ(cull.in.at(0).port, "depth") << "ports of passes keep their names: the shader has them";
    EXPECT_EQ(cull.in.at(0).ref.name, "z");
    EXPECT_EQ(cull.out.at(0).ref.name, "glass::lists");
    EXPECT_EQ(cull.params.at(0).name, "bias");
    EXPECT_EQ(names_in(cull.params.at(0).components.at(0)), "glass::bias");
    EXPECT_EQ(names_in(cull.threads.at(0)), "glass::tiles");
    EXPECT_EQ(cull.after, std::vector<std::string>{"glass::draw"});
    EXPECT_EQ(names_in(graph->sizes.at("glass::tiles")), "output glass::side");
    EXPECT_EQ(names_in(graph->resources.at("glass::lists").count), "glass::tiles glass::most");
    const RefDesc& lists = graph->passes.at("glass::draw").in.at(0).ref;
    EXPECT_EQ(lists.pass, "glass::cull");
    EXPECT_EQ(names_in(*lists.element_last), "glass::side");
    EXPECT_EQ(graph->debug.at("glass::Facts").show.name, "glass::facts");
    EXPECT_EQ(graph->passes.at("glass::draw").draws, std::vector<std::string>{"opaque"});
}

TEST(Module, WithReplacesPorts) {
    const Result<GraphDesc> graph = load_modules(with_tiles(R"("passes": {}, "params": {"mostLights": 4})",
                                                            R"({"depth": "z", "most": "mostLights"})"));
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(keys_text(graph->params), "glass::bias mostLights");
    EXPECT_EQ(names_in(graph->resources.at("glass::lists").count), "glass::tiles mostLights");
    EXPECT_EQ(name_in_module(*graph, "glass", "most"), "mostLights") << "members of Params";
    EXPECT_EQ(name_in_module(*graph, "glass", "bias"), "glass::bias");
    EXPECT_EQ(name_in_module(*graph, "glass", "mostLights"), "glass::mostLights")
        << "a shader of the module does not see other names of the graph";
    EXPECT_EQ(name_in_module(*graph, "glass", "opaqueDraws"), "opaqueDraws");
    EXPECT_EQ(name_in_module(*graph, "", "bias"), "bias");
}

TEST(Module, IsPatchedFromOutside) {
    const Result<GraphDesc> graph = load_modules({{"main.json", R"({"version": 1,
        "include": [{"file": "tiles.json", "as": "glass", "with": {"depth": "z"}}],
        "consts": {"side": 3, "k": "glass::side + side"},
        "params": {"glass::bias": {"default": 5, "range": [0, 9]}},
        "resources": {"z": "d32f", "glass::facts": "r16f", "copied": "r32f"},
        "passes": {"glass::cull": {"params": {"bias": "k * glass::bias", "more": "side"}, "after": null},
                   "glass::draw": null,
                   "copy": {"type": "copy", "in": ["glass::facts"], "out": ["copied"], "after": ["glass::cull"]}}})"},
                                                  {"tiles.json", kTiles}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->params.at("glass::bias").default_value, 5);
    EXPECT_EQ(graph->resources.at("glass::facts").formats, std::vector<std::string>{"r16f"});
    EXPECT_EQ(keys_text(graph->passes), "copy glass::cull");
    const PassDesc& cull = graph->passes.at("glass::cull");
    EXPECT_EQ(names_in(cull.params.at(0).components.at(0)), "k glass::bias");
    EXPECT_EQ(names_in(cull.params.at(1).components.at(0)), "side")
        << "the file that writes a name says what the name means";
    EXPECT_EQ(names_in(graph->consts.at("k")), "glass::side side");
    const PassDesc& copy = graph->passes.at("copy");
    EXPECT_EQ(copy.in.at(0).port, "facts");
    EXPECT_EQ(copy.in.at(0).ref.name, "glass::facts");
    EXPECT_EQ(copy.after, std::vector<std::string>{"glass::cull"});
}

TEST(Module, IsHadTwiceAndAlsoWithoutAName) {
    const Result<GraphDesc> graph = load_modules(
        {{"main.json", R"({"version": 1, "resources": {"depth": "d32f", "z": "d32f"}, "passes": {},
             "include": ["tiles.json", {"file": "tiles.json", "as": "a", "with": {"depth": "z"}},
                         {"file": "tiles.json", "as": "b", "with": {"depth": "a::facts"}}]})"},
         {"tiles.json", kTiles}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(keys_text(graph->passes), "a::cull a::draw b::cull b::draw cull draw");
    EXPECT_EQ(graph->passes.at("cull").in.at(0).ref.name, "depth");
    EXPECT_EQ(graph->passes.at("b::cull").in.at(0).ref.name, "a::facts");
    EXPECT_EQ(graph->passes.at("cull").module, "");
    EXPECT_EQ(graph->sources.files.size(), 4u);
}

TEST(Module, TheSameInstanceIsReadOnce) {
    const std::string one = R"({"file": "tiles.json", "as": "glass", "with": {"depth": "z"}})";
    const Result<GraphDesc> graph = load_modules(
        {{"main.json",
          R"({"version": 1, "include": ["a.json", "b.json"], "resources": {"z": "d32f"}, "passes": {}})"},
         {"a.json", "{\"include\": [" + one + "], \"params\": {\"glass::bias\": 7}}"},
         {"b.json", "{\"include\": [" + one + "]}"},
         {"tiles.json", kTiles}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->params.at("glass::bias").default_value, 7)
        << "the module must not come back over a.json";
    EXPECT_EQ(graph->sources.files.size(), 4u);
}

TEST(Module, IncludesModulesAndFilesOfItsOwn) {
    const Result<GraphDesc> graph = load_modules(
        {{"main.json", R"({"version": 1, "resources": {"z": "d32f"},
             "include": [{"file": "outer.json", "as": "o", "with": {"source": "z"}}],
             "passes": {"o::i::p": {"params": {"x": "o::i::k"}}, "q": {"type": "clear", "out": ["o::i::r"]}}})"},
         {"outer.json", R"({"ports": ["source"], "include": ["base.json",
             {"file": "inner.json", "as": "i", "with": {"depth": "source", "k2": "k"}}],
             "consts": {"k": 2}, "passes": {"i::p": {"after": ["base"]}}})"},
         {"inner.json",
          R"({"ports": {"depth": "some depth", "k2": ""}, "consts": {"k": 1}, "resources": {"r": "r8"},
             "passes": {"p": {"type": "compute", "shader": "a.comp", "in": ["depth"], "out": ["r"],
                              "params": {"x": "k", "y": "k2"}}}})"},
         {"base.json", R"({"passes": {"base": {"type": "clear", "out": ["i::r"]}}})"}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(keys_text(graph->passes), "o::base o::i::p q");
    EXPECT_EQ(keys_text(graph->modules), "o o::i");
    EXPECT_EQ(graph->modules.at("o::i").parent, "o");
    const PassDesc& pass = graph->passes.at("o::i::p");
    EXPECT_EQ(pass.module, "o::i");
    EXPECT_EQ(pass.in.at(0).ref.name, "z") << "through two instances";
    EXPECT_EQ(pass.after, std::vector<std::string>{"o::base"});
    EXPECT_EQ(names_in(pass.params.at(0).components.at(0)), "o::i::k");
    EXPECT_EQ(names_in(pass.params.at(1).components.at(0)), "o::k");
    EXPECT_EQ(graph->passes.at("o::base").out.at(0).ref.name, "o::i::r");
    EXPECT_EQ(graph->passes.at("q").out.at(0).port, "r");
}

const char* const kBake = R"json({
  "imports": {"order": "turns"}, "consts": {"n": 7},
  "resources": {"layers": {"format": "r32f", "layers": 8, "keep": true}},
  "passes": {"seed": {"type": "clear", "out": ["layers"], "after": ["bake::light"]}},
  "groups": {
    "bake": {
      "repeat": {"m": "0..n"}, "turns": "order",
      "resources": {"raw": "r32f"},
      "passes": {"light": {"type": "compute", "shader": "l.comp", "out": ["raw"], "params": {"a": "m + n"}},
                 "smooth": {"type": "compute", "shader": "s.comp", "in": ["raw@light"],
                            "out": {"dst": "layers.layer(m)"}, "threads": "mips(raw)"}}
    }
  }
})json";

TEST(Module, HasGroups) {
    const Result<GraphDesc> graph = load_modules(
        {{"main.json", R"({"version": 1, "include": [{"file": "bake.json", "as": "near"}], "passes": {},
             "groups": {"near::bake": {"perFrame": 2, "passes": {"light": {"after": ["near::seed"]}}}},
             "debug": {"Raw": "near::bake::raw"}})"},
         {"bake.json", kBake}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(keys_text(graph->groups), "near::bake");
    EXPECT_EQ(keys_text(graph->passes), "near::bake::light near::bake::smooth near::seed");
    EXPECT_EQ(keys_text(graph->resources), "near::bake::raw near::layers");
    const PassDesc& light = graph->passes.at("near::bake::light");
    EXPECT_EQ(light.group, "near::bake");
    EXPECT_EQ(light.module, "near");
    EXPECT_EQ(light.after, std::vector<std::string>{"near::seed"});
    EXPECT_EQ(names_in(light.params.at(0).components.at(0)), "m near::n") << "m is an index";
    const PassDesc& smooth = graph->passes.at("near::bake::smooth");
    EXPECT_EQ(smooth.in.at(0).ref.name, "near::bake::raw");
    EXPECT_EQ(smooth.in.at(0).ref.pass, "near::bake::light");
    EXPECT_EQ(smooth.out.at(0).ref.name, "near::layers");
    EXPECT_EQ(names_in(smooth.threads.at(0)), "near::bake::raw");
    EXPECT_EQ(graph->passes.at("near::seed").after, std::vector<std::string>{"near::bake::light"});
    EXPECT_EQ(graph->debug.at("Raw").show.name, "near::bake::raw");
    EXPECT_EQ(graph->groups.at("near::bake").turns, "order");
}

const char* const kFaces = R"json({
  "ports": ["seen"], "views": {"faces": {"cube": {"at": [0, 0, 0]}}, "half": {"of": "seen"}},
  "resources": {"map": {"format": "d32f", "layers": "facesViews"}},
  "passes": {"a": {"type": "raster", "shader": "d", "draws": ["opaque"], "depth": "map", "views": "faces"},
             "b": {"type": "raster", "shader": "d", "draws": ["opaque"], "depth": "map", "view": "half(1)"},
             "c": {"type": "raster", "shader": "d", "draws": ["opaque"], "depth": "map", "view": "camera"}}
})json";

TEST(Module, HasListsOfViews) {
    const Result<GraphDesc> graph = load_modules(
        {{"main.json",
          R"({"version": 1, "include": [{"file": "faces.json", "as": "a", "with": {"seen": "lamps"}}],
             "views": {"lamps": {"of": "camera"}}, "passes": {}})"},
         {"faces.json", kFaces}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(keys_text(graph->views), "a::faces a::half lamps");
    EXPECT_EQ(graph->views.at("a::half").of, "lamps");
    EXPECT_EQ(names_in(graph->resources.at("a::map").layers), "a::facesViews");
    EXPECT_EQ(graph->passes.at("a::a").view, "a::faces");
    EXPECT_EQ(graph->passes.at("a::b").view, "a::half");
    EXPECT_EQ(graph->passes.at("a::c").view, "camera");
}

TEST(Module, SeesNoOtherNamesOfTheGraph) {
    const Result<GraphDesc> graph = load_modules(
        {{"main.json",
          R"({"version": 1, "include": [{"file": "m.json", "as": "a"}], "consts": {"k": 1, "i": 2},
             "sizes": {"render": "output / 2"}, "resources": {"hdr": "r8"}, "passes": {}})"},
         {"m.json", R"({"resources": {"own": "r8"}, "passes": {"p": {"type": "compute", "shader": "p.comp",
             "repeat": {"i": "0..3"}, "in": ["hdr"], "out": ["own"], "params": {"a": "k + i"}, "threads": "render"}}})"}});
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    const PassDesc& pass = graph->passes.at("a::p");
    EXPECT_EQ(pass.in.at(0).ref.name, "a::hdr") << "later an error: the module has no such resource";
    EXPECT_EQ(names_in(pass.params.at(0).components.at(0)), "a::k i");
    EXPECT_EQ(names_in(pass.threads.at(0)), "render") << "the size of images is that of the graph";
    EXPECT_EQ(render_size_name(*graph, "a::own"), "render");
}

TEST(Module, TiersAreTiersOfTheGraph) {
    const ModuleFiles files{
        {"main.json",
         R"({"version": 1, "include": [{"file": "m.json", "as": "a", "with": {"shared": "mine"}}],
             "params": {"mine": 1}, "passes": {},
             "tiers": {"low": {"set": {"mine": 2}}, "high": {"patch": {"passes": {"a::p": {"covers": true}}}}}})"},
        {"m.json",
         R"({"ports": ["shared"], "params": {"taps": 8, "shared": 5}, "frames": 9, "tests": [3], "jitter": 4,
             "resources": {"r": "r8"},
             "passes": {"p": {"type": "fullscreen", "shader": "a.frag", "out": ["r"]}},
             "tiers": {"low": {"set": {"taps": 2, "shared": 3}, "patch": {"resources": {"r": "r16f"}}},
                       "least": {"patch": {"passes": {"p": null}}}}})"}};
    const Result<GraphDesc> plain = load_modules(files);
    ASSERT_TRUE(plain.ok()) << to_text(plain.errors());
    EXPECT_TRUE(plain->frames.empty()) << "the number of frames belongs to the file itself";
    EXPECT_TRUE(plain->tests.empty());
    EXPECT_EQ(plain->jitter, 4u);
    EXPECT_EQ(plain->tiers.size(), 3u);
    const Result<GraphDesc> low = load_modules(files, "low");
    ASSERT_TRUE(low.ok()) << to_text(low.errors());
    EXPECT_EQ(low->params.at("a::taps").default_value, 2);
    EXPECT_EQ(low->params.at("mine").default_value, 2) << "the module does not set what is not its own";
    EXPECT_EQ(low->resources.at("a::r").formats, std::vector<std::string>{"r16f"});
    EXPECT_TRUE(load_modules(files, "high")->passes.at("a::p").covers);
    EXPECT_TRUE(load_modules(files, "least")->passes.empty());
}

TEST(Module, IsFoundInTheGraphPath) {
    const std::string main = R"({"version": 1, "include": ["fogbank/fog.json"], "passes": {}})";
    const auto file = [](int k) { return "{\"consts\": {\"k\": " + std::to_string(k) + "}}"; };
    ModuleFiles files{{"main.json", main}, {"shipped/fogbank/fog.json", file(1)}};
    const auto found = [&] {
        return number_of(load_modules(files, "", {"first", "second"})->consts.at("k"));
    };
    EXPECT_EQ(found(), 1);
    files["second/fogbank/fog.json"] = file(2);
    EXPECT_EQ(found(), 2);
    files["first/fogbank/fog.json"] = file(3);
    EXPECT_EQ(found(), 3);
    files["fogbank/fog.json"] = file(4);
    EXPECT_EQ(found(), 4);
}

}  // namespace
}  // namespace weft::test
