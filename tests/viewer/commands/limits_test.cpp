// Tests the table of limits: docs/SECURITY.md shows the same values, and --limits changes them.
#include "weft/limits.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr const char* kGood = WEFT_SOURCE_DIR "/tests/viewer/commands/sky.json";

class LimitsFile : public testing::Test {
 protected:
    [[nodiscard]] RunResult check(const std::string& limits) const {
        scratch_.write("limits.json", limits);
        return run_weft({"check", kGood, "--limits", scratch_ / "limits.json"});
    }
    void expect_refused(const std::string& limits, const std::vector<std::string>& wanted) const {
        const RunResult run = check(limits);
        EXPECT_EQ(run.exit_code, 3) << run.text();
        for (const std::string& part : wanted)
            EXPECT_NE(run.err.find(part), std::string::npos) << "wanted: " << part << "\n" << run.text();
    }

    ScratchFolder scratch_;
};

TEST(LimitTable, TheDocumentedTableIsTheOneInTheCode) {
    std::istringstream page(read_text(WEFT_SOURCE_DIR "/docs/SECURITY.md"));
    std::string documented, real;
    for (std::string line; std::getline(page, line);)
        if (line.starts_with("| `") && line.find('.') < line.find("` |")) documented += line + "\n";
    Limits defaults;
    for (const LimitRow& row : limit_table())
        real += std::string("| `") + row.name + "` | " + std::to_string(row.of(defaults)) +
                (*row.unit == 0 ? "" : std::string(" ") + row.unit) + " | " + std::to_string(row.most) +
                " | " + row.guards + " |\n";
    EXPECT_EQ(documented, real);
}

// Every member of Limits needs a row in the table; otherwise --limits could not change the member.
TEST(LimitTable, HasARowForEachLimit) {
    EXPECT_EQ(limit_table().size(), sizeof(Limits) / sizeof(uint64_t));
    Limits limits;
    uint64_t mark = 1;
    for (const LimitRow& row : limit_table()) row.of(limits) = ++mark;
    mark = 1;
    for (const LimitRow& row : limit_table()) EXPECT_EQ(row.of(limits), ++mark) << row.name;
    Limits defaults;
    for (const LimitRow& row : limit_table()) EXPECT_LE(row.of(defaults), row.most) << row.name;
}

TEST_F(LimitsFile, ChangesWhatItNames) {
    EXPECT_EQ(check("{}").exit_code, 0);
    EXPECT_EQ(check(R"({ "graph.passes": 2, })").exit_code, 0);
    expect_refused(R"({ "graph.passes": 1 })", {"error[W125]", "more than 1 passes"});
    expect_refused(R"({ "graph.jsonDepth": 2 })", {"error[W004]", "more than 2 levels deep"});
    expect_refused(R"({ "graph.jsonBytes": 10 })", {"error[W004]", "more than 10 B"});
    expect_refused(R"({ "graph.transientBytes": 4096 })", {"error[W125]", "more than 4 KiB"});
    expect_refused(R"({ "shader.fileBytes": 10 })", {"error[W201]", "larger than 10 B"});
}

TEST_F(LimitsFile, IsAFileLikeAnyOther) {
    expect_refused(R"({ "graph.pases": 1 })",
                   {"limits.json:1:3: error[X560]", "no limit has the name \"graph.pases\"",
                    "did you mean \"graph.passes\"", "shader.stageMs, "});
    expect_refused("{\n  \"graph.mips\": \"4\" }",
                   {"limits.json:2:17: error[X560]", "is string, wanted a whole number"});
    for (const char* value : {"0", "-1", "1.5", "1e30", "true", "null", "[4]"})
        expect_refused(std::string("{ \"graph.mips\": ") + value + " }",
                       {"limits.json:1:17: error[X560]", "of 1 to 17", "the default is 15"});
    expect_refused(R"({ "graph.mips": 4, "graph.mips": 5 })", {"error[W003]"});
    expect_refused("[]", {"limits.json:1:1: error[X560]", "wanted an object"});
    expect_refused("{ \"graph.mips\": 4", {"error[W001]"});
    expect_refused(R"({ "a": 1, "b": 2 })", {"1:3: error[X560]", "1:11: error[X560]"});
    const RunResult missing = run_weft({"plan", kGood, "--limits", "no/such.json"});
    EXPECT_EQ(missing.exit_code, 3) << missing.text();
    EXPECT_NE(missing.err.find("no/such.json: error[W002]"), std::string::npos) << missing.text();
}

TEST_F(LimitsFile, IsTakenByEveryCommandThatReadsInputs) {
    scratch_.write("limits.json", R"({ "graph.passes": 1, "picture.sidePx": 1, "scene.vertices": 1 })");
    const std::string limits = scratch_ / "limits.json";
    const std::string picture = WEFT_SOURCE_DIR "/docs/images/ink.png";
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"plan", kGood},
                                               {"explain", kGood, "culled", "sky"},
                                               {"diff", kGood, kGood},
                                               {"compare", picture, picture}}) {
        std::vector<std::string> more = words;
        more.insert(more.end(), {"--limits", limits});
        EXPECT_EQ(run_weft(words).exit_code, 0) << words[0];
        const RunResult run = run_weft(more);
        EXPECT_EQ(run.exit_code, 3) << words[0] << "\n" << run.text();
    }
}

}  // namespace
}  // namespace weft::test
