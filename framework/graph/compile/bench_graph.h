// Purpose: graphs of any size whose figures compare with other frameworks': every pass writes one rgba8 image
// and reads two earlier ones. Drawn from std::mt19937, so that a seed gives the same graph everywhere. Units:
// an image takes exactly 4·width·height bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "weft/plan.h"

namespace weft {

// Which earlier passes one reads: the last two; two of the last 32; two of all.
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
