// Tests which version of a resource each port reads, and the edges between passes that follow from the
// versions.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveVersions : public ResolveTest {
 protected:
    ResolveVersions() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["filter.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["change.comp"] = compute({image_in_out("x")});
        shaders["up.comp"] = compute({sampled("src"), image_in("base"), image_out("dst")});
        shaders["show.frag"] = fragment({"backbuffer"}, {sampled("src")});
    }
};

const std::string kImports = R"j("imports": {"backbuffer": "output"},)j";

TEST_F(ResolveVersions, ReadSeesTheOnlyWriter) {
    const ResolvedGraph g = good(kImports + R"j(
      "resources": {"x": "rgba16f"},
      "passes": {
        "show": {"type": "fullscreen", "shader": "show.frag", "in": {"src": "x"}, "out": ["backbuffer"]},
        "make": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}}})j");
    EXPECT_EQ(seen(g, "show", "src"), "make");
    EXPECT_TRUE(has_edge(g, "make", "show", EdgeKind::raw));
    EXPECT_EQ(use(g, "make", "dst").access, Access::storage_write);
    EXPECT_EQ(use(g, "show", "src").state.layout, Layout::shader_read_only);
    EXPECT_EQ(use(g, "show", "src").state.stages, stage::kFragmentShader);
    EXPECT_TRUE(use(g, "make", "dst").sources.empty());
    EXPECT_EQ(g.resources[g.output].name, "backbuffer");
    EXPECT_EQ(g.resources[g.output].extent, (Extent3D{640, 360, 1}));
}

TEST_F(ResolveVersions, InPlaceWriteSeesTheOneBaseAndLaterReadsSeeIt) {
    const ResolvedGraph g = good(kImports + R"j(
      "resources": {"x": "rgba16f", "y": "rgba16f"},
      "passes": {
        "a_change": {"type": "compute", "shader": "change.comp", "out": ["x"]},
        "b_make": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "early": {"type": "compute", "shader": "filter.comp", "in": {"src": "x@b_make"}, "out": {"dst": "y"}},
        "show": {"type": "fullscreen", "shader": "show.frag", "in": {"src": "x"}, "out": ["backbuffer"]}})j");
    EXPECT_EQ(use(g, "a_change", "x").access, Access::storage_read_write);
    EXPECT_EQ(seen(g, "a_change", "x"), "b_make");
    EXPECT_EQ(seen(g, "show", "src"), "a_change");
    EXPECT_EQ(seen(g, "early", "src"), "b_make");
    EXPECT_TRUE(has_edge(g, "early", "a_change", EdgeKind::war));
    EXPECT_TRUE(has_edge(g, "b_make", "a_change", EdgeKind::waw));
    EXPECT_FALSE(has_edge(g, "b_make", "show", EdgeKind::raw));
}

TEST_F(ResolveVersions, FirstReadWriteBindingStartsAVersion) {
    const ResolvedGraph g = good(R"j("resources": {"x": "rgba16f"},
      "passes": {"only": {"type": "compute", "shader": "change.comp", "out": ["x"]}})j");
    EXPECT_EQ(use(g, "only", "x").access, Access::storage_write);
    EXPECT_TRUE(use(g, "only", "x").sources.empty());
}

TEST_F(ResolveVersions, MipChainDownAndUpHasNoCycle) {
    const ResolvedGraph g = good(R"j("resources": {"b": {"format": "rgba16f", "mips": 3}, "hdr": "rgba16f"},
      "passes": {
        "src":   {"type": "compute", "shader": "make.comp", "out": {"dst": "hdr"}},
        "down0": {"type": "compute", "shader": "filter.comp", "in": {"src": "hdr"}, "out": {"dst": "b.mip(0)"}},
        "down1": {"type": "compute", "shader": "filter.comp", "in": {"src": "b@down0.mip(0)"}, "out": {"dst": "b.mip(1)"}},
        "down2": {"type": "compute", "shader": "filter.comp", "in": {"src": "b@down1.mip(1)"}, "out": {"dst": "b.mip(2)"}},
        "up1":   {"type": "compute", "shader": "up.comp", "in": {"src": "b.mip(2)", "base": "b.mip(1)"}, "out": {"dst": "b.mip(1)"}},
        "up0":   {"type": "compute", "shader": "up.comp", "in": {"src": "b.mip(1)", "base": "b.mip(0)"}, "out": {"dst": "b.mip(0)"}}})j");
    EXPECT_EQ(seen(g, "down1", "src"), "down0");
    EXPECT_EQ(seen(g, "up1", "src"), "down2");
    EXPECT_EQ(seen(g, "up1", "base"), "down1");
    EXPECT_EQ(seen(g, "up1", "dst"), "down1");
    EXPECT_EQ(seen(g, "up0", "src"), "up1");
    EXPECT_EQ(seen(g, "up0", "base"), "down0");
    EXPECT_TRUE(has_edge(g, "down1", "up0", EdgeKind::war));
    EXPECT_TRUE(has_edge(g, "down2", "up1", EdgeKind::war));
}

