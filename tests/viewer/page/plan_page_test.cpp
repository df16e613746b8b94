// Tests `weft plan --format html` for every shipped graph. With WEFT_EXTENDED, a browser opens the pages.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/graph/report/html/markup_reader.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

const std::string kDeferred = WEFT_SOURCE_DIR "/graphs/deferred.json";

// Returns a graph with a chain of 500 passes. The first pass clears an image; each later pass copies the
// image of the previous pass. The pass "show" displays the last image.
std::string long_graph() {
    std::string resources, passes;
    for (int i = 0; i < 500; ++i) {
        const std::string n = std::to_string(i), before = std::to_string(i - 1);
        resources += (i > 0 ? ", " : "") + ("\"image" + n + "\": \"rgba8\"");
        passes += "\"pass" + n + "\": " +
                  (i == 0 ? std::string(R"({ "type": "clear", "out": ["image0"], "clear": 1 }, )")
                          : R"({ "type": "copy", "in": { "src": "image)" + before +
                                R"(" }, "out": { "dst": "image)" + n + "\" } }, ");
    }
    return R"({ "version": 1, "name": "long", "imports": { "backbuffer": "output" }, "resources": { )" +
           resources + R"( }, "passes": { )" + passes +
           R"("show": { "type": "blit", "in": { "src": "image499" }, "out": { "dst": "backbuffer" } } } })";
}

TEST(PlanPage, OfEveryShippedGraphIsWellFormedAndNamesItsSource) {
    for (const auto& entry : std::filesystem::directory_iterator(WEFT_SOURCE_DIR "/graphs")) {
        if (entry.path().extension() != ".json" || entry.path().stem() == "weft.schema") continue;
        const std::string file = entry.path().string();
        const RunResult run =
            run_weft({"plan", file, "--format", "html", "--queues", "3", "--profile", "discrete"});
        ASSERT_EQ(run.exit_code, 0) << run.text();
        EXPECT_EQ(read_markup(run.out).fault, "") << file;
        EXPECT_NE(run.out.find("<dt>file</dt><dd>" + file + "</dd>"), std::string::npos);
        EXPECT_NE(run.out.find("<dt>profile</dt><dd>discrete, three queue families</dd>"), std::string::npos);
    }
}

TEST(PlanPage, GoesToAFileAndIsTheSameEveryTime) {
    const ScratchFolder folder;
    const RunResult run = run_weft({"plan", kDeferred, "--format", "html", "--output", folder / "plan.html"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_TRUE(run.out.empty());
    EXPECT_EQ(read_text(folder / "plan.html"), run_weft({"plan", kDeferred, "--format", "html"}).out);
}

TEST(PlanPage, WorksInABrowser) {
    if (!extended()) GTEST_SKIP() << "only with WEFT_EXTENDED";
    const ScratchFolder folder;
    folder.write("long.json", long_graph());
    struct Page {
        std::string name, graph, queues;
    };
    for (const Page& page : {Page{"deferred", kDeferred, "1"}, Page{"deferred3", kDeferred, "3"},
                             Page{"bloom", WEFT_SOURCE_DIR "/graphs/bloom.json", "1"},
                             Page{"dof", WEFT_SOURCE_DIR "/graphs/dof.json", "1"},
                             Page{"forward", WEFT_SOURCE_DIR "/graphs/forward.json", "2"},
                             Page{"rounds", WEFT_SOURCE_DIR "/graphs/reaction_diffusion.json", "3"},
                             Page{"light_indexed", WEFT_SOURCE_DIR "/graphs/light_indexed.json", "1"},
                             Page{"things", WEFT_SOURCE_DIR "/tests/viewer/page/pages/things.json", "3"},
                             Page{"long", folder / "long.json", "1"}}) {
        const std::string file = folder / (page.name + ".html");
        const RunResult run = run_weft({"plan", page.graph, "--format", "html", "--queues", page.queues,
                                        "--profile", "discrete", "--output", file});
        ASSERT_EQ(run.exit_code, 0) << run.text();
        const RunResult browser =
            run_program({"/usr/bin/python3", WEFT_SOURCE_DIR "/tests/viewer/page/page_in_chromium.py",
                         folder.path().string(), file});
        EXPECT_EQ(browser.exit_code, 0) << browser.text();
        if (page.name == "things") {
            EXPECT_NE(browser.out.find(": pass, edge, barrier, wait, batch, cell, life, block, alive: good"),
                      std::string::npos)
                << browser.text();
        }
    }
}

}  // namespace
}  // namespace weft::test
