// Purpose: runs a FramePlan on Vulkan. The executor creates the memory, views, pipelines and descriptor sets
// of the plan. For each frame it records and submits exactly the steps of the plan; it makes no decisions. Up
// to kFramesInFlight frames are in flight. All of them use the same memory for transient resources: the
// plan's barriers between consecutive frames order their accesses.
#pragma once

#include <array>
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
#include "weft/vulkan/frame_submit.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

inline constexpr uint32_t kFramesInFlight = 2;

class PipelineStore;
class SharedStore;

// Numbers of pipelines: `all` is the number that a plan uses, `made` the number that was created for this
// plan. All other pipelines existed before.
struct PipelineCounts {
    uint32_t all = 0;
    uint32_t made = 0;
};

// Asks the device for the memory requirements of all resources, which compile() needs to place them in
// memory. Objects that are created for the queries are destroyed before the function returns.
[[nodiscard]] MemoryNeeds query_memory_needs(Device& device, const ResolvedGraph& graph);

// The program's Vulkan objects for the imports of a graph, by the names of the imports.
struct ImportBindings {
    std::map<std::string, VkBuffer, std::less<>> buffers;
    // Imports for which each frame slot has its own buffer, so that the program can write the buffer of the
    // next frame while the GPU reads the buffer of the last frame. Index: the slot that begin_frame()
    // returned.
    std::map<std::string, std::array<VkBuffer, kFramesInFlight>, std::less<>> slot_buffers = {};
    std::map<std::string, const Image*, std::less<>> images;
    // The tables of textures: for each texture, a view of type VK_IMAGE_VIEW_TYPE_2D. While frames run, the
    // images are in the layout VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL. The views must outlive the executor.
    std::map<std::string, std::vector<VkImageView>, std::less<>> textures = {};
};

struct FrameInput {
    uint64_t frame_index = 0;
    double time_s = 0;
    double delta_time_s = 0;
    float pre_exposure = 1;
    float prev_pre_exposure = 1;
    // True: shaders see no history: `<port>Valid` is 0 for each port that reads an earlier frame.
    bool hides_history = false;
    // True: the frame only prepares the results of units. A unit is a set of passes that run together or not
    // at all: passes with `rest`, or one round of a group. Other passes run only if units need them, directly
    // or through other passes.
    bool prepares_units = false;
    const HostInputs* host = nullptr;
    // Versions of the contents of imported buffers and images, by name. Give an import a new number whenever
    // its content changes. A pass with `rest` is skipped while its inputs stay the same. If it reads an
    // import without a version, it runs in every frame.
    std::map<std::string, uint64_t, std::less<>> import_versions = {};
    // For each import of kind "turns": the numbers of the rounds of its group that run in this frame, in this
    // order. A round is one copy of all passes of the group. Without a list, the rounds of a group take
    // turns.
    std::map<std::string, std::vector<uint32_t>, std::less<>> turns = {};
    // Scales of live sizes (the used areas of images, which may change in every frame), by the name of the
    // parameter. A scale outside of the range of its parameter is clamped. A scale that is not in the map has
    // the value of its parameter.
    Scales scales = {};
    // Switches by the name of their parameter: true is on. A switch without an entry has the value of its
    // parameter. Names that are no switches are ignored. Null: no entries.
    const std::map<std::string, bool, std::less<>>* switches = nullptr;
    FrameSubmit submit = {};
};

// Hooks for tests: they omit barriers, so that a test can check that the validation layer reports the missing
// barriers.
struct ExecutorHooks {
    // Schedule position of a pass whose barriers are not recorded; kNoId: all barriers are recorded.
    uint32_t drop_barriers_of_position = kNoId;
};

struct ExecutorInput {
    FramePlan plan;
    const ShaderCatalog* shaders = nullptr;
    const PassCatalog* passes = nullptr;
    const ImportCatalog* imports = nullptr;
    ImportBindings bindings;
    const DrawSource* draws = nullptr;  // May be null if the plan has no raster pass.
    // The store of pipelines that executors share. It must outlive the executor. Null: the executor creates
    // its own store.
    PipelineStore* pipelines = nullptr;
    // The store of resources with `"keep": "shared"`. Executors that follow each other must have the same
    // store, which must outlive them. Null: the executor creates its own store, and cannot share memory.
    SharedStore* shared = nullptr;
    ExecutorHooks hooks;
    // True: GPU times of passes are measured. False: only the commands of the plan are recorded, and every
    // PassTiming::gpu_ms is negative.
    bool timestamps = true;
};

