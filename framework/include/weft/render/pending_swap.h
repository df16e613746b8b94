// Purpose: a prepared graph that can replace the running graph of a session: the same graph at another size,
// an edited graph, or a different one. Session::prepare() makes it on any thread. Session::swap_in() makes it
// the running graph, between two frames.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "weft/graph_request.h"
#include "weft/render/own_imports.h"
#include "weft/result.h"

namespace weft {
struct FramePlan;
}

namespace weft::render {

// Selects the graph that a session renders. The selection may change while the session runs.
struct Selection {
    GraphRequest request;
    // An embedder's image to which frames are rendered, created with output_create_info(). Null: the
    // session's own image is used. After render_frame(), commands that are submitted to the device's first
    // queue find the image written, in the layout GraphRequest::output.final_layout. They may use it as
    // OutputFormat says, and must leave it in this layout. The image must outlive the session.
    VkImage output = VK_NULL_HANDLE;
    // The Vulkan objects of the program's own imports; see SessionInput::imports. To exchange an object,
    // change it here. If the new object has another size, also change GraphRequest::import_sizes.
    ImportObjects imports = {};
};

// Tells which parts of a graph were compiled or created again for a swap.
struct Rebuilt {
    // Number of shader programs of the graph, and number of those that changed.
    uint32_t shaders = 0, changed_shaders = 0;
    uint32_t pipelines = 0, made_pipelines = 0;
    bool plan = false;  // True: there is a new plan, with new memory, descriptors and barriers.
    // True: the plan stays the same, except for values of parameters or constants, or the state of pipelines.
    bool values = false;

    [[nodiscard]] bool nothing() const { return !plan && !values && changed_shaders == 0; }
};
// Returns a text such as "1 of 4 shaders, 1 of 5 pipelines, a new plan".
[[nodiscard]] std::string to_text(const Rebuilt& rebuilt);

struct SwapParts;

class PendingSwap {
 public:
    explicit PendingSwap(std::unique_ptr<SwapParts> parts);
    ~PendingSwap();
    PendingSwap(PendingSwap&& other) noexcept;
    PendingSwap& operator=(PendingSwap&& other) noexcept;

    [[nodiscard]] const Rebuilt& rebuilt() const;
    // Returns the new plan; null if Rebuilt::plan is false.
    [[nodiscard]] const FramePlan* new_plan() const;
    [[nodiscard]] SwapParts& parts() { return *parts_; }

 private:
    std::unique_ptr<SwapParts> parts_;
};

struct PrepareResult {
    Result<PendingSwap> result;
    Diagnostics warnings;
    // Absolute paths of all files of the graph and its shaders that were searched, including files that do
    // not exist. After an error, a change of one of these files may correct it.
    std::set<std::filesystem::path> files;
};

}  // namespace weft::render
