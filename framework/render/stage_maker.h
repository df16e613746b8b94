// Purpose: makes the parts that replace the running graph (SwapParts) from a resolved graph: compiles and
// checks its plan, and makes the objects that the running stage lacks. make() may run on any thread while
// frames are rendered; it submits nothing.
#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "render/graph_loader.h"
#include "render/swap_parts.h"
#include "vulkan/memory/shared_store.h"
#include "vulkan/pipelines/pipeline_store.h"
#include "weft/render/session.h"
#include "weft/vulkan/shared_pipelines.h"

namespace weft::render {

class GpuScene;

struct StageSettings {
    uint32_t queues = 1;
    bool check_plan = false;
    bool timestamps = false;
    std::string drop_barriers_before;
    std::map<std::string, std::vector<VkImageView>, std::less<>> textures;
    // The store that several sessions share; null: the StageMaker has its own store.
    vk::PipelineStore* pipelines = nullptr;

    explicit StageSettings(const SessionInput& input)
        : queues(input.queues),
          check_plan(input.check_plan || kAlwaysCheck),
          timestamps(input.timestamps),
          drop_barriers_before(input.drop_barriers_before),
          textures(input.textures),
          pipelines(input.pipelines != nullptr ? &input.pipelines->store() : nullptr) {}
};

class StageMaker {
 public:
    // The three referenced objects must outlive the StageMaker. The calling thread becomes the drawing
    // thread: pipelines_made_between_frames() counts the pipelines made on it.
    StageMaker(vk::Device& device, const GpuScene& scene, const GraphLoader& loader, StageSettings settings)
        : device_(device), scene_(scene), loader_(loader), settings_(std::move(settings)), files_(device) {}

    // Makes the parts for a resolved graph. `running` is the fingerprint of the stage that they replace; its
    // generation is 0 if no stage runs yet.
    [[nodiscard]] Result<std::unique_ptr<SwapParts>> make(const Selection& selection,
                                                          const ShaderCatalog& shaders,
                                                          const ResolvedGraph& graph,
                                                          const StageFingerprint& running);
    // Makes the parts for a graph that differs from the graph of the running stage only in values of
    // parameters. Nothing is compiled, and the plan is not checked again, because it stays the same.
    [[nodiscard]] static std::unique_ptr<SwapParts> make_values(const Selection& selection,
                                                                ResolvedGraph graph,
                                                                StageFingerprint running);
    [[nodiscard]] bool checks_plans() const { return settings_.check_plan; }
    // Returns the number of pipelines that were made on the constructor's thread in order to replace a
    // running stage. Such pipelines delay a frame.
    [[nodiscard]] uint64_t pipelines_made_between_frames() const { return made_between_frames_; }

 private:
    // Makes the plan of a graph. It retains the resources in `shared` that no pass of the graph uses.
    [[nodiscard]] Result<FramePlan> make_plan(const ResolvedGraph& graph, const GraphRequest& request,
                                              const std::vector<ResourceDecl>& shared) const;
    [[nodiscard]] Status make_objects(SwapParts& next, FramePlan plan, const ShaderCatalog& shaders,
                                      FileUses files);
    [[nodiscard]] Result<RenderStage> make_stage(vk::ExecutorInput run, const Selection& selection,
                                                 FileUses files) const;
    [[nodiscard]] Status bind_imports(const FramePlan& plan, const Selection& selection, RenderStage& stage,
                                      vk::ImportBindings& bindings) const;

    vk::Device& device_;
    const GpuScene& scene_;
    const GraphLoader& loader_;
    const StageSettings settings_;
    const std::thread::id drawing_thread_ = std::this_thread::get_id();
    std::atomic<uint64_t> made_between_frames_ = 0;
    vk::PipelineStore pipelines_;
    vk::SharedStore shared_;
    FileStore files_;
};

}  // namespace weft::render
