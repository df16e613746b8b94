// Purpose: renders one scene with one graph: loads, compiles, checks and runs it. It is the simplest way to
// embed Weft; `weft render` and the picture tests use it. Units: size in pixels. Threads: prepare() may run
// on any thread, all other functions on the thread that submits.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "weft/load/load_graph.h"
#include "weft/render/frame_input.h"
#include "weft/render/pending_swap.h"
#include "weft/result.h"
#include "weft/vulkan/frame_results.h"

namespace weft::scene {
struct Scene;
}
namespace weft::vk {
class Device;
}

namespace weft::render {

// Create info for the image of Selection::output: RGBA8, one mip. Contains pointers to data of `device`.
[[nodiscard]] VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size);

struct SessionInput {
    GraphRequest request;
    LoadSettings load;
    const PassCatalog* passes = nullptr;
    const ParsedGraph* parsed = nullptr;  // the request's graph; null: create() parses it
    VkImage output = VK_NULL_HANDLE;      // as Selection::output
    uint32_t queues = 1;                  // logical queues; the device must have been created with at least
                                          // as many
    bool check_plan = false;              // check the plan before it runs; debug builds always do
    bool timestamps = false;  // per-pass GPU times; adds execution barriers, so not for validation runs
    std::string drop_barriers_before;  // test hook: a pass whose barriers are not recorded
};

struct SessionParts;

class Session {
 public:
    // Errors: those of load_graph (W…), of the checker (C…), of the device (V…). `files`, if not null,
    // receives the content of PrepareResult::files, also after an error.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    // For a scene that is not used afterwards: create() frees each texture after it is copied to the GPU.
    // That halves the peak memory of textures.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, scene::Scene&& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const Selection& selection() const;
    // The files that create() searched, as PrepareResult::files.
    [[nodiscard]] const std::set<std::filesystem::path>& first_files() const;
    // Reads the selected graph, compiles changed parts, checks the plan and makes its objects, while frames
    // are rendered. May be called from any thread, and submits nothing. Errors: as create().
    [[nodiscard]] PrepareResult prepare(const Selection& selection);
    // Takes effect with the next frame. Histories and kept resources continue as given by transition().
    // Returns false, and does nothing, if another swap was made since `next` was prepared; prepare again.
    // After an error of the checker (C…) the running graph continues.
    [[nodiscard]] Result<bool> swap_in(PendingSwap next);
    // Prepares and swaps in the loaded graph at another size. After an error of the graph (W…, C…) or of
    // memory, the running graph continues at the old size. `output` replaces Selection::output, whose image
    // frames in flight may still use. Errors: as create().
    [[nodiscard]] Status resize(Extent3D size, Diagnostics& warnings, VkImage output = VK_NULL_HANDLE);
    // The number of pipelines made since create(), by the thread that called it.
    [[nodiscard]] uint64_t pipelines_made_between_frames() const;

    [[nodiscard]] Status render_frame(const FrameInput& input);
    [[nodiscard]] Status finish();
    // True if the graph writes an output: some graphs only write resources.
    [[nodiscard]] bool has_output() const;
    // The output image of the last frame; call it after finish(). W184: the graph has no output.
    [[nodiscard]] Result<vk::ReadbackData> read_output();
    [[nodiscard]] std::vector<vk::ReadbackData> take_readbacks();
    [[nodiscard]] std::vector<vk::FrameTiming> take_timings();
    [[nodiscard]] const FramePlan& plan() const;
    // The number of frames in the graph file.
    [[nodiscard]] uint32_t frames() const;
    // 2^EV of the last frame.
    [[nodiscard]] float pre_exposure() const;

    // For tests, which include render/session_parts.h.
    [[nodiscard]] const SessionParts& parts() const { return *parts_; }

 private:
    explicit Session(std::unique_ptr<SessionParts> parts);
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, scene::Scene* owned, const SessionInput& input,
        Diagnostics& warnings, std::set<std::filesystem::path>* files);

    std::unique_ptr<SessionParts> parts_;
};

}  // namespace weft::render