// Pass "old" reads mip 0 with a pin on "down1", which writes only mip 1. So "old" reads the version of the
// last writer of mip 0 that runs before "down1": "down0".
TEST_F(ResolveVersions, PinOnAPassThatWritesAnotherMip) {
    const ResolvedGraph g = good(R"j("resources": {"b": {"format": "rgba16f", "mips": 2}, "y": "rgba16f"},
      "passes": {
        "down0": {"type": "compute", "shader": "make.comp", "out": {"dst": "b.mip(0)"}},
        "down1": {"type": "compute", "shader": "filter.comp", "in": {"src": "b@down0.mip(0)"}, "out": {"dst": "b.mip(1)"}},
        "up0":   {"type": "compute", "shader": "up.comp", "in": {"src": "b.mip(1)", "base": "b.mip(0)"}, "out": {"dst": "b.mip(0)"}},
        "old":   {"type": "compute", "shader": "filter.comp", "in": {"src": "b@down1.mip(0)"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(seen(g, "old", "src"), "down0");
    EXPECT_TRUE(has_edge(g, "old", "up0", EdgeKind::war));
}

TEST_F(ResolveVersions, WholeImageReadHasASourceForEachMip) {
    const ResolvedGraph g = good(R"j("resources": {"b": {"format": "rgba16f", "mips": 4}, "y": "rgba16f"},
      "passes": {
        "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "b.mip(0)"}},
        "b": {"type": "clear", "out": {"dst": "b.mip(1..3)"}},
        "r": {"type": "compute", "shader": "filter.comp", "in": {"src": "b"}, "out": {"dst": "y"}}})j");
    const UseDecl& r = use(g, "r", "src");
    ASSERT_EQ(r.sources.size(), 2u);
    EXPECT_EQ(r.sources[0].range, (SubresourceRange{0, 1, 0, 1, aspect::kColor}));
    EXPECT_EQ(r.sources[1].range, (SubresourceRange{1, 3, 0, 1, aspect::kColor}));
}

TEST_F(ResolveVersions, ChainOfInPlaceWritersFollowsAfter) {
    const ResolvedGraph g = good(kImports + R"j(
      "resources": {"x": "rgba16f"},
      "passes": {
        "base": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "one":  {"type": "compute", "shader": "change.comp", "out": ["x"], "after": ["two"]},
        "two":  {"type": "compute", "shader": "change.comp", "out": ["x"]},
        "show": {"type": "fullscreen", "shader": "show.frag", "in": {"src": "x"}, "out": ["backbuffer"]}})j");
    EXPECT_EQ(seen(g, "two", "x"), "base");
    EXPECT_EQ(seen(g, "one", "x"), "two");
    EXPECT_EQ(seen(g, "show", "src"), "one");
    EXPECT_TRUE(has_edge(g, "two", "one", EdgeKind::after));
}

TEST_F(ResolveVersions, PinOfAnInPlaceWriterOrdersItAfterThat) {
    const ResolvedGraph g = good(R"j("resources": {"x": "rgba16f"},
      "passes": {
        "base": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "one":  {"type": "compute", "shader": "change.comp", "in": {"x": "x@two"}, "out": ["x"]},
        "two":  {"type": "compute", "shader": "change.comp", "out": ["x"]}})j");
    EXPECT_EQ(seen(g, "one", "x"), "two");
    EXPECT_EQ(use(g, "one", "x").access, Access::storage_read_write);
    EXPECT_EQ(pass_in(g, "one").uses.size(), 1u);
}

// "zr" reads the first version of y, so it must run before "y2", which writes y again. This also orders the
// writers of x: "zr" before "y2".
TEST_F(ResolveVersions, OverwritesOfOneResourceOrderTheWritersOfAnother) {
    shaders["both.comp"] = compute({sampled("src"), image_in_out("x")});
    shaders["pair.comp"] = compute({image_in_out("y"), image_in_out("x")});
    const ResolvedGraph g = good(R"j("resources": {"x": "rgba16f", "y": "rgba16f"},
      "passes": {
        "y1": {"type": "compute", "shader": "make.comp", "out": {"dst": "y"}},
        "zr": {"type": "compute", "shader": "both.comp", "in": {"src": "y@y1"}, "out": ["x"]},
        "y2": {"type": "compute", "shader": "pair.comp", "out": ["x", "y"]}})j");
    EXPECT_EQ(seen(g, "y2", "x"), "zr");
    EXPECT_TRUE(has_edge(g, "zr", "y2", EdgeKind::war));
}

TEST_F(ResolveVersions, ImportsHaveContentFromBeforeTheFrame) {
    shaders["list.comp"] = compute({buffer("instances", true, false), image_out("dst")});
    const ResolvedGraph g = good(R"j("imports": {"instances": "buffer", "noise": "image"},
      "resources": {"x": "rgba16f"},
      "passes": {
        "a": {"type": "compute", "shader": "filter.comp", "in": {"src": "noise"}, "out": {"dst": "x"}},
        "b": {"type": "compute", "shader": "list.comp", "in": ["instances"], "out": {"dst": "x"}, "after": ["a"]}})j");
    EXPECT_EQ(seen(g, "a", "src"), "before");
    EXPECT_EQ(seen(g, "b", "instances"), "before");
    EXPECT_EQ(use(g, "b", "instances").state.layout, Layout::undefined);
    EXPECT_EQ(resource_in(g, "noise").lifetime, ResourceLifetime::imported);
    EXPECT_EQ(resource_in(g, "noise").usage, usage::kSampled);
}

TEST_F(ResolveVersions, ObservedReferencesBecomeReadbackPasses) {
    observed = {"x@make"};
    const ResolvedGraph g = good(R"j("resources": {"x": "rgba16f"},
      "passes": {
        "make": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "later": {"type": "compute", "shader": "change.comp", "out": ["x"]}})j");
    const PassDecl& pass = pass_in(g, "observe:x@make");
    EXPECT_EQ(pass.kind, PassKind::readback);
    EXPECT_TRUE(pass.side_effect);
    ASSERT_EQ(pass.uses.size(), 1u);
    EXPECT_EQ(pass.uses[0].access, Access::copy_read);
    EXPECT_EQ(g.passes[pass.uses[0].sources.at(0).producer].name, "make");
    EXPECT_NE(resource_in(g, "x").usage & usage::kTransferSrc, 0u);
}

// Resolves the same graph with its passes and resources declared in two orders. The results must be equal.
TEST_F(ResolveVersions, ShuffledDeclarationsResolveAlike) {
    const std::string a = R"j("base": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}})j";
    const std::string b = R"j("mod": {"type": "compute", "shader": "change.comp", "out": ["x"]})j";
    const std::string c =
        R"j("use": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "y"}})j";
    const auto text = [](const std::string& p, const std::string& q, const std::string& r,
                         const std::string& res) {
        return R"j("resources": {)j" + res + R"j(}, "passes": {)j" + p + "," + q + "," + r + "}";
    };
    const ResolvedGraph first = good(text(a, b, c, R"j("x": "rgba16f", "y": "rgba16f")j"));
    const ResolvedGraph second = good(text(c, b, a, R"j("y": "rgba16f", "x": "rgba16f")j"));
    ASSERT_EQ(first.passes.size(), second.passes.size());
    for (size_t p = 0; p < first.passes.size(); ++p) {
        EXPECT_EQ(first.passes[p].name, second.passes[p].name);
        for (size_t u = 0; u < first.passes[p].uses.size(); ++u) {
            EXPECT_EQ(first.passes[p].uses[u].sources, second.passes[p].uses[u].sources);
            EXPECT_EQ(first.passes[p].uses[u].state, second.passes[p].uses[u].state);
        }
    }
    ASSERT_EQ(first.edges.size(), second.edges.size());
    for (size_t e = 0; e < first.edges.size(); ++e) {
        EXPECT_EQ(first.edges[e].from, second.edges[e].from);
        EXPECT_EQ(first.edges[e].to, second.edges[e].to);
        EXPECT_EQ(first.edges[e].kind, second.edges[e].kind);
    }
}

TEST_F(ResolveVersions, TwoUnorderedWriters) {
    const Diagnostic d = bad(R"j(
"resources": {"x": "rgba16f"},
"passes": {
  "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
  "b": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}}})j");
    EXPECT_EQ(d.code, "W111");
    EXPECT_EQ(d.message, R"j(passes "a" and "b" both write "x", but nothing determines their order)j");
    EXPECT_EQ(d.file, "graph.json");
    EXPECT_EQ(d.line, 5u);
    ASSERT_EQ(d.notes.size(), 1u);
    EXPECT_EQ(d.notes[0].line, 4u);
    expect_help(d, "add \"after\": [\"a\"] to \"b\"");
    expect_help(d, "x@a");
}

TEST_F(ResolveVersions, UnorderedInPlaceWritersOfOneMip) {
    const Diagnostic d = bad(R"j("resources": {"x": {"format": "rgba16f", "mips": 2}},
      "passes": {
        "m": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(1)"}},
        "p": {"type": "compute", "shader": "change.comp", "out": {"x": "x.mip(1)"}},
        "q": {"type": "compute", "shader": "change.comp", "out": {"x": "x.mip(1)"}}})j");
    EXPECT_EQ(d.code, "W111");
    EXPECT_NE(d.message.find(R"j("p" and "q" both write "x.mip(1)")j"), std::string::npos) << d.message;
}

TEST_F(ResolveVersions, ReadNobodyWrites) {
    const Diagnostic d = bad(R"j(
"resources": {"x": "rgba16f", "y": "rgba16f"},
"passes": {"a": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W110");
    EXPECT_NE(d.message.find(R"j(pass "a" reads "x")j"), std::string::npos);
    EXPECT_EQ(d.line, 3u);
    expect_help(d, "out");
}

TEST_F(ResolveVersions, ReadOfAMipNobodyWrites) {
    const Diagnostic d = bad(R"j("resources": {"x": {"format": "rgba16f", "mips": 4}, "y": "rgba16f"},
      "passes": {
        "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(0)"}},
        "b": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W110");
    EXPECT_NE(d.message.find("x.mip(1..3)"), std::string::npos) << d.message;
}

TEST_F(ResolveVersions, OutputHasNoContentToRead) {
    const Diagnostic d = bad(kImports + R"j("resources": {"y": "rgba16f"},
      "passes": {"a": {"type": "compute", "shader": "filter.comp", "in": {"src": "backbuffer"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W110");
    expect_help(d, "no content when the frame begins");
}

TEST_F(ResolveVersions, CycleTellsTheLoopAndThePin) {
    shaders["trace.comp"] = compute({sampled("src"), image_out("dst")});
    shaders["apply.frag"] = fragment({"hdr"}, {sampled("acc")});
    const Diagnostic d = bad(R"j(
"resources": {"hdr": "rgba16f", "ray": "rgba16f", "acc": "rgba16f"},
"passes": {
  "lighting":    {"type": "compute", "shader": "make.comp", "out": {"dst": "hdr"}},
  "ssrTrace":    {"type": "compute", "shader": "trace.comp", "in": {"src": "hdr"}, "out": {"dst": "ray"}},
  "ssrTemporal": {"type": "compute", "shader": "trace.comp", "in": {"src": "ray"}, "out": {"dst": "acc"}},
  "ssrApply":    {"type": "fullscreen", "shader": "apply.frag", "in": ["acc"], "out": ["hdr"], "state": {"blend": "add"}}})j");
    EXPECT_EQ(d.code, "W150");
    EXPECT_EQ(d.message,
              "dependency cycle: ssrTrace (reads hdr) -> ssrApply (reads acc) -> ssrTemporal (reads ray) -> "
              "ssrTrace");
    EXPECT_EQ(d.line, 5u);
    expect_help(
        d, R"j("hdr" has several writers; select one of its versions in pass "ssrTrace": "hdr@lighting")j");
}

TEST_F(ResolveVersions, PinMendsTheCycle) {
    shaders["apply.frag"] = fragment({"hdr"}, {sampled("acc")});
    const ResolvedGraph g = good(R"j("resources": {"hdr": "rgba16f", "ray": "rgba16f"},
      "passes": {
        "lighting": {"type": "compute", "shader": "make.comp", "out": {"dst": "hdr"}},
        "trace":    {"type": "compute", "shader": "filter.comp", "in": {"src": "hdr@lighting"}, "out": {"dst": "ray"}},
        "apply":    {"type": "fullscreen", "shader": "apply.frag", "in": {"acc": "ray"}, "out": ["hdr"], "state": {"blend": "add"}}})j");
    EXPECT_EQ(seen(g, "apply", "hdr"), "lighting");
    EXPECT_EQ(use(g, "apply", "hdr").access, Access::color_read_write);
    EXPECT_TRUE(has_edge(g, "trace", "apply", EdgeKind::war));
}

TEST_F(ResolveVersions, CycleOfAfters) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f", "y": "rgba16f"},
      "passes": {
        "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}, "after": ["b"]},
        "b": {"type": "compute", "shader": "make.comp", "out": {"dst": "y"}, "after": ["a"]}})j");
    EXPECT_EQ(d.code, "W150");
    EXPECT_EQ(d.message, "dependency cycle: a (runs after b) -> b (runs after a) -> a");
    expect_help(d, "remove \"after\" from");
}

// Pass "r" must read x before pass "b" changes it, because of the pin "x@a". But the `after` of "r" requires
// that "r" runs after "b". resolve() must report a cycle.
TEST_F(ResolveVersions, PinOnAnOverwrittenVersionIsACycle) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f", "y": "rgba16f"},
      "passes": {
        "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "b": {"type": "compute", "shader": "change.comp", "out": ["x"]},
        "r": {"type": "compute", "shader": "filter.comp", "in": {"src": "x@a"}, "out": {"dst": "y"}, "after": ["b"]}})j");
    EXPECT_EQ(d.code, "W150");
}

TEST_F(ResolveVersions, AfterNamesAnUnknownPass) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f"},
      "passes": {
        "light": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "b": {"type": "compute", "shader": "change.comp", "out": ["x"], "after": ["ligth"]}})j");
    EXPECT_EQ(d.code, "W104");
    expect_help(d, "did you mean \"light\"");
}

TEST_F(ResolveVersions, PinNamesAnUnknownPass) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f", "y": "rgba16f"},
      "passes": {
        "light": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "b": {"type": "compute", "shader": "filter.comp", "in": {"src": "x@ligth"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W104");
    expect_help(d, "did you mean \"light\"");
}

TEST_F(ResolveVersions, EarlierFramesAreNotKept) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f", "y": "rgba16f"},
      "passes": {
        "light": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
        "b": {"type": "compute", "shader": "filter.comp", "in": {"src": "x[-1]"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W121");
    EXPECT_NE(d.message.find("has no history"), std::string::npos);
}

// Pass "b" reads "xray", which no pass writes, because pass "a" misspells the name. Only the misspelt name is
// reported.
TEST_F(ResolveVersions, OneCauseOneMessage) {
    const Diagnostic d = bad(R"j("resources": {"xray": "rgba16f", "y": "rgba16f"},
      "passes": {
        "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "xrey"}},
        "b": {"type": "compute", "shader": "filter.comp", "in": {"src": "xray"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W103");
    expect_help(d, "did you mean \"xray\"");
}

TEST_F(ResolveVersions, AllErrorsAtOnce) {
    const Result<ResolvedGraph> r = run(R"j("resources": {"x": "rgba16f", "y": "rgba16f"},
      "passes": {
        "a": {"type": "compute", "shader": "filter.comp", "in": {"src": "nope"}, "out": {"dst": "x"}},
        "b": {"type": "compute", "shader": "filter.comp", "in": {"src": "y.mip(7)"}, "out": {"dst": "x"}, "after": ["q"]}})j");
    ASSERT_FALSE(r.ok());
    EXPECT_EQ(r.errors().size(), 3u) << to_text(r.errors());
}

}  // namespace
}  // namespace weft::test
