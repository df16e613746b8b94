// Resolves the graph files that `weft bench compile` reads, and compares the results with the generated
// graphs.
#include "viewer/bench/bench_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graph/compile/bench_graph.h"
#include "graph/parse/parse.h"
#include "graph/resolve/resolve.h"
#include "graph/syntax/merge.h"
#include "graph/syntax/read_graph.h"

namespace weft::test {
namespace {

Result<ResolvedGraph> resolve_text(const std::string& text) {
    const FileReader reader = [&text](const std::string&) { return std::optional(text); };
    Result<JsonDoc> document = read_graph("bench.json", reader);
    if (!document) return document.take_errors();
    const Result<JsonDoc> merged = merge(std::move(document).value());
    if (!merged) return merged.errors();
    const Result<GraphDesc> desc = parse(*merged);
    if (!desc) return desc.errors();
    const PassCatalog no_passes;
    const ImportCatalog no_imports;
    const ShaderCatalog shaders = viewer::bench_shaders();
    const DeviceProfile profile = viewer::bench_profile();
    const GraphLimits limits = viewer::bench_limits();
    Diagnostics warnings;
    return resolve({.graph = *desc,
                    .passes = no_passes,
                    .shaders = shaders,
                    .imports = no_imports,
                    .profile = profile,
                    .request = {},
                    .limits = limits},
                   warnings);
}

std::vector<std::pair<PassId, PassId>> sorted_edges(const ResolvedGraph& graph) {
    std::vector<std::pair<PassId, PassId>> edges;
    for (const EdgeDecl& edge : graph.edges) edges.emplace_back(edge.from, edge.to);
    std::ranges::sort(edges);
    return edges;
}

TEST(BenchFile, DescribesTheGeneratedGraph) {
    for (const BenchShape shape : {BenchShape::chain, BenchShape::window32, BenchShape::random}) {
        SCOPED_TRACE(bench_shape_name(shape));
        const ResolvedGraph wanted = make_bench_graph({200, shape, 3});
        const Result<ResolvedGraph> found = resolve_text(viewer::bench_file_text(wanted));
        ASSERT_TRUE(found) << to_text(found.errors());
        ASSERT_EQ(found->resources.size(), wanted.resources.size());
        ASSERT_EQ(found->passes.size(), wanted.passes.size());
        EXPECT_EQ(sorted_edges(*found), sorted_edges(wanted));
        for (ResourceId id(0); id < wanted.resources.size(); ++id) {
            EXPECT_EQ(found->resources[id].name, wanted.resources[id].name);
            EXPECT_EQ(found->resources[id].extent, wanted.resources[id].extent);
            EXPECT_EQ(found->resources[id].format, wanted.resources[id].format);
        }
        for (PassId id(0); id < wanted.passes.size(); ++id) {
            const std::vector<UseDecl>&a = found->passes[id].uses, &b = wanted.passes[id].uses;
            EXPECT_EQ(found->passes[id].name, wanted.passes[id].name);
            ASSERT_EQ(a.size(), b.size());
            for (size_t i = 0; i < a.size(); ++i) {
                EXPECT_EQ(a[i].resource, b[i].resource);
                EXPECT_EQ(a[i].access, b[i].access);
                EXPECT_EQ(a[i].port, b[i].port);
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
