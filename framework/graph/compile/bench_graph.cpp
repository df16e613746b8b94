#include "graph/compile/bench_graph.h"

#include <array>
#include <cstdio>
#include <random>
#include <string>
#include <utility>

namespace weft {
namespace {

constexpr std::array kShapeNames{"chain", "window32", "random"};
constexpr uint32_t kWindow = 32;

// Returns the name with a number of 7 digits, so that names sort in the order of their numbers.
std::string numbered(const char* what, uint32_t number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%s%07u", what, number);
    return text.data();
}

UseDecl use_of(const char* port, ResourceId image, Access access) {
    UseDecl use;
    use.port = port;
    use.resource = image;
    use.access = access;
    use.state = access_state(access, stage_bit(ShaderStage::compute), aspect::kColor);
    use.is_output = writes(access);
    // Pass i writes image i, so the index of an image is also the index of the pass that wrote it.
    if (reads(access)) use.sources = {{use.range, PassId(uint32_t{image})}};
    return use;
}

// Returns the passes whose images pass `i` reads: two, or fewer for the first two passes.
std::vector<uint32_t> producers(std::mt19937& random, BenchShape shape, uint32_t i) {
    if (i == 0) return {};
    if (i == 1) return {0};
    if (shape == BenchShape::chain) return {i - 1, i - 2};
    const uint32_t low = shape == BenchShape::window32 && i > kWindow ? i - kWindow : 0;
    const auto draw = [&] { return low + static_cast<uint32_t>(random() % (i - low)); };
    const uint32_t a = draw();
    uint32_t b = draw();
    while (b == a) b = draw();
    return {a, b};
}

}  // namespace

std::optional<BenchShape> bench_shape(std::string_view name) {
    for (size_t i = 0; i < kShapeNames.size(); ++i)
        if (name == kShapeNames[i]) return static_cast<BenchShape>(i);
    return {};
}

const char* bench_shape_name(BenchShape shape) {
    return kShapeNames[static_cast<size_t>(shape)];
}

ResolvedGraph make_bench_graph(const BenchGraph& bench) {
    constexpr std::array<std::pair<uint32_t, uint32_t>, 6> kSizes{
        {{3840, 2160}, {1920, 1080}, {1920, 1080}, {960, 540}, {480, 270}, {2048, 2048}}};
    constexpr std::array kPorts{"a", "b"};
    std::mt19937 random(bench.seed);
    ResolvedGraph graph;
    graph.name = bench_shape_name(bench.shape);
    for (uint32_t i = 0; i < bench.passes; ++i) {
        const auto [width, height] = kSizes[random() % kSizes.size()];
        ResourceDecl image;
        image.name = numbered("image", i);
        image.format = Format::rgba8;
        image.extent = {width, height, 1};
        image.usage = usage::kSampled | usage::kStorage;
        graph.resources.push_back(std::move(image));
        PassDecl pass;
        pass.name = numbered("pass", i);
        pass.type = "compute";
        pass.order_key = i;
        const std::vector<uint32_t> read = producers(random, bench.shape, i);
        for (size_t port = 0; port < read.size(); ++port) {
            pass.uses.push_back(use_of(kPorts[port], ResourceId(read[port]), Access::sampled_read));
            graph.edges.push_back({PassId(read[port]), PassId(i), EdgeKind::raw, ResourceId(read[port]), {}});
        }
        pass.uses.push_back(use_of("dst", ResourceId(i), Access::storage_write));
        graph.passes.push_back(std::move(pass));
    }
    return graph;
}

MemoryNeeds bench_needs(const ResolvedGraph& graph) {
    MemoryNeeds needs;
    for (const ResourceDecl& image : graph.resources) needs.push_back({content_bytes(image), 1, UINT32_MAX});
    return needs;
}

}  // namespace weft
