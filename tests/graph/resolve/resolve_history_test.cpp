// Tests persistent resources: `history`, `keep`, the initial content, and the accesses that are allowed.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveHistory : public ResolveTest {
 protected:
    ResolveHistory() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["mix.comp"] = compute({sampled("prev"), image_out("dst")});
        shaders["mix2.comp"] = compute({sampled("prev"), sampled("older"), image_out("dst")});
        shaders["copy.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["update.comp"] = compute({image_in_out("x")});
        shaders["add.frag"] = fragment({"color"});
    }

    // Returns a graph in which pass "mix" reads the reference `prev` at its port "prev", and writes "acc".
    // Pass "show" copies "acc" to "y". `acc` contains further members of the image "acc".
    static std::string temporal(const std::string& acc = R"j("history": 1)j",
                                const std::string& prev = "acc[-1]") {
        return R"j("resources": {"y": "rgba16f",
"acc": {"format": "rgba16f", )j" +
               acc + R"j(}}, "passes": {
"mix": {"type": "compute", "shader": "mix.comp", "in": {"prev": ")j" +
               prev + R"j("}, "out": {"dst": "acc.mip(0)"}},
"show": {"type": "compute", "shader": "copy.comp", "in": {"src": "acc.mip(0)"}, "out": {"dst": "y"}}})j";
    }
    static std::string in_place(const std::string& keys) {
        return R"j("resources": {"x": {"format": "rgba16f", )j" + keys + R"j(}}, "passes": {
"up": {"type": "compute", "shader": "update.comp", "in": {"x": "x"}, "out": {"x": "x"}}})j";
    }
};

