// Tests the rules for passes with "rest": which passes form a unit, and which graphs are refused.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveRest : public ResolveTest {
 protected:
    ResolveRest() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["read.comp"] = compute({sampled("a"), image_out("dst")});
        shaders["load.comp"] = compute({image_in("a"), image_out("dst")});
        shaders["change.comp"] = compute({image_in_out("dst")});
        shaders["show.frag"] = fragment({"backbuffer"}, {sampled("a")});
    }

    static std::string graph(const std::string& text) {
        return R"j("imports": {"backbuffer": "output"}, "resources": {
            "k": {"format": "rgba16f", "keep": true}, "layered": {"format": "rgba16f", "layers": 2, "keep": true},
            "t": "rgba16f", "u": "rgba16f", "h": {"format": "rgba16f", "history": 1}}, "passes": {)j" +
               text + "}";
    }
    static std::string rest(const std::string& name, const std::string& shader, const std::string& in,
                            const std::string& out, const std::string& more = "") {
        return "\"" + name + R"(": {"type": "compute", "shader": ")" + shader + ".comp\"" +
               (in.empty() ? "" : R"(, "in": {"a": ")" + in + "\"}") + R"(, "out": {"dst": ")" + out +
               R"("}, "rest": true)" + more + "},\n";
    }
    static std::string show(const std::string& in) {
        return R"("show": {"type": "fullscreen", "shader": "show.frag", "in": {"a": ")" + in +
               R"("}, "out": ["backbuffer"]})";
    }
    void expect_refused(const std::string& text, const std::string& message, const std::string& help) {
        const Diagnostic d = bad(graph(text));
        EXPECT_EQ(d.code, "W188");
        EXPECT_NE(d.message.find(message), std::string::npos) << d.message;
        expect_help(d, help);
    }
};

TEST_F(ResolveRest, WritersOfOnePartAndUsersOfATransientFormAUnit) {
    const ResolvedGraph made =
        good(graph(rest("first", "make", "", "t") + rest("second", "read", "t", "layered.layer(0)") +
                   rest("third", "change", "", "layered.layer(0)", R"(, "after": ["second"])") +
                   rest("other", "make", "", "layered.layer(1)") +
                   rest("reads", "read", "layered.layer(1)", "k") + show("k")));
    const auto unit = [&](const char* pass) { return pass_in(made, pass).rest_unit; };
    EXPECT_EQ(made.rest_unit_count, 3u);
    EXPECT_EQ(unit("first"), unit("second"));
    EXPECT_EQ(unit("first"), unit("third"));
    EXPECT_NE(unit("first"), unit("other"));
    EXPECT_NE(unit("other"), unit("reads")) << "reading the last version does not unite";
    EXPECT_EQ(unit("show"), kNoId);
    EXPECT_EQ(seen(made, "second", "dst"), "") << "the pass writes all of its output";
}

TEST_F(ResolveRest, AReaderOfAMiddleVersionBelongsToTheUnit) {
    const ResolvedGraph made =
        good(graph(rest("make", "make", "", "k") + rest("early", "read", "k@make", "layered.layer(0)") +
                   rest("change", "change", "", "k", R"(, "after": ["make"])") + show("layered.layer(0)")));
    EXPECT_EQ(made.rest_unit_count, 1u);
}

TEST_F(ResolveRest, ReadersThatNeedDifferentLayoutsUseGeneral) {
    const ResolvedGraph made =
        good(graph(rest("make", "make", "", "k") + rest("load", "load", "k", "layered.layer(0)") +
                   rest("use", "read", "layered.layer(0)", "layered.layer(1)") + show("k")));
    EXPECT_EQ(use(made, "load", "a").state.layout, Layout::general);
    EXPECT_EQ(use(made, "show", "a").state.layout, Layout::general);
    EXPECT_EQ(use(made, "use", "a").state.layout, Layout::shader_read_only);
}

TEST_F(ResolveRest, RefusesWhatItCannotKeep) {
    const std::string make_t = R"("make": {"type": "compute", "shader": "make.comp", "out": {"dst": "t"}},)";
    expect_refused(make_t + rest("table", "read", "t", "k") + show("k"), "would never rest",
                   "\"rest\": true");
    expect_refused(rest("table", "make", "", "t") + show("t"), "does not keep its content", "\"keep\": true");
    expect_refused(rest("table", "make", "", "h") + show("h"), "history", "instead of \"history\"");
    expect_refused(
        rest("table", "make", "", "k") +
            R"("more": {"type": "compute", "shader": "change.comp", "out": {"dst": "k"}, "after": ["table"]},)" +
            show("k"),
        "in every frame", "\"rest\": true to pass \"more\"");
    expect_refused(rest("table", "change", "", "k") + show("k"), "content that \"k\" had before",
                   "write all of");
    expect_refused(rest("table", "make", "", "k", R"(, "partial": true)") + show("k"), "had before",
                   "write all of");
    expect_refused(
        rest("table", "make", "", "layered.layer(i)", R"(, "repeat": {"i": "0..1"}, "perFrame": true)") +
            show("layered.layer(0)"),
        "\"perFrame\"", "remove one");
    expect_refused(
        rest("table", "make", "", "k") +
            R"("early": {"type": "compute", "shader": "read.comp", "in": {"a": "k@table"}, "out": {"dst": "t"}},)" +
            rest("change", "change", "", "k", R"(, "after": ["table"])") +
            R"("join": {"type": "compute", "shader": "read.comp", "in": {"a": "k"}, "out": {"dst": "u"}},)" +
            R"("show": {"type": "fullscreen", "shader": "show.frag", "in": {"a": "t"}, "out": ["backbuffer"]},)" +
            R"("see": {"type": "readback", "in": ["u"]})",
        "has only the content after the change", "after pass \"change\"");
}

TEST_F(ResolveRest, APortThatDoesNotWakeMayReadWhatChanges) {
    const std::string make_t = R"("make": {"type": "compute", "shader": "make.comp", "out": {"dst": "t"}},)";
    const std::string port = R"("in": {"a": {"ref": "t", "wakes": false}}, "out": {"dst": "k"})";
    const ResolvedGraph made = good(graph(make_t + R"("table": {"type": "compute", "shader": "read.comp", )" +
                                          port + R"(, "rest": true},)" + show("k")));
    EXPECT_FALSE(use(made, "table", "a").wakes);
    EXPECT_NE(pass_in(made, "table").rest_unit, kNoId);
    expect_refused(
        make_t + R"("table": {"type": "compute", "shader": "read.comp", )" + port + "}," + show("k"),
        "has no \"rest\"", "remove \"wakes\"");
}

TEST_F(ResolveRest, AHistoryMakesRestImpossible) {
    expect_refused(R"("make": {"type": "compute", "shader": "make.comp", "out": {"dst": "h"}},)" +
                       rest("table", "read", "h[-1]", "k") + show("k"),
                   "would never rest", "remove \"rest\"");
}

}  // namespace
}  // namespace weft::test
