// Purpose: the objects of one graph at one size, and a fingerprint of them, which determines the objects that
// a new plan can use again.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "weft/plan.h"
#include "weft/shader_interface.h"
#include "weft/vulkan/executor.h"
#include "weft/vulkan/memory.h"

namespace weft::render {

// Debug builds check every plan.
#ifdef NDEBUG
inline constexpr bool kAlwaysCheck = false;
#else
inline constexpr bool kAlwaysCheck = true;
#endif

struct RenderStage {
    vk::Image output;
    std::unique_ptr<vk::Executor> executor;  // last: destroyed first
};

struct StageFingerprint {
    struct Program {
        uint64_t content_hash = 0;
        std::vector<ShaderBinding> bindings;
        std::optional<ParamsBlock> params;
    };
    std::string plan_hash, structure_hash;
    std::map<std::string, Program, std::less<>> programs;  // by reference
    VkImage output = VK_NULL_HANDLE;
    uint64_t generation = 0;  // of the running graph: each swap adds one
};
[[nodiscard]] StageFingerprint take_fingerprint(const FramePlan& plan, const ShaderCatalog& shaders,
                                                VkImage output);
// True if a stage with fingerprint `from` can run the plan of `to` with other values and pipelines.
[[nodiscard]] bool can_amend(const StageFingerprint& from, const StageFingerprint& to);
[[nodiscard]] uint32_t count_changed_programs(const StageFingerprint& from, const StageFingerprint& to);

}  // namespace weft::render
