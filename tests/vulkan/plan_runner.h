// Purpose: runs a plan on a device in a test: compiles its shaders, creates its imports and returns the data
// of the readback passes and of the imported buffers. If something fails, the failure is reported to gtest
// and the result is empty.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::vk {

// The shader programs of tests/graph/shaders/, by file name. Each program is compiled when a graph uses it
// for the first time.
class TestShaders {
 public:
    // Compiles the programs that `graph` needs and that are not compiled yet. Returns all programs compiled
    // so far.
    const ShaderCatalog& for_graph(const ResolvedGraph& graph);

 private:
    ShaderCatalog catalog_;
};

// Buffers and images for the imports of a plan. Their content depends only on their names and sizes.
class TestImports {
 public:
    TestImports(Device& device, const ResolvedGraph& graph);

    [[nodiscard]] ImportBindings bindings() const;
    // Reads back the imported buffers. No frame may be in flight during this call.
    [[nodiscard]] std::map<std::string, std::vector<std::byte>> buffer_contents() const;

 private:
    void make(const ResourceDecl& decl);

    Device* device_;
    std::map<std::string, Buffer, std::less<>> buffers_;
    std::map<std::string, Image, std::less<>> images_;
};

struct PlanResult {
    std::vector<ReadbackData> readbacks;  // Results of all readback passes, in the order of the frames.
    // Content of each imported buffer after the last frame.
    std::map<std::string, std::vector<std::byte>> imports;
};

struct RunOptions {
    uint32_t frames = 2;
    ExecutorHooks hooks;
    bool timestamps = true;
};

[[nodiscard]] PlanResult run_plan(Device& device, const FramePlan& plan, TestShaders& shaders,
                                  const RunOptions& options = {});

}  // namespace weft::vk