TEST_F(ResolveHistory, BecomesARingOfRoles) {
    const ResolvedGraph g = good(temporal(R"j("history": 2, "mips": 3, "firstFrame": [1, 2, 3, 4],
        "onResize": "resample")j"));
    ASSERT_EQ(g.resources.size(), 4u);
    const char* names[] = {"acc", "acc[-1]", "acc[-2]", "y"};
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(g.resources[i].name, names[i]);
    for (uint32_t age = 0; age < 3; ++age) {
        const ResourceDecl& role = g.resources[age];
        EXPECT_EQ(role.lifetime, ResourceLifetime::persistent);
        EXPECT_EQ(role.history, 2u);
        EXPECT_EQ(role.ring, 0u);
        EXPECT_EQ(role.age, age);
        EXPECT_EQ(role.format, Format::rgba16f);
        EXPECT_EQ(role.extent, (Extent3D{640, 360, 1}));
        EXPECT_EQ(role.mips, 3u);
        EXPECT_EQ(role.usage, usage::kSampled | usage::kStorage | usage::kTransferSrc | usage::kTransferDst);
        EXPECT_EQ(role.first_frame, (std::array<float, 4>{1, 2, 3, 4}));
        EXPECT_EQ(role.on_resize, OnResize::resample);
    }
    EXPECT_EQ(g.resources[3].ring, kNoId);
    EXPECT_EQ(g.resources[3].lifetime, ResourceLifetime::transient);
}

TEST_F(ResolveHistory, AReadOfTheLastFrameIsNoDependency) {
    observed = {"y"};
    const ResolvedGraph g = good(temporal());
    const UseDecl& prev = use(g, "mix", "prev");
    EXPECT_EQ(g.resources[prev.resource].name, "acc[-1]");
    EXPECT_EQ(prev.history, 1u);
    EXPECT_EQ(seen(g, "mix", "prev"), "before");
    EXPECT_EQ(seen(g, "show", "src"), "mix");
    EXPECT_EQ(use(g, "mix", "dst").access, Access::storage_write);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(ResolveHistory, CyclesThroughHistoryAreNone) {
    const ResolvedGraph g = good(R"j("resources": {"a": {"format": "rgba16f", "history": 1},
        "b": {"format": "rgba16f", "history": 1}}, "passes": {
      "pa": {"type": "compute", "shader": "mix.comp", "in": {"prev": "b"}, "out": {"dst": "a"}},
      "pb": {"type": "compute", "shader": "mix.comp", "in": {"prev": "a[-1]"}, "out": {"dst": "b"}}})j");
    EXPECT_TRUE(has_edge(g, "pb", "pa", EdgeKind::raw));
    EXPECT_FALSE(has_edge(g, "pa", "pb", EdgeKind::raw));
}

TEST_F(ResolveHistory, PartsOfAnEarlierFrame) {
    const ResolvedGraph g = good(temporal(R"j("history": 1, "mips": 4)j", "acc[-1].mip(mips(acc)-2)"));
    EXPECT_EQ(use(g, "mix", "prev").range.mip, 2u);
    EXPECT_EQ(use(g, "mix", "prev").range.mips, 1u);
}

TEST_F(ResolveHistory, TheFormatServesAllRoles) {
    profile.formats[Format::rgba16f] &= ~format_feature::kSampled;
    const Diagnostic d = bad(temporal());
    EXPECT_EQ(d.code, "W117");
    EXPECT_EQ(d.line, 2u);
}

TEST_F(ResolveHistory, FurtherBackThanIsKept) {
    const Diagnostic d = bad(temporal(R"j("history": 1)j", "acc[-2]"));
    EXPECT_EQ(d.code, "W121");
    EXPECT_EQ(d.line, 3u);
    EXPECT_NE(d.message.find("keeps only 1"), std::string::npos) << d.message;
    expect_help(d, R"j("history": 2)j");
    const Diagnostic none = bad(temporal(R"j("mips": 1)j"));
    EXPECT_EQ(none.code, "W121");
    expect_help(none, R"j("history": 1)j");
    const Diagnostic kept = bad(temporal(R"j("keep": true)j"));
    EXPECT_EQ(kept.code, "W121");
}

TEST_F(ResolveHistory, ImportsHaveNone) {
    const Diagnostic d = bad(R"j("imports": {"noise": "image"}, "resources": {"y": "rgba16f"}, "passes": {
      "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "noise[-1]"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W121");
    expect_help(d, "imports have no history");
}

TEST_F(ResolveHistory, EarlierFramesAreReadOnly) {
    const Diagnostic d = bad(R"j("resources": {"x": {"format": "rgba16f", "history": 1}}, "passes": {
      "make": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
      "back": {"type": "compute", "shader": "make.comp", "out": {"dst": "x[-1]"}}})j");
    EXPECT_EQ(d.code, "W122");
    EXPECT_EQ(d.line, 3u);
    expect_help(d, R"j(write "x": the next frame reads this content as "x[-1]")j");
}

TEST_F(ResolveHistory, OnlyTheLastVersionIsKept) {
    const Diagnostic d = bad(temporal(R"j("history": 1)j", "acc@mix[-1]"));
    EXPECT_EQ(d.code, "W122");
    expect_help(d, R"j("acc[-1]")j");
}

TEST_F(ResolveHistory, SomebodyMustWriteIt) {
    const Diagnostic d =
        bad(R"j("resources": {"x": {"format": "rgba16f", "history": 1}, "y": "rgba16f"}, "passes": {
      "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "x[-1]"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W110");
    // No pass writes "acc", because pass "m" misspells the name as "accc". resolve() must report only the
    // unknown name (W103), not also that no pass writes "acc" (W110).
    const Diagnostic near =
        bad(R"j("resources": {"acc": {"format": "rgba16f", "history": 1}, "y": "rgba16f"}, "passes": {
      "m": {"type": "compute", "shader": "make.comp", "out": {"dst": "accc"}},
      "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "acc[-1]"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(near.code, "W103");
}

TEST_F(ResolveHistory, ThisFramesCopyIsEmptyAtFirst) {
    const Diagnostic d = bad(in_place(R"j("history": 1)j"));
    EXPECT_EQ(d.code, "W110");
    EXPECT_EQ(d.line, 2u);
    expect_help(d, R"j("x[-1]")j");
    const Diagnostic blend = bad(R"j("resources": {"x": {"format": "rgba16f", "history": 1}}, "passes": {
      "b": {"type": "fullscreen", "shader": "add.frag", "out": {"color": "x"}, "state": {"blend": "add"}}})j");
    EXPECT_EQ(blend.code, "W110");
    expect_help(blend, R"j("x[-1]")j");
}

