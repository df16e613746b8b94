// Purpose: generates graphs of any size for benchmarks. The graphs are simple, so that other frameworks can
// measure the same graphs. Every pass writes one rgba8 image and reads the images of two earlier passes; the
// first two passes read fewer. The graphs are generated with std::mt19937, so a seed gives the same graph on
// every platform. An image takes exactly 4·width·height bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "weft/plan.h"

namespace weft {

// The earlier passes that each pass reads. `chain`: the last two. `window32`: two random ones of the last 32.
// `random`: two random ones of all earlier passes.
enum class BenchShape : uint8_t { chain, window32, random };
[[nodiscard]] std::optional<BenchShape> bench_shape(std::string_view name);
[[nodiscard]] const char* bench_shape_name(BenchShape shape);

struct BenchGraph {
    uint32_t passes = 1000;
    BenchShape shape = BenchShape::random;
    uint32_t seed = 1;
};

[[nodiscard]] ResolvedGraph make_bench_graph(const BenchGraph& bench);
[[nodiscard]] MemoryNeeds bench_needs(const ResolvedGraph& graph);

}  // namespace weft
