// Purpose: one graph draws one scene: load, compile, prove, run. The shortest way to embed Weft, and what
// `weft render` and the picture tests use. Units: size in pixels. Threads: prepare() may run on any thread,
// all else runs on the thread that submits.
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

// How to make an image for Selection::output: RGBA8, of one mip. Points into `device`.
[[nodiscard]] VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size);

struct SessionInput {
    GraphRequest request;
    LoadSettings load;
    const PassCatalog* passes = nullptr;
    const ParsedGraph* parsed = nullptr;  // the request's graph; null: create() parses it
    VkImage output = VK_NULL_HANDLE;      // as Selection::output
    uint32_t queues = 1;                  // logical queues; the device must have been made for as many
    bool check_plan = false;              // prove the plan before it runs; debug builds always do
    bool timestamps = false;  // per-pass GPU times; adds execution barriers, so not for validation runs
    std::string drop_barriers_before;  // test hook: a pass whose barriers are not recorded
};

struct SessionParts;

class Session {
 public:
    // Errors: those of load_graph (W…), of the checker (C…), of the device (V…). `files`, if given, receives
    // what PrepareResult::files would hold, after an error as well.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    // For a scene that is not used any more: create() frees each texture when it is copied to the GPU. That
    // halves the memory that textures take at most.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, scene::Scene&& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const Selection& selection() const;
    // The files that create() looked for, as PrepareResult::files.
    [[nodiscard]] const std::set<std::filesystem::path>& first_files() const;
    // Reads the selected graph, compiles what changed, proves the plan and makes its objects, while frames go
    // on. May be called from any thread, and submits nothing. Errors: as create().
    [[nodiscard]] PrepareResult prepare(const Selection& selection);
    // From the next frame on. Histories and kept resources live on, as transition() says. False: another swap
    // came in between, and nothing happens; prepare again. After an error of the checker (C…) the running
    // graph goes on.
    [[nodiscard]] Result<bool> swap_in(PendingSwap next);
    // Prepares and swaps in the loaded graph at another size. After an error that names the graph (W…, C…) or
    // memory the running graph goes on at the old size. `output` replaces Selection::output, whose image
    // frames in flight may still use. Errors: as create().
    [[nodiscard]] Status resize(Extent3D size, Diagnostics& warnings, VkImage output = VK_NULL_HANDLE);
    // How many pipelines were made by the thread that called create(), since then.
    [[nodiscard]] uint64_t pipelines_made_between_frames() const;

    [[nodiscard]] Status render_frame(const FrameInput& input);
    [[nodiscard]] Status finish();
    // Whether the graph writes an output: a graph may only deliver resources.
    [[nodiscard]] bool has_output() const;
    // The output image of the last frame; call after finish(). W184: there is none.
    [[nodiscard]] Result<vk::ReadbackData> read_output();
    [[nodiscard]] std::vector<vk::ReadbackData> take_readbacks();
    [[nodiscard]] std::vector<vk::FrameTiming> take_timings();
    [[nodiscard]] const FramePlan& plan() const;
    // How many frames the graph asks for.
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
