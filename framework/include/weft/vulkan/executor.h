// Purpose: replays a FramePlan. It creates the transient heap, views, pipelines and descriptor sets of the
// plan, then records and submits exactly the plan's steps; it makes no decisions. Frames in flight:
// kFramesInFlight; all share one transient heap, ordered by the plan's barriers between consecutive frames.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "weft/imports.h"
#include "weft/pass.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/shader_interface.h"
#include "weft/transition.h"
#include "weft/vulkan/device.h"
#include "weft/vulkan/draw_source.h"
#include "weft/vulkan/frame_results.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

inline constexpr uint32_t kFramesInFlight = 2;

class PipelineStore;

// How many pipelines a plan draws and computes with, and how many of them were made for it.
struct PipelineCounts {
    uint32_t all = 0;
    uint32_t made = 0;
};

// Asks the device for the memory requirements that alias() needs. All objects created here are destroyed
// before it returns.
[[nodiscard]] MemoryNeeds query_memory_needs(Device& device, const ResolvedGraph& graph);

// The program's objects for a graph's imports.
struct ImportBindings {
    std::map<std::string, VkBuffer, std::less<>> buffers;
    std::map<std::string, const Image*, std::less<>> images;
};

struct FrameInput {
    uint64_t frame_index = 0;
    double time_s = 0;
    double delta_time_s = 0;
    float pre_exposure = 1;
    float prev_pre_exposure = 1;
    const HostInputs* host = nullptr;
};

// Test hooks. A dropped barrier must show up in validation and in the checker.
struct ExecutorHooks {
    uint32_t drop_barriers_of_position = kNoId;  // schedule position of a pass whose barriers are not
                                                 // recorded
};

struct ExecutorInput {
    FramePlan plan;
    const ShaderCatalog* shaders = nullptr;
    const PassCatalog* passes = nullptr;
    const ImportCatalog* imports = nullptr;
    ImportBindings bindings;
    const DrawSource* draws = nullptr;   // may be null if there is no raster pass
    PipelineStore* pipelines = nullptr;  // must outlive the executor; null: the executor creates one
    ExecutorHooks hooks;
    bool timestamps = true;  // false: only the plan is recorded, and all times are negative
};

class Executor;

// The executor that another one takes over from, after a resize, a reload or a swap.
struct Predecessor {
    std::vector<Image> images;           // imports that only its frames in flight still use
    TransitionPlan transition;           // from its plan to the new one's
    std::unique_ptr<Executor> executor;  // between frames; last: destroyed first
};

// New values and pipelines for a running plan.
class Amendment {
 public:
    virtual ~Amendment() = default;
    [[nodiscard]] virtual PipelineCounts pipelines() const = 0;
};

// create() and make_amendment() may run on any thread while another thread renders with another executor,
// because they submit nothing. All other functions must be called by the submitting thread.
class Executor {
 public:
    [[nodiscard]] static Result<std::unique_ptr<Executor>> create(Device& device, ExecutorInput input);
    virtual ~Executor() = default;

    // Requires that the plan has the structure_hash() of `input.plan`, and that the shaders have the same
    // bindings and Params. Uses only plan, shaders, imports, draws and pipelines of the input.
    [[nodiscard]] static Result<std::unique_ptr<Amendment>> make_amendment(Device& device,
                                                                           ExecutorInput input);
    // Takes effect with the next frame; call it between frames. Replaced objects live until frames in flight
    // have finished.
    virtual void amend(std::unique_ptr<Amendment> amendment) = 0;

    // Replaces the plan's prologue; call it before the first frame. That frame transfers the contents. The
    // predecessor lives until the frame has finished; its timings and readbacks are passed on. If both plans
    // have one queue, the host does not wait. Errors: those of begin_frame(); no further frame runs after an
    // error.
    [[nodiscard]] virtual Status take_over(Predecessor predecessor) = 0;

    // Waits until the next frame slot is free and returns it, so that the program can fill its per-slot data.
    // Errors: V407 time-out, V408 device lost; both name the passes in flight.
    [[nodiscard]] virtual Result<uint32_t> begin_frame() = 0;
    // Records and submits one frame in the slot of begin_frame().
    [[nodiscard]] virtual Status run(const FrameInput& frame) = 0;
    // Waits for all frames in flight (their fences, not the whole device), and collects their timings and
    // readbacks.
    [[nodiscard]] virtual Status finish() = 0;
    // Timings of completed frames, oldest first; each is returned once. At most the newest 32 are kept.
    [[nodiscard]] virtual std::vector<FrameTiming> take_timings() = 0;
    [[nodiscard]] virtual std::vector<ReadbackData> take_readbacks() = 0;
    // Copies an imported image to the host; its exit state must be transfer_src. Call this after finish().
    [[nodiscard]] virtual Result<ReadbackData> read_image(const Image& image) = 0;
    [[nodiscard]] virtual const FramePlan& plan() const = 0;
    [[nodiscard]] virtual PipelineCounts pipelines() const = 0;
    [[nodiscard]] virtual uint64_t transient_bytes() const = 0;
};

}  // namespace weft::vk
