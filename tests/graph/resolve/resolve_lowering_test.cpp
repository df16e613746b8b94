// Tests how the views of a pass are drawn to layers: by one pass or by one pass for each view.
#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ResolveLowering : public ResolveTest {
 protected:
    ResolveLowering() {
        shaders["seen"] = reading_view(fragment({"color"}));
        shaders["blind"] = fragment({"color"});
        shaders["many"] = reading_view(fragment({"color"}, {image_out("more")}));
        shaders["numbered"] = reading_view(with_params(fragment({"color"}), {member("view")}));
        shaders["constant"] = reading_view(with_constants(fragment({"color"}), {{"view", ScalarType::i32}}));
        shaders["read.comp"] = compute({sampled("src"), image_out("dst")});
        for (ShaderBinding& binding : shaders["read.comp"].interface.bindings) binding.arrayed = true;
        shaders["read.comp"].interface.bindings[0].multisampled = true;
        shaders["reader"] = reading_view(fragment({"color"}, {sampled("faces")}));
        imports.views = {"camera", "sun"};
        imports.imports["sun"] = {.name = "sun", .kind = ImportKind::views, .views = 4};
        imports.imports["lamps"] = {.name = "lamps", .kind = ImportKind::views, .views = 5};
        imports.bindings = {{0, 1, BindingKind::uniform_buffer, ~0u, 512, false}};
        profile.max_multiview_views = 6;
        profile.max_output_layers = 256;
    }
    static ShaderProgram reading_view(ShaderProgram program) {
        ShaderBinding view;
        view.name = "ViewBlock";
        view.set = 0;
        view.binding = 1;
        view.kind = BindingKind::uniform_buffer;
        view.stages = program.interface.stages;
        program.interface.bindings.insert(program.interface.bindings.begin(), view);
        return program;
    }
    // A graph with a pass "a" that draws the six views of a probe, or those of another list, to the layers of
    // the image "faces".
    static std::string graph(const std::string& keys = "", const std::string& shader = "seen",
                             const std::string& list = "probe", const std::string& passes = "") {
        return R"j("imports": {"opaque": "drawlist", "lamps": "views"},
            "views": {"probe": {"cube": {"at": [0, 0, 0]}}, "pond": {"of": "probe", "plane": [0, 1, 0, 0]},
                      "lake": {"of": "lamps", "plane": [0, 1, 0, 0]}, "later": {"of": "sun", "first": 2},
                      "one": {"of": "sun", "count": 1}},
            "resources": {"faces": {"format": "rgba16f", "size": 16, "layers": 8},
                          "copy": {"format": "rgba16f", "size": 16, "layers": 8},
                          "smooth": {"format": "rgba16f", "size": 16, "layers": 6, "samples": 4}},
            "passes": {"a": {"type": "raster", "draws": ["opaque"], "shader": ")j" +
               shader + R"j(", "views": ")j" + list + "\"" + keys +
               (keys.find("\"out\"") == std::string::npos ? R"j(, "out": {"color": "faces"})j" : "") + "}" +
               passes + R"j(, "b": {"type": "readback", "in": ["faces.layer(1)"]}}, "tests": [])j";
    }
    static std::string replaced(std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    }
    // The same graph, but the pass "b" reads other layers.
    static std::string reading(const std::string& layers, const std::string& text) {
        return replaced(text, "\"faces.layer(1)\"]}}", "\"faces.layer(" + layers + ")\"]}}");
    }
    ViewLowering lowering(const std::string& text) {
        const ResolvedGraph g = good(text);
        for (const PassDecl& pass : g.passes)
            if (pass.name == "a") return pass.lowering;
        return ViewLowering::none;
    }
    // Expects one pass for each view, for a reason that contains `part`; and that the author cannot ask for
    // multiview, for the same reason.
    void expect_separate(const std::string& keys, const std::string& part, const std::string& shader = "seen",
                         const std::string& list = "probe", const std::string& others = "") {
        SCOPED_TRACE(keys + shader + list);
        const ResolvedGraph g = good(graph(keys, shader, list, others));
        EXPECT_EQ(find_pass(g, "a"), PassId(kNoId));
        const auto first =
            std::ranges::find_if(g.passes, [](const PassDecl& pass) { return pass.name.starts_with("a#"); });
        ASSERT_NE(first, g.passes.end());
        EXPECT_NE(first->lowering_reason.find(part), std::string::npos) << first->lowering_reason;
        EXPECT_TRUE(first->views.empty());
        const Diagnostic d = bad(graph(keys + R"j(, "lowering": "multiview")j", shader, list, others));
        EXPECT_EQ(d.code, "W199");
        EXPECT_NE(d.message.find(part), std::string::npos) << d.message;
        EXPECT_GE(d.help.size(), 2u);
    }
};

TEST_F(ResolveLowering, OnePassDrawsAllViewsToSuccessiveLayers) {
    const ResolvedGraph g = good(graph());
    const PassDecl& pass = pass_in(g, "a");
    EXPECT_EQ(pass.lowering, ViewLowering::layer_output);
    ASSERT_EQ(pass.views.size(), 6u);
    EXPECT_EQ(pass.view, "probe(0)");
    EXPECT_EQ(pass.views.back(), "probe(5)");
    EXPECT_TRUE(pass.culls_draws);
    EXPECT_EQ(use(g, "a", "color").range.layer, 0u);
    EXPECT_EQ(use(g, "a", "color").range.layers, 6u);
    const ResolvedGraph part = good(graph("", "seen", "later"));
    EXPECT_EQ(pass_in(part, "a").views, (std::vector<std::string>{"sun(2)", "sun(3)"}));
    const ResolvedGraph moved = good(graph(R"j(, "out": {"color": "faces.layer(1 + view)"})j"));
    EXPECT_EQ(use(moved, "a", "color").range.layer, 1u);
    EXPECT_EQ(use(moved, "a", "color").range.layers, 6u);
}

TEST_F(ResolveLowering, IsLayerOutputIfDrawsAreLeftOutElseMultiviewElsePasses) {
    EXPECT_EQ(lowering(graph()), ViewLowering::layer_output);
    EXPECT_EQ(lowering(graph(R"j(, "frustum": false)j")), ViewLowering::multiview);
    EXPECT_EQ(lowering(graph("", "blind")), ViewLowering::multiview);
    profile.max_output_layers = 5;
    EXPECT_EQ(lowering(graph()), ViewLowering::multiview);
    profile.max_multiview_views = 5;
    EXPECT_EQ(lowering(graph()), ViewLowering::none);
    const std::string reason = pass_in(good(graph()), "a#0").lowering_reason;
    EXPECT_NE(reason.find("maxOutputLayers"), std::string::npos) << reason;
    EXPECT_NE(reason.find("maxMultiviewViews"), std::string::npos) << reason;
    // Draws are left out only by layer output, so it is not chosen instead of multiview.
    profile.max_output_layers = 256;
    EXPECT_EQ(lowering(graph(R"j(, "frustum": false)j")), ViewLowering::none);
    EXPECT_EQ(lowering(reading("0", graph("", "seen", "one"))), ViewLowering::none);
}

TEST_F(ResolveLowering, IsTheAuthorsChoiceIfThatIsPossible) {
    EXPECT_EQ(lowering(graph(R"j(, "lowering": "multiview")j")), ViewLowering::multiview);
    EXPECT_EQ(lowering(graph(R"j(, "frustum": false, "lowering": "layerOutput")j")),
              ViewLowering::layer_output);
    EXPECT_EQ(lowering(graph(R"j(, "lowering": "passes")j")), ViewLowering::none);
    const ResolvedGraph one = good(reading("0", graph(R"j(, "lowering": "multiview")j", "seen", "one")));
    EXPECT_EQ(pass_in(one, "a").views.size(), 1u);
    EXPECT_EQ(bad(graph(R"j(, "lowering": "layerOutput")j", "blind")).code, "W199");
    EXPECT_EQ(bad(graph(R"j(, "into": "rects", "lowering": "multiview")j")).code, "W199");
    EXPECT_EQ(
        lowering(graph(R"j(, "into": "rects", "lowering": "passes", "out": {"color": "faces.layer(1)"})j")),
        ViewLowering::none);
    profile.max_output_layers = 1;
    profile.max_multiview_views = 1;
    EXPECT_EQ(bad(graph(R"j(, "lowering": "layerOutput")j")).code, "W199");
    EXPECT_EQ(bad(graph(R"j(, "lowering": "multiview")j")).code, "W199");
    const std::string text = graph(R"j(, "lowering": "multiview")j");
    EXPECT_EQ(bad(replaced(text, "\"views\": \"probe\"", "\"view\": \"sun(0)\"")).code, "W109");
}

TEST_F(ResolveLowering, IsPassesIfSomethingDependsOnTheNumberOfTheView) {
    expect_separate("", "Params.view", "numbered");
    expect_separate("", "constant \"view\"", "constant");
    expect_separate(R"j(, "if": "5 - view")j", "\"if\"");
    expect_separate(R"j(, "state": {"viewport": ["view", 0, 4, 4]})j", "\"state\"");
    expect_separate(R"j(, "clear": ["view", 0, 0, 0])j", "\"clear\"");
    expect_separate(R"j(, "in": ["faces.layer(7-view)"], "out": {"color": "copy"})j", "faces.layer(7-view)",
                    "reader", "later", R"j(, "c": {"type": "clear", "out": ["faces"]},
                              "d": {"type": "readback", "in": ["copy.layer(0..1)"]})j");
    // The pass itself gives the value, so it is not the number of the view.
    EXPECT_EQ(lowering(graph(R"j(, "params": {"view": 3})j", "numbered")), ViewLowering::layer_output);
    EXPECT_EQ(lowering(graph(R"j(, "constants": {"view": 3})j", "constant")), ViewLowering::layer_output);
}

TEST_F(ResolveLowering, IsPassesIfARuleOfThePassForbidsOnePass) {
    expect_separate(R"j(, "repeat": {"i": "0..0"})j", "\"repeat\"");
    expect_separate(R"j(, "out": {"color": "faces", "more": "copy.layer(7)"})j", "attachment", "many",
                    "probe", R"j(, "d": {"type": "readback", "in": ["copy.layer(7)"]})j");
    expect_separate(R"j(, "out": {"color": "faces.layer(5 - view)"})j", "successive");
    expect_separate(
        R"j(, "out": {"color": "smooth"})j", "multisampled", "seen", "probe",
        R"j(, "c": {"type": "compute", "shader": "read.comp", "in": {"src": "smooth"}, "out": {"dst": "faces"}})j");
}

// Triangles of mirror images have the opposite winding, and one draw has one winding.
TEST_F(ResolveLowering, IsMultiviewOnlyForViewsOfTheSameWinding) {
    profile.max_output_layers = 1;
    EXPECT_EQ(lowering(graph("", "seen", "pond")), ViewLowering::multiview);
    EXPECT_EQ(lowering(graph("", "seen", "sun")), ViewLowering::multiview);
    expect_separate("", "mirror images", "seen", "lamps");
    expect_separate("", "mirror images", "seen", "lake");
    profile.max_output_layers = 256;
    EXPECT_EQ(lowering(graph("", "seen", "lake")), ViewLowering::layer_output);
    // A fullscreen pass has one triangle, which is the same in all views.
    const std::string raster = graph("", "seen", "lamps");
    EXPECT_EQ(lowering(replaced(raster, R"j("raster", "draws": ["opaque"])j", "\"fullscreen\"")),
              ViewLowering::multiview);
}

// One load operation applies to all layers. Here layer 3 is loaded, and the others are cleared.
TEST_F(ResolveLowering, IsPassesIfSomeLayersAreLoadedAndOthersCleared) {
    const std::string one_layer = R"j(, "z": {"type": "clear", "out": ["faces.layer(3)"]})j";
    const std::string after = R"j(, "after": ["z"])j";
    expect_separate(after, "loaded and others cleared", "seen", "probe", one_layer);
    warnings.clear();
    good(graph(after + R"j(, "lowering": "passes")j", "seen", "probe", one_layer));
    const size_t wanted = warnings.size();
    warnings.clear();
    good(graph(after, "seen", "probe", one_layer));
    EXPECT_EQ(warnings.size(), wanted) << "the stages that run again report their warnings once";
    const ResolvedGraph all =
        good(graph(after, "seen", "probe", R"j(, "z": {"type": "clear", "out": ["faces"]})j"));
    EXPECT_EQ(use(all, "a", "color").access, Access::color_read_write);
    EXPECT_EQ(pass_in(all, "a").lowering, ViewLowering::layer_output);
}

TEST_F(ResolveLowering, FaultsOfThePassHaveOneMessage) {
    for (const char* key : {"", R"j(, "lowering": "multiview")j", R"j(, "lowering": "layerOutput")j"}) {
        SCOPED_TRACE(key);
        EXPECT_EQ(bad(replaced(graph(key), "\"layers\": 8", "\"layers\": 5")).code, "W192");
        EXPECT_EQ(bad(graph(std::string(key) + R"j(, "out": {"color": "face"})j")).code, "W103");
        EXPECT_EQ(bad(graph(std::string(key) + R"j(, "out": {"color": "faces.layer(4 + view)"})j")).code,
                  "W105");
        EXPECT_EQ(bad(graph(key, "seen", "nothing")).code, "W118");
    }
}

TEST_F(ResolveLowering, OnePassHasFewerPassesAndBarriers) {
    const auto compiled = [&](const char* lowering) {
        const std::string key = std::string(", \"lowering\": \"") + lowering + "\"";
        const ResolvedGraph g = good(reading("0..5", graph(key)));
        const FramePlan plan = compile(g, content_needs(g), {});
        EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
        return plan;
    };
    const FramePlan separate = compiled("passes"), multiview = compiled("multiview"),
                    layers = compiled("layerOutput");
    EXPECT_EQ(separate.schedule.order.size(), 7u);
    EXPECT_EQ(multiview.schedule.order.size(), 2u);
    EXPECT_EQ(layers.schedule.order.size(), 2u);
    EXPECT_LT(multiview.barriers.emitted, separate.barriers.emitted);
    EXPECT_EQ(multiview.barriers.emitted, layers.barriers.emitted);
    EXPECT_NE(plan_hash(multiview), plan_hash(layers));
}

}  // namespace
}  // namespace weft::test
