// Purpose: replays a FramePlan. It makes the transient heap, views, pipelines and descriptor sets that the
// plan names, then records and submits exactly the plan's steps; it decides nothing. Frames in flight:
// kFramesInFlight; all share one transient heap, serialised by the plan's wrap-around hand-overs.
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
#include "weft/vulkan/memory.h"
#include "weft/vulkan/pipeline_store.h"

namespace weft::vk {

inline constexpr uint32_t kFramesInFlight = 2;

// What alias() needs to know about memory, from the device itself. Creates nothing that outlives the call.
[[nodiscard]] MemoryNeeds query_memory_needs(Device& device, const ResolvedGraph& graph);

// The program's objects behind a graph's imports.
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

struct PassTiming {
    std::string pass;
    double gpu_ms = 0;  // negative: the device has no timestamps
};

struct FrameTiming {
    std::vector<PassTiming> passes;
    double record_ms = 0;
    double submit_ms = 0;
    double wait_ms = 0;  // for the frame slot's fence
};

// What a readback pass delivered: tightly packed texels of one mip and layer after another, or a buffer's
// bytes.
struct ReadbackData {
    std::string pass;
    uint64_t frame_index = 0;
    Format format = Format::undefined;
    Extent3D extent;
    std::vector<std::byte> bytes;
};

// Test hooks. A dropped barrier must show up in validation and in the checker.
struct ExecutorHooks {
    uint32_t drop_barriers_of_position = kNoId;  // the barriers before the pass at this schedule position
};

struct ExecutorInput {
    FramePlan plan;
    const ShaderCatalog* shaders = nullptr;
    const PassCatalog* passes = nullptr;
    const ImportCatalog* imports = nullptr;
    ImportBindings bindings;
    const DrawSource* draws = nullptr;   // may be null when no pass is a raster pass
    PipelineStore* pipelines = nullptr;  // outlives the executor; null: one of its own
    ExecutorHooks hooks;
    bool timestamps = true;  // off: nothing but the plan is recorded, and all times are negative
};

class Executor;

// An executor that another one carries on from: after a resize, a reload or a swap.
struct Predecessor {
    std::vector<Image> images;           // imports that nobody uses but its frames in flight
    TransitionPlan transition;           // from its plan to the new one's
    std::unique_ptr<Executor> executor;  // between frames; last: destroyed first
};

// Values and pipelines in place of those of a running plan.
class Amendment {
 public:
    virtual ~Amendment() = default;
    [[nodiscard]] virtual PipelineCounts pipelines() const = 0;
};

// create() and make_amendment() may run on any thread, while another one draws with another executor: they
// submit nothing. All the rest is for the thread that submits.
class Executor {
 public:
    [[nodiscard]] static Result<std::unique_ptr<Executor>> create(Device& device, ExecutorInput input);
    virtual ~Executor() = default;

    // For an executor whose plan has the structure_hash() of `input.plan`, and whose shaders have the same
    // bindings and Params. Only plan, shaders, imports, draws and pipelines of the input count.
    [[nodiscard]] static Result<std::unique_ptr<Amendment>> make_amendment(Device& device,
                                                                           ExecutorInput input);
    // From the next frame on; between frames. What frames in flight use lives until they are over.
    virtual void amend(std::unique_ptr<Amendment> amendment) = 0;

    // Instead of the plan's prologue, before the first frame: contents move over in that frame, and the
    // predecessor, with its timings and readbacks handed on, lives until it is over. Nobody waits for it
    // where both plans have one queue. Errors: as begin_frame(); then nothing runs any more.
    [[nodiscard]] virtual Status take_over(Predecessor predecessor) = 0;

    // Waits until the next frame slot is free and returns it, so that the program may fill its per-slot data.
    // Errors: V407 time-out, V408 device lost; both name the passes in flight.
    [[nodiscard]] virtual Result<uint32_t> begin_frame() = 0;
    // Records and submits one frame into the slot of begin_frame().
    [[nodiscard]] virtual Status run(const FrameInput& frame) = 0;
    // Waits for all frames in flight (fences, not the device), delivering their timings and readbacks.
    [[nodiscard]] virtual Status finish() = 0;
    // Of completed frames, oldest first; each is returned once. Of timings the newest 32 are kept.
    [[nodiscard]] virtual std::vector<FrameTiming> take_timings() = 0;
    [[nodiscard]] virtual std::vector<ReadbackData> take_readbacks() = 0;
    // Copies an imported image (in its exit state, which must be transfer_src) to the host. Call after
    // finish().
    [[nodiscard]] virtual Result<ReadbackData> read_image(const Image& image) = 0;
    [[nodiscard]] virtual const FramePlan& plan() const = 0;
    [[nodiscard]] virtual PipelineCounts pipelines() const = 0;
    [[nodiscard]] virtual uint64_t transient_bytes() const = 0;
};

}  // namespace weft::vk
