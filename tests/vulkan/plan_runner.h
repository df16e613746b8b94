// Purpose: runs plans on a device for tests: compiles their shaders, makes their imports and reads all of
// their results. Failures are gtest failures, and what is returned is then empty.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::vk {

// Programs of tests/graph/shaders/, by file name, each compiled when it is first asked for.
class TestShaders {
 public:
    // Adds what `graph` needs and returns the whole catalogue.
    const ShaderCatalog& for_graph(const ResolvedGraph& graph);

 private:
    ShaderCatalog catalog_;
};

// A plan's imports as objects of the test's own, filled with numbers that depend on their names only.
class TestImports {
 public:
    TestImports(Device& device, const ResolvedGraph& graph);

    [[nodiscard]] ImportBindings bindings() const;
    // Call when nothing is in flight any more.
    [[nodiscard]] std::map<std::string, std::vector<std::byte>> buffer_contents() const;

 private:
    void make(const ResourceDecl& decl);

    Device* device_;
    std::map<std::string, Buffer, std::less<>> buffers_;
    std::map<std::string, Image, std::less<>> images_;
};

struct PlanResult {
    std::vector<ReadbackData> readbacks;                    // in the order of frames
    std::map<std::string, std::vector<std::byte>> imports;  // the buffers, after the last frame
};

struct RunOptions {
    uint32_t frames = 2;
    ExecutorHooks hooks;
    bool timestamps = true;
};

[[nodiscard]] PlanResult run_plan(Device& device, const FramePlan& plan, TestShaders& shaders,
                                  const RunOptions& options = {});

}  // namespace weft::vk
