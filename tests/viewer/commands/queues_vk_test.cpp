// Tests that the picture is the same for any number of queues in the plan, and that the validation layer
// gives no message.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

// Returns the shipped deferred graph with additional queue hints for the transfer queue and the async compute
// queue.
std::string graph_with_hints() {
    std::string graph = read_text(WEFT_SOURCE_DIR "/graphs/deferred.json");
    const auto hint = [&](const std::string& pass, const std::string& queue) {
        const size_t at = graph.find("\"type\"", graph.find("\"" + pass + "\":"));
        graph.insert(at, "\"queue\": \"" + queue + "\", ");
    };
    hint("lightUpload", "transfer");
    hint("lighting", "async");
    return graph;
}

TEST(Queues, OnePictureForAnyNumber) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    folder.write("hints.json", graph_with_hints());
    std::set<std::string> pictures, plans;
    for (const char* queues : {"1", "2", "3", "4"}) {
        const RunResult run = run_weft({"render", "builtin:spheres", "--graph", folder / "hints.json",
                                        "--size", "96x64", "--frames", "3", "--queues", queues, "--validate",
                                        "-o", folder / "a.png", "--stats", folder / "stats.json"});
        ASSERT_EQ(run.exit_code, 0) << run.text();
        const auto stats = nlohmann::json::parse(read_text(folder / "stats.json"));
        pictures.insert(stats.at("output_sha256"));
        plans.insert(stats.at("plan_hash"));
    }
    EXPECT_EQ(pictures.size(), 1u);
    EXPECT_GE(plans.size(), 3u) << "plans for one, two and three queues differ";
}

// Renders the shipped graphs with the queue hints that they already have. The quick run leaves out graphs
// that share all their modules with one of these.
TEST(Queues, EveryShippedGraphGivesOnePicture) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const std::set<std::string> quick{"bloom", "forward_plus", "light_volumes", "reaction_diffusion", "weft"};
    const ScratchFolder folder;
    size_t graphs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(WEFT_SOURCE_DIR "/graphs")) {
        if (entry.path().extension() != ".json" || entry.path().stem() == "weft.schema") continue;
        if (!extended() && !quick.contains(entry.path().stem().string())) continue;
        SCOPED_TRACE(entry.path().filename().string());
        ++graphs;
        std::set<std::string> pictures;
        for (const char* queues : {"1", "2", "3"}) {
            if (*queues == '2' && !extended()) continue;
            const RunResult run =
                run_weft({"render", "builtin:spheres", "--graph", entry.path().string(), "--size", "96x64",
                          "--frames", "3", "--queues", queues, "--validate", "-o", folder / "a.png",
                          "--stats", folder / "stats.json"});
            ASSERT_EQ(run.exit_code, 0) << run.text();
            pictures.insert(nlohmann::json::parse(read_text(folder / "stats.json"))
                                .at("output_sha256")
                                .get<std::string>());
        }
        EXPECT_EQ(pictures.size(), 1u);
    }
    EXPECT_GE(graphs, quick.size());
}

TEST(Queues, AreOneToFour) {
    for (const char* queues : {"0", "5", "two"})
        EXPECT_EQ(run_weft({"render", "--queues", queues}).exit_code, 2);
}

}  // namespace
}  // namespace weft::test
