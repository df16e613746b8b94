// Tests that `weft check` ends within 5 s of processor time and 1 GiB of memory for large and damaged graphs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/viewer/hostile/large_mutants.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

constexpr uint32_t kFirstSeed = 15'000;

uint32_t number_from(const char* variable, uint32_t fallback) {
    const char* value = std::getenv(variable);
    return value != nullptr ? static_cast<uint32_t>(std::strtoul(value, nullptr, 10)) : fallback;
}

TEST(LargeMutants, EndByThemselvesInTime) {
    const uint32_t first = number_from("WEFT_MUTANT_SEED", kFirstSeed);
    const uint32_t count = number_from("WEFT_MUTANTS", extended() ? 10'000 : 200);
    const ScratchFolder scratch;
    std::vector<double> cpu_s;
    std::vector<uint64_t> memory_bytes;
    uint32_t good = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const LargeMutant mutant = make_large_mutant(first + i);
        scratch.write("graph.json", mutant.text);
        const RunResult run = run_weft({"check", scratch / "graph.json"});
        EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 3)
            << "seed " << mutant.seed << ", " << mutant.how << ": " << run.text();
        EXPECT_LE(run.cpu_s, kMostInputCpu_s) << "seed " << mutant.seed << ", " << mutant.how;
        EXPECT_LE(run.max_rss_bytes, kMostInputMemory_bytes) << "seed " << mutant.seed << ", " << mutant.how;
        EXPECT_LE(run.err.size(), size_t{4} << 20) << "seed " << mutant.seed << ", " << mutant.how;
        good += run.exit_code == 0 ? 1 : 0;
        cpu_s.push_back(run.cpu_s);
        memory_bytes.push_back(run.max_rss_bytes);
    }
    if (count == 0) return;
    std::ranges::sort(cpu_s);
    std::ranges::sort(memory_bytes);
    std::printf(
        "seeds %u to %u: %u good; CPU median %.3f s, most %.3f s; memory median %.1f MiB, most %.1f MiB\n",
        first, first + count - 1, good, cpu_s[count / 2], cpu_s.back(),
        static_cast<double>(memory_bytes[count / 2]) / 1048576.0,
        static_cast<double>(memory_bytes.back()) / 1048576.0);
    EXPECT_GT(good, count / 100) << "the mutants are too wild to prove anything";
}

}  // namespace
}  // namespace weft::test