TEST_F(ResolveHistory, KeptContentIsUpdatedInPlace) {
    const ResolvedGraph g = good(in_place(R"j("keep": true, "firstFrame": 1)j"));
    ASSERT_EQ(g.resources.size(), 1u);
    EXPECT_EQ(g.resources[0].lifetime, ResourceLifetime::persistent);
    EXPECT_EQ(g.resources[0].history, 0u);
    EXPECT_EQ(g.resources[0].ring, 0u);
    EXPECT_EQ(g.resources[0].first_frame, (std::array<float, 4>{1, 1, 1, 1}));
    EXPECT_EQ(use(g, "up", "x").access, Access::storage_read_write);
    EXPECT_EQ(seen(g, "up", "x"), "before");
}

TEST_F(ResolveHistory, KeptContentIsReadWithoutAWriter) {
    const ResolvedGraph g =
        good(R"j("resources": {"x": {"format": "rgba16f", "keep": "shared"}, "y": "rgba16f"},
      "passes": {
      "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "x.mip(0)"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(seen(g, "c", "src"), "before");
    EXPECT_EQ(use(g, "c", "src").sources.front().range, resource_in(g, "x").whole());
}

TEST_F(ResolveHistory, BuffersToo) {
    shaders["step.comp"] = compute({buffer("prev", true, false), buffer("next", false, true)});
    const ResolvedGraph g =
        good(R"j("resources": {"b": {"buffer": "vec4", "count": 8, "history": 1}}, "passes": {
      "s": {"type": "compute", "shader": "step.comp", "groups": 1, "in": {"prev": "b[-1]"}, "out": {"next": "b"}}})j");
    EXPECT_EQ(resource_in(g, "b[-1]").size_bytes, 128u);
    EXPECT_EQ(resource_in(g, "b[-1]").usage, usage::kStorage | usage::kTransferSrc | usage::kTransferDst);
}

TEST_F(ResolveHistory, ObserversMayAskForThePast) {
    observed = {"acc[-1]"};
    const ResolvedGraph g = good(temporal());
    EXPECT_EQ(seen(g, "observe:acc[-1]", "src"), "before");
}

TEST_F(ResolveHistory, ValidMembers) {
    shaders["mix.comp"] = with_params(compute({sampled("prev"), image_out("dst")}),
                                      {member("prevValid", 1, ScalarType::boolean),
                                       member("dstValid", 1, ScalarType::u32), member("prevSize", 2)});
    const ResolvedGraph g = good(temporal());
    const std::vector<ParamWrite>& params_written = pass_in(g, "mix").params;
    ASSERT_EQ(params_written.size(), 3u);
    EXPECT_EQ(params_written[0].builtin, Builtin::valid);
    EXPECT_EQ(g.resources[params_written[0].resource].name, "acc[-1]");
    EXPECT_EQ(params_written[1].builtin, Builtin::none);
    EXPECT_EQ(params_written[1].value[0], 1.0);
    EXPECT_EQ(params_written[2].value[0], 640.0);
}

TEST_F(ResolveHistory, ValidOfNoPort) {
    shaders["mix.comp"] = with_params(compute({sampled("prev"), image_out("dst")}), {member("pervValid")});
    const Diagnostic d = bad(temporal());
    EXPECT_EQ(d.code, "W113");
    expect_help(d, "did you mean \"prevValid\"");
    shaders["mix.comp"] = with_params(compute({sampled("prev"), image_out("dst")}), {member("prevValid", 2)});
    EXPECT_EQ(bad(temporal()).code, "W113");
}

}  // namespace
}  // namespace weft::test
