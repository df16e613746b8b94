// Purpose: runs plans on a device for tests: compiles their shaders, creates their imports and reads back all
// results. A failure is reported to gtest, and the result is empty.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::vk {

// Programs of tests/graph/shaders/, by file name; each is compiled on first use.
class TestShaders {
 public:
    // Adds the programs that `graph` needs and returns all programs.
    const ShaderCatalog& for_graph(const ResolvedGraph& graph);

 private:
    ShaderCatalog catalog_;
};

// Objects for a plan's imports, filled with numbers that depend only on their names.
class TestImports {
 public:
    TestImports(Device& device, const ResolvedGraph& graph);

    [[nodiscard]] ImportBindings bindings() const;
    // Call this when no frame is in flight.
    [[nodiscard]] std::map<std::string, std::vector<std::byte>> buffer_contents() const;

 private:
    void make(const ResourceDecl& decl);

    Device* device_;
    std::map<std::string, Buffer, std::less<>> buffers_;
    std::map<std::string, Image, std::less<>> images_;
};

struct PlanResult {
    std::vector<ReadbackData> readbacks;                    // in the order of frames
    std::map<std::string, std::vector<std::byte>> imports;  // content of the buffers after the last frame
};

struct RunOptions {
    uint32_t frames = 2;
    ExecutorHooks hooks;
    bool timestamps = true;
};

[[nodiscard]] PlanResult run_plan(Device& device, const FramePlan& plan, TestShaders& shaders,
                                  const RunOptions& options = {});

}  // namespace weft::vk
