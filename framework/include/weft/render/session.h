// Purpose: renders one scene with one graph: load, compile, check, run. `weft render` and the picture tests
// use it, and it is the simplest way to embed Weft. Units: size in pixels, exposure in EV (hdr is stored ×
// 2^EV). Threads: all functions must be called by the thread that submits, except prepare().
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "shared/frame.glsl"
#include "shared/light.glsl"
#include "weft/load/load_graph.h"
#include "weft/render/prepared.h"
#include "weft/render/sun_cascades.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/executor.h"
#include "weft/vulkan/pipeline_store.h"

namespace weft::render {

class GpuScene;

// Creation info for SessionInput::output: RGBA8, one mip. It points to data of `device`.
[[nodiscard]] VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size);

struct SessionInput {
    std::string graph_path;
    FileReader reader;
    std::filesystem::path graph_root;  // the graphs/ folder, where included files are also searched
    std::filesystem::path shader_root;
    std::filesystem::path shader_cache;
    std::filesystem::path shader_worker;  // find_shader_worker(); empty: glslang runs in this process
    Limits limits;
    const PassCatalog* passes = nullptr;
    Extent3D size{1280, 720, 1};
    std::string tier;  // tier of the graph; empty: none
    std::map<std::string, double> params;
    std::vector<std::string> observed;  // references of resources that are read back every frame
    std::string debug;    // a debug view, or any resource; drawn as "debugView", which must be observed to
                          // see it
    uint32_t queues = 1;  // number of logical queues; the device must have been created for as many
    scene::Camera camera;
    float exposure_ev = 0;
    // An embedder's image, made with output_create_info(), to which frames are drawn; null: the session
    // creates one. When render_frame() returns, the image is written and in TRANSFER_SRC_OPTIMAL for commands
    // submitted to the device's first queue. They may copy or blit it and must leave it in that layout. It
    // must outlive the session.
    VkImage output = VK_NULL_HANDLE;
    bool check_plan = false;  // check the plan before it runs; always done in debug builds
    bool timestamps = false;  // GPU times per pass; adds execution barriers, so do not use it for validation
                              // runs
    std::string drop_barriers_before;  // for tests: name of a pass whose barriers are not recorded
};

class Session {
 public:
    // Errors: those of load_graph (W…), of the checker (C…), of the device (V…). The examined files are added
    // to `files`, also after an error; see prepare().
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    // The same for a scene that is no longer needed: its textures are freed one by one as they are copied to
    // the GPU, which halves their peak memory.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, scene::Scene&& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);

    ~Session();

    [[nodiscard]] const Selection& selection() const { return selection_; }
    // The files that create() examined.
    [[nodiscard]] const std::set<std::filesystem::path>& first_files() const { return first_files_; }
    // Reads the selected graph, compiles changed parts, checks the plan and creates its objects, while frames
    // continue. May be called from any thread; submits nothing. Errors: those of create().
    [[nodiscard]] Preparation prepare(const Selection& selection);
    // Takes effect with the next frame. Histories and kept resources continue as given by transition().
    // Returns false, and does nothing, if something else was swapped in after `next` was prepared; prepare it
    // again. After an error of the checker (C…) the running graph continues.
    [[nodiscard]] Result<bool> swap_in(Prepared next);
    // Prepares and swaps in the last loaded graph at another size. After an error about the graph (W…, C…) or
    // memory, the session continues at the old size. `output` replaces SessionInput::output, whose image may
    // still be used by frames in flight. Errors: those of create().
    [[nodiscard]] Status resize(Extent3D size, Diagnostics& warnings, VkImage output = VK_NULL_HANDLE);
    // Number of pipelines created since create() by the thread that called it.
    [[nodiscard]] uint64_t pipelines_made_between_frames() const { return pipelines_made_between_frames_; }
    [[nodiscard]] Status render_frame(double time_s, double delta_time_s);
    [[nodiscard]] Status finish();
    // True if the graph writes an output; a graph that only delivers resources need not.
    [[nodiscard]] bool has_output() const { return plan().graph.output != kNoId; }
    // The output image of the last frame; call this after finish(). W184: the graph has no output.
    [[nodiscard]] Result<vk::ReadbackData> read_output();
    [[nodiscard]] std::vector<vk::ReadbackData> take_readbacks() { return stage_.executor->take_readbacks(); }
    [[nodiscard]] std::vector<vk::FrameTiming> take_timings() { return stage_.executor->take_timings(); }
    [[nodiscard]] const FramePlan& plan() const { return stage_.executor->plan(); }
    // The number of frames that the graph requests.
    [[nodiscard]] uint32_t frames() const { return loaded_.graph.frames; }
    [[nodiscard]] float pre_exposure() const { return pre_exposure_; }
    [[nodiscard]] const shared::ViewConstants& view() const { return view_; }
    [[nodiscard]] const std::vector<shared::Light>& lights() const { return lights_; }
    // The cascades of the last frame; empty if no pass draws the sun's view.
    [[nodiscard]] const SunCascades& sun() const { return sun_; }

 private:
    Session(vk::Device& device, const SessionInput& input);
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, scene::Scene* owned, const SessionInput& input,
        Diagnostics& warnings, std::set<std::filesystem::path>* files);
    [[nodiscard]] LoadInput load_input(const Selection& selection, const ImportCatalog& imports) const;
    // With memory_, which holds the files that were looked at then.
    [[nodiscard]] Result<LoadedGraph> load(const Selection& selection, const ImportCatalog& imports,
                                           Diagnostics& warnings);
    // The graph, loaded and resolved, as it follows what runs now.
    [[nodiscard]] Result<Prepared> follow_with(const Selection& selection, const ShaderCatalog& shaders,
                                               const ResolvedGraph& graph);
    [[nodiscard]] Status make_stage(Prepared& next, vk::ExecutorInput run, ImportCatalog imports) const;
    [[nodiscard]] Status hand_over_to(Stage stage);
    void adopt(Prepared& next);
    [[nodiscard]] StageMark running() const;
    [[nodiscard]] shared::FrameConstants frame_constants(double time_s, double delta_time_s) const;
    [[nodiscard]] SunCascades find_sun() const;

    vk::Device& device_;
    const SessionInput input_;
    const PassCatalog passes_;
    ImportCatalog imports_;  // for the first size
    std::set<std::filesystem::path> first_files_;
    std::unique_ptr<GpuScene> scene_;
    const std::thread::id drawing_thread_ = std::this_thread::get_id();
    std::atomic<uint64_t> pipelines_made_between_frames_ = 0;
    std::mutex preparing_;  // one at a time; guards memory_
    std::unique_ptr<ShaderMemory> memory_;
    mutable std::mutex marking_;
    StageMark mark_;
    // The rest is the drawing thread's.
    Selection selection_;
    LoadedGraph loaded_;
    std::vector<scene::Light> scene_lights_;
    size_t light_functions_ = 0;
    bool lights_move_ = false;
    std::vector<shared::Light> lights_;  // of this frame
    shared::ViewConstants view_{};
    scene::Bounds scene_bounds_;
    SunMaps sun_maps_;
    SunCascades sun_;
    shared::FrameConstants scene_constants_{};
    float pre_exposure_ = 1;
    uint64_t frame_index_ = 0;
    vk::PipelineStore pipelines_;
    Stage stage_;  // last: destroyed first
};

}  // namespace weft::render
