// Purpose: one graph drawing one scene: load, compile, prove, run. What `weft render` and the picture tests
// are made of, and the shortest way to embed Weft. Units: size in pixels, exposure in EV (hdr is stored ×
// 2^EV). Threads: all is for the thread that submits, but for prepare().
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

// How to make an image for SessionInput::output: RGBA8, of one mip. Points into `device`.
[[nodiscard]] VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size);

struct SessionInput {
    std::string graph_path;
    FileReader reader;
    std::filesystem::path graph_root;  // the graphs/ folder, where included files are looked for as well
    std::filesystem::path shader_root;
    std::filesystem::path shader_cache;
    std::filesystem::path shader_worker;  // find_shader_worker(); empty: glslang runs in this process
    Limits limits;
    const PassCatalog* passes = nullptr;
    Extent3D size{1280, 720, 1};
    std::string tier;  // of the graph; empty: the graph as it is
    std::map<std::string, double> params;
    std::vector<std::string> observed;  // references that are read back every frame
    std::string debug;    // a debug view, or any resource, drawn as "debugView"; observe that to see it
    uint32_t queues = 1;  // logical queues; the device shall have been made for as many
    scene::Camera camera;
    float exposure_ev = 0;
    // An embedder's image, made as output_create_info() says, that frames are drawn into; null: one of the
    // session's own. When render_frame() returns, commands submitted to the device's first queue find it in
    // TRANSFER_SRC_OPTIMAL, written, and may copy or blit it; they leave it so. It outlives the session.
    VkImage output = VK_NULL_HANDLE;
    bool check_plan = false;  // prove the plan before it runs; always done in debug builds
    bool timestamps = false;  // per-pass GPU times; adds execution barriers, so not for validation runs
    std::string drop_barriers_before;  // test hook: a pass whose barriers are not recorded
};

class Session {
 public:
    // Errors: those of load_graph (W…), of the checker (C…), of the device (V…). What it looked at is added
    // to `files`, also after an error: as Preparation::files.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, const scene::Scene& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);
    // The same for a scene that is not used any more: its textures are freed one by one as they are copied to
    // the GPU, which halves what they take at most.
    [[nodiscard]] static Result<std::unique_ptr<Session>> create(
        vk::Device& device, scene::Scene&& scene, const SessionInput& input, Diagnostics& warnings,
        std::set<std::filesystem::path>* files = nullptr);

    ~Session();

    [[nodiscard]] const Selection& selection() const { return selection_; }
    // What create() looked at, as Preparation::files.
    [[nodiscard]] const std::set<std::filesystem::path>& first_files() const { return first_files_; }
    // Reads the selected graph, compiles what changed, proves the plan and makes its objects, while frames go
    // on: this may be called from any thread, and submits nothing. Errors: as create().
    [[nodiscard]] Preparation prepare(const Selection& selection);
    // From the next frame on. Histories and kept resources live on, as transition() says. False: something
    // else was swapped in since it was prepared, and nothing happens; prepare it again. After an error of the
    // checker (C…) everything goes on as it was.
    [[nodiscard]] Result<bool> swap_in(Prepared next);
    // Both at once, with the graph as it was last loaded. After an error that names the graph (W…, C…) or
    // memory everything goes on at the old size. `output` replaces SessionInput::output, whose image frames
    // in flight may still use. Errors: as create().
    [[nodiscard]] Status resize(Extent3D size, Diagnostics& warnings, VkImage output = VK_NULL_HANDLE);
    // How many pipelines were made by the thread that called create(), since then.
    [[nodiscard]] uint64_t pipelines_made_between_frames() const { return pipelines_made_between_frames_; }
    [[nodiscard]] Status render_frame(double time_s, double delta_time_s);
    [[nodiscard]] Status finish();
    // Whether the graph writes an output: one that only delivers resources may do without.
    [[nodiscard]] bool has_output() const { return plan().graph.output != kNoId; }
    // The output image of the last frame; call after finish(). W184: there is none.
    [[nodiscard]] Result<vk::ReadbackData> read_output();
    [[nodiscard]] std::vector<vk::ReadbackData> take_readbacks() { return stage_.executor->take_readbacks(); }
    [[nodiscard]] std::vector<vk::FrameTiming> take_timings() { return stage_.executor->take_timings(); }
    [[nodiscard]] const FramePlan& plan() const { return stage_.executor->plan(); }
    // How many frames the graph asks for.
    [[nodiscard]] uint32_t frames() const { return loaded_.graph.frames; }
    [[nodiscard]] float pre_exposure() const { return pre_exposure_; }
    [[nodiscard]] const shared::ViewConstants& view() const { return view_; }
    [[nodiscard]] const std::vector<shared::Light>& lights() const { return lights_; }
    // Of the last frame; none where no pass looks through the sun's eyes.
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
