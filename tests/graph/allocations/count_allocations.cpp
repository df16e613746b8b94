// Tests limits for the number of memory allocations in the compiler and the checker. Unlike a time, this
// number does not depend on the load of the machine. This file replaces operator new for its whole program,
// so these tests have their own program.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "graph/compile/bench_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace {
std::atomic<uint64_t> allocations = 0;
}

void* operator new(size_t bytes) {
    ++allocations;
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}

namespace weft::test {
namespace {

struct PerPass {
    double compile = 0, check = 0;
};

PerPass allocations_per_pass(BenchShape shape, uint32_t passes, uint32_t seed) {
    ResolvedGraph graph = make_bench_graph({passes, shape, seed});
    const MemoryNeeds needs = bench_needs(graph);
    const CompileOptions options{.keep_all_passes = true, .granularity_bytes = 1};
    const uint64_t before = allocations;
    const FramePlan plan = compile(std::move(graph), needs, options);
    const uint64_t compiled = allocations;
    EXPECT_TRUE(check_plan(plan).empty());
    const auto per_pass = [&](uint64_t count) { return static_cast<double>(count) / passes; };
    return {per_pass(compiled - before), per_pass(allocations - compiled)};
}

TEST(Allocations, AreFewForEveryPass) {
    for (const uint32_t seed : {1u, 2u, 3u}) {
        EXPECT_LE(allocations_per_pass(BenchShape::chain, 1000, seed).compile, 4) << "seed " << seed;
        EXPECT_LE(allocations_per_pass(BenchShape::window32, 1000, seed).compile, 5) << "seed " << seed;
        EXPECT_LE(allocations_per_pass(BenchShape::random, 1000, seed).compile, 5) << "seed " << seed;
    }
}

// If a stage allocated for each pair of passes, ten times as many passes would need ten times as many
// allocations per pass.
TEST(Allocations, DoNotGrowWithTheNumberOfPasses) {
    for (const BenchShape shape : {BenchShape::chain, BenchShape::window32, BenchShape::random}) {
        const PerPass few = allocations_per_pass(shape, 400, 1), many = allocations_per_pass(shape, 4000, 1);
        EXPECT_LE(many.compile, few.compile * 1.5) << bench_shape_name(shape);
        EXPECT_LE(many.check, few.check * 1.5) << bench_shape_name(shape);
        std::printf("%-9s compile %.2f and check %.2f allocations per pass\n", bench_shape_name(shape),
                    many.compile, many.check);
    }
}

}  // namespace
}  // namespace weft::test