// The Vulkan objects of a resource that a plan has placed in memory. One of `image` and `buffer` is null.
struct NativeResource {
    VkImage image = VK_NULL_HANDLE;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    uint64_t offset_bytes = 0;
    bool operator==(const NativeResource&) const = default;
};

class Executor;

// The old executor that a new executor replaces, after a resize, a reload or a swap of graphs.
struct Predecessor {
    std::vector<Image> images;  // Imported images that only frames in flight of the old executor still use.
    TransitionPlan transition;  // The transition from the old executor's plan to the new plan.
    // The old executor. Each of its begin_frame() calls must have been followed by run(). It is the last
    // member, so that it is destroyed before `images`.
    std::unique_ptr<Executor> executor;
};

// New values for the plan of a running executor, with or without new pipelines.
class Amendment {
 public:
    virtual ~Amendment() = default;
    // Returns the numbers of pipelines, as in PipelineCounts; both are 0 if the amendment has only values.
    [[nodiscard]] virtual PipelineCounts pipelines() const = 0;
};

// Threads: create() and make_amendment() may run on any thread, even while another thread renders with
// another executor, because they submit nothing. All other functions must be called by the thread that
// submits.
class Executor {
 public:
    [[nodiscard]] static Result<std::unique_ptr<Executor>> create(Device& device, ExecutorInput input);
    virtual ~Executor() = default;

    // Prepares new values and pipelines for the running plan. `input.plan` must have the same
    // structure_hash() as the running plan, and the shaders must have the same bindings and Params. Only
    // plan, shaders, imports, draws and pipelines of `input` are used.
    [[nodiscard]] static Result<std::unique_ptr<Amendment>> make_amendment(Device& device,
                                                                           ExecutorInput input);
    // Prepares new values for the running plan, and leaves its pipelines as they are. `graph` may differ from
    // the graph of the running plan in values of ParamWrite, custom_params and parameters, and in
    // PassDecl::flops.
    [[nodiscard]] static std::unique_ptr<Amendment> make_amendment(ResolvedGraph graph);
    // Makes an amendment the current one, from the next frame on. Call this between two frames. The replaced
    // objects live until the frames in flight have finished.
    virtual void amend(std::unique_ptr<Amendment> amendment) = 0;

    // Takes over from an old executor. Call this before the first frame of the new executor. That frame
    // copies the contents of persistent resources from the old plan, and does not run the prologue. The old
    // executor lives until that frame has finished, and passes on its timings and readbacks. If each of the
    // two plans has only one batch (one submission per frame), the host does not wait. Errors: those of
    // begin_frame(). After an error no further frame runs.
    [[nodiscard]] virtual Status take_over(Predecessor predecessor) = 0;

    // Waits until the next frame slot is free and returns its index, so that the program can fill its own
    // data for this slot. Errors: V407 time-out, V408 device lost; both messages name the passes in flight.
    [[nodiscard]] virtual Result<uint32_t> begin_frame() = 0;
    // Records and submits one frame in the slot that begin_frame() returned. If FrameSubmit::commands is not
    // null, it only records the frame. Errors: V422 and V423, `submit` asks for something that is not
    // possible, and nothing is recorded; V418, recording or submitting failed.
    [[nodiscard]] virtual Status run(const FrameInput& frame) = 0;
    // Waits for the fences of all frames in flight, and collects the timings and readbacks of these frames.
    // It does not wait for other work on the device.
    [[nodiscard]] virtual Status finish() = 0;
    // Returns the timings of completed frames, oldest first. Each timing is returned once. Only the newest 32
    // are kept.
    [[nodiscard]] virtual std::vector<FrameTiming> take_timings() = 0;
    // Returns the data that completed frames have read back. Each item is returned once.
    [[nodiscard]] virtual std::vector<ReadbackData> take_readbacks() = 0;
    // Copies an imported image to host memory. The exit state of the import must be transfer_src. Call this
    // after finish().
    [[nodiscard]] virtual Result<ReadbackData> read_image(const Image& image) = 0;
    [[nodiscard]] virtual const FramePlan& plan() const = 0;
    [[nodiscard]] virtual PipelineCounts pipelines() const = 0;
    [[nodiscard]] virtual uint64_t transient_bytes() const = 0;
    // Returns the Vulkan objects of a resource of the plan. All handles are null if the plan has not placed
    // the resource in memory. For a resource with history, they are those of one fixed copy.
    [[nodiscard]] virtual NativeResource native(ResourceId resource) const = 0;
    // Returns the resource in whose memory the last frame had the content of `resource`. This is `resource`
    // itself, unless it belongs to a ring of copies that rotate (ResourceDecl::history).
    [[nodiscard]] virtual ResourceId last_copy(ResourceId resource) const = 0;
};

}  // namespace weft::vk
