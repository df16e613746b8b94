// Purpose: what will take over from a session's running graph: the same graph for another size, an edited
// one, another one. Made by Session::prepare() on any thread, taken by Session::swap_in() between two frames.
// It is a whole stage (memory, descriptors, pipelines), or, where the plan has the same structure, only
// values and pipelines, or nothing at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "weft/load/load_graph.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

// What of a session's input may change while it runs.
struct Selection {
    std::string graph_path;
    std::string tier;  // of the graph; empty: the graph as it is
    std::map<std::string, double> params;
    Extent3D size;
    VkImage output = VK_NULL_HANDLE;  // as SessionInput::output
};

// What a swap made anew.
struct Rebuilt {
    uint32_t shaders = 0, changed_shaders = 0;  // programs that the graph names
    uint32_t pipelines = 0, made_pipelines = 0;
    bool plan = false;    // memory, descriptors, barriers
    bool values = false;  // parameters, constants or state of a plan that is otherwise the same

    [[nodiscard]] bool nothing() const { return !plan && !values && changed_shaders == 0; }
};
// "1 of 4 shaders, 1 of 5 pipelines, a new plan".
[[nodiscard]] std::string to_text(const Rebuilt& rebuilt);

// What one graph at one size runs on.
struct Stage {
    ImportCatalog imports;
    vk::Image output;
    std::unique_ptr<vk::Executor> executor;  // last: destroyed first
};

// What decides whether a stage can go on with other values and pipelines.
struct StageMark {
    struct Program {
        uint64_t content_hash = 0;
        std::vector<ShaderBinding> bindings;
        std::optional<ParamsBlock> params;
    };
    std::string plan_hash, structure_hash;
    std::map<std::string, Program, std::less<>> programs;  // by reference
    VkImage output = VK_NULL_HANDLE;
    uint64_t turn = 0;  // how many swaps there were before
};
[[nodiscard]] StageMark mark_of(const FramePlan& plan, const ShaderCatalog& shaders, VkImage output);
// Whether the programs differ in what no descriptor set or Params block sees, at most.
[[nodiscard]] bool same_bindings(const StageMark& a, const StageMark& b);
[[nodiscard]] uint32_t changed_programs(const StageMark& from, const StageMark& to);

struct Prepared {
    Selection selection;
    Rebuilt rebuilt;
    uint64_t follows = 0;  // StageMark::turn of what ran when this was made
    StageMark mark;
    std::optional<LoadedGraph> loaded;  // absent: the session's goes on
    std::optional<Stage> stage;
    std::unique_ptr<vk::Amendment> amendment;
};

// What came of preparing.
struct Preparation {
    Result<Prepared> result;
    Diagnostics warnings;
    // All that was looked at, absolute, there or not: what to wait for, above all after an error.
    std::set<std::filesystem::path> files;
};

}  // namespace weft::render
