// Tests the errors of resolve(): each fault in a graph gives only one message, messages of the same kind are
// in the order of the file, and the help text names a remedy.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class OneCause : public ResolveTest {
 protected:
    OneCause() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["filter.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["change.comp"] = compute({sampled("src"), image_in_out("dst")});
        shaders["picture.frag"] = fragment({"backbuffer"}, {});
        shaders["show.frag"] = fragment({"backbuffer"}, {sampled("src")});
    }

    // Returns a graph whose passes filter the mip levels of the image "bloom" downwards and then upwards.
    // The repeated pass "down" reads the mip levels of `source`: "bloom", or a version such as "bloom@down".
    static std::string chain(const std::string& source) {
        return R"j("imports": {"backbuffer": "output"}, "resources": {"hdr": "rgba16f", "bloom": {"format": "rgba16f", "mips": 5}},
          "passes": {
            "make":  {"type": "compute", "shader": "make.comp", "out": {"dst": "hdr"}},
            "first": {"type": "compute", "shader": "filter.comp", "in": {"src": "hdr"}, "out": {"dst": "bloom.mip(0)"}},
            "down":  {"type": "compute", "shader": "filter.comp", "repeat": {"i": "1..4"},
                      "in": {"src": ")j" +
               source + R"j(.mip(i-1)"}, "out": {"dst": "bloom.mip(i)"}},
            "up":    {"type": "compute", "shader": "change.comp", "repeat": {"i": "3..0 by -1"},
                      "in": {"src": "bloom.mip(i+1)"}, "out": {"dst": "bloom.mip(i)"}},
            "show":  {"type": "fullscreen", "shader": "show.frag", "in": {"src": "bloom.mip(0)"}, "out": ["backbuffer"]}})j";
    }
};

TEST_F(OneCause, ACycleOfARepeatIsMendedByThePinThatItsHelpNames) {
    const Diagnostic d = bad(chain("bloom"));
    EXPECT_EQ(d.code, "W150");
    expect_help(d, R"j(select one of its versions in pass "down": "bloom@down")j");
    const ResolvedGraph g = good(chain("bloom@down"));
    EXPECT_EQ(seen(g, "down#1", "src"), "first");
    EXPECT_EQ(seen(g, "down#2", "src"), "down#1");
}

TEST_F(OneCause, AMisspeltOutputIsNotAlsoAMissingPort) {
    const Diagnostic d = bad(R"j("imports": {"backbuffer": "output"},
      "passes": {"picture": {"type": "fullscreen", "shader": "picture.frag", "out": ["backbufer"]}})j");
    EXPECT_EQ(d.code, "W103");
    expect_help(d, "did you mean \"backbuffer\"?");
}

TEST_F(OneCause, AnUnknownResourceUnderAnotherNameIsAFaultOfItsOwn) {
    const Result<ResolvedGraph> g = run(R"j("imports": {"backbuffer": "output"},
      "passes": {"picture": {"type": "fullscreen", "shader": "picture.frag", "out": ["nowhere"]}})j");
    ASSERT_FALSE(g.ok());
    ASSERT_EQ(g.errors().size(), 2u) << to_text(g.errors());
    EXPECT_EQ(g.errors()[1].code, "W171") << "mending the name would not bind \"backbuffer\"";
}

TEST_F(OneCause, ReadersOfWhatNobodyWritesComeInTheFilesOrder) {
    const Result<ResolvedGraph> g = run(R"j("resources": {"x": "rgba16f", "y": "rgba16f", "z": "rgba16f"},
      "passes": {
        "second": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "y"}},
        "first":  {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "z"}}})j");
    ASSERT_FALSE(g.ok());
    ASSERT_EQ(g.errors().size(), 2u) << to_text(g.errors());
    for (const Diagnostic& d : g.errors()) EXPECT_EQ(d.code, "W110");
    EXPECT_LT(g.errors()[0].line, g.errors()[1].line);
}

TEST_F(OneCause, EveryParameterThatIsAskedForIsLookedAt) {
    params = {{"light", 3}, {"fog", 0.5}};
    const Result<ResolvedGraph> g = run(R"j("imports": {"backbuffer": "output"},
      "params": {"light": {"default": 1, "range": [0, 2]}},
      "passes": {"picture": {"type": "clear", "out": ["backbuffer"], "clear": ["light", 0, 0, 1]}})j");
    ASSERT_FALSE(g.ok());
    ASSERT_EQ(g.errors().size(), 2u) << to_text(g.errors());
    EXPECT_EQ(g.errors()[0].message, "the graph has no parameter \"fog\"");
    EXPECT_EQ(g.errors()[1].message, "parameter \"light\" cannot be 3");
}

}  // namespace
}  // namespace weft::test
