// Purpose: a prepared graph that can replace a session's running one: the same graph at another size, an
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

// Selects the graph that a session renders; may change while it runs.
struct Selection {
    GraphRequest request;
    // An embedder's image to which frames are rendered, created with output_create_info(); null: the
    // session's own image. When render_frame() returns, commands submitted to the device's first queue see it
    // written and in TRANSFER_SRC_OPTIMAL. They may copy or blit it, and must leave it in that layout. It
    // must outlive the session.
    VkImage output = VK_NULL_HANDLE;
};

// The parts that a swap compiled or created.
struct Rebuilt {
    uint32_t shaders = 0, changed_shaders = 0;  // programs that the graph names
    uint32_t pipelines = 0, made_pipelines = 0;
    bool plan = false;    // memory, descriptors, barriers
    bool values = false;  // parameters, constants or state of an otherwise equal plan

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
    // The plan of the swap; null if the running plan stays, or changes only its values.
    [[nodiscard]] const FramePlan* new_plan() const;
    [[nodiscard]] SwapParts& parts() { return *parts_; }

 private:
    std::unique_ptr<SwapParts> parts_;
};

struct PrepareResult {
    Result<PendingSwap> result;
    Diagnostics warnings;
    // The files of the graph and its shaders that were searched, absolute, existing or not. After an error, a
    // change of one of them may correct it.
    std::set<std::filesystem::path> files;
};

}  // namespace weft::render
