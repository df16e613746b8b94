// The same picture, bit for bit, from run to run and for every number of the driver's threads.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "viewer/program.h"

namespace weft::test {
namespace {

TEST(Determinism, OneHashForEveryRunAndThreadCount) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    const int runs = extended() ? 5 : 1;
    std::set<std::string> hashes;
    for (const char* threads : {"0", "1", "2"}) {
        for (int i = 0; i < runs; ++i) {
            const RunResult run = run_weft({"render", "builtin:atrium", "--size", "320x180", "--frames", "4",
                                            "-o", folder / "a.png", "--stats", folder / "stats.json"},
                                           {{"LP_NUM_THREADS", threads}});
            ASSERT_EQ(run.exit_code, 0) << run.text();
            const auto stats = nlohmann::json::parse(read_text(folder / "stats.json"));
            hashes.insert(stats.at("output_sha256"));
            EXPECT_EQ(stats.at("frames"), 4);
        }
    }
    ASSERT_EQ(hashes.size(), 1u);
    EXPECT_EQ(hashes.begin()->size(), 64u);
    RecordProperty("output_sha256", *hashes.begin());
}

}  // namespace
}  // namespace weft::test
