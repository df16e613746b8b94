// Purpose: the objects that render one graph at one size, and a fingerprint of them. Comparing fingerprints
// shows which objects a new plan can use again.
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

// Debug builds check every plan before it runs.
#ifdef NDEBUG
inline constexpr bool kAlwaysCheck = false;
#else
inline constexpr bool kAlwaysCheck = true;
#endif

struct RenderStage {
    vk::Image output;
    // Declared last, so that the executor is destroyed before the image that it writes.
    std::unique_ptr<vk::Executor> executor;
};

struct StageFingerprint {
    struct Program {
        uint64_t content_hash = 0;
        std::vector<ShaderBinding> bindings;
        std::optional<ParamsBlock> params;
    };
    std::string plan_hash, structure_hash;
    // The shader programs of the graph, by the reference that the graph uses for them.
    std::map<std::string, Program, std::less<>> programs;
    VkImage output = VK_NULL_HANDLE;
    // Number of swaps that the running graph had when this stage was put in place, so that a swap that was
    // prepared for an older stage is noticed. 0: no stage runs yet.
    uint64_t generation = 0;
};
[[nodiscard]] StageFingerprint take_fingerprint(const FramePlan& plan, const ShaderCatalog& shaders,
                                                VkImage output);
// True if the stage with fingerprint `from` can run the plan of `to` with only its values and pipelines
// replaced.
[[nodiscard]] bool can_amend(const StageFingerprint& from, const StageFingerprint& to);
[[nodiscard]] uint32_t count_changed_programs(const StageFingerprint& from, const StageFingerprint& to);

}  // namespace weft::render
