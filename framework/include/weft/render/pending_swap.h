// Purpose: a graph that is ready to replace a session's running one: the same graph at another size, an
// edited graph, or another one. Session::prepare() makes it on any thread, Session::swap_in() takes it
// between two frames.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "weft/graph_request.h"
#include "weft/result.h"

namespace weft {
struct FramePlan;
}

namespace weft::render {

// What may change while a session runs.
struct Selection {
    GraphRequest request;
    // An embedder's image, made as output_create_info() says, that frames are drawn into; null: one of the
    // session's own. When render_frame() returns, commands submitted to the device's first queue find it in
    // TRANSFER_SRC_OPTIMAL, written, and may copy or blit it; they leave it so. It outlives the session.
    VkImage output = VK_NULL_HANDLE;
};

// What a swap makes anew.
struct Rebuilt {
    uint32_t shaders = 0, changed_shaders = 0;  // programs that the graph names
    uint32_t pipelines = 0, made_pipelines = 0;
    bool plan = false;    // memory, descriptors, barriers
    bool values = false;  // parameters, constants or state of a plan that is otherwise the same

    [[nodiscard]] bool nothing() const { return !plan && !values && changed_shaders == 0; }
};
// "1 of 4 shaders, 1 of 5 pipelines, a new plan".
[[nodiscard]] std::string to_text(const Rebuilt& rebuilt);

struct SwapParts;

// Move-only.
class PendingSwap {
 public:
    explicit PendingSwap(std::unique_ptr<SwapParts> parts);
    ~PendingSwap();
    PendingSwap(PendingSwap&& other) noexcept;
    PendingSwap& operator=(PendingSwap&& other) noexcept;

    [[nodiscard]] const Rebuilt& rebuilt() const;
    // The plan that a swap brings; null where the running plan stays, or changes its values only.
    [[nodiscard]] const FramePlan* new_plan() const;
    [[nodiscard]] SwapParts& parts() { return *parts_; }

 private:
    std::unique_ptr<SwapParts> parts_;
};

struct PrepareResult {
    Result<PendingSwap> result;
    Diagnostics warnings;
    // The files of the graph and its shaders that were looked for, absolute, present or not. After an error,
    // a change to one of them may fix it.
    std::set<std::filesystem::path> files;
};

}  // namespace weft::render
