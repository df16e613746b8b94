// Purpose: all Vulkan objects of a plan: heaps, views, layouts, descriptor sets, pipelines, and memory for
// transfers between host and device. They are created once; frames only use them. Errors: V409 to V418, V421.
// Faults of several passes are reported together.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "vulkan/memory/readback.h"
#include "vulkan/memory/uploads.h"
#include "vulkan/pipelines/descriptors.h"
#include "vulkan/pipelines/pipelines.h"
#include "vulkan/record/rendering_scope.h"
#include "vulkan/record/timing.h"
#include "vulkan/record/view_sets.h"

namespace weft::vk {

// The Vulkan objects needed to record one pass. The kind of the pass determines which members are set.
struct PreparedPass {
    PassLayout layout;
    // The period of a pass is the number of frames after which the pass uses the same copies of its resources
    // with history again. `scopes` has one element for each frame of the period. `port_sets` has one element
    // for each variant and each frame of the period: all frames of the first variant, then all frames of the
    // next variant.
    std::vector<SlotSets> port_sets;
    std::vector<RenderingScope> scopes;
    // Each variant of the pass has the same number of pipelines. The list contains all pipelines of the first
    // variant, then those of the next variant.
    std::vector<DrawPipeline> pipelines;
    uint32_t variants = 1;
    // The constants of frame and view that the shader reads; see ShaderInterface.
    std::vector<FrameRange> frame_ranges;
    // The program's callbacks for the pass; set only for custom passes.
    std::optional<PassType> type;
    // The views of the ports of a custom pass: one list for each frame of the period, with one view for each
    // use.
    std::vector<std::vector<VkImageView>> port_views;

    [[nodiscard]] const RenderingScope& scope(uint64_t frame) const { return scopes[frame % scopes.size()]; }
    [[nodiscard]] const std::vector<VkImageView>& port_view_set(uint64_t frame) const {
        return port_views[frame % port_views.size()];
    }
    [[nodiscard]] const VkDescriptorSet& port_set(uint32_t variant, uint64_t frame, uint32_t slot) const {
        const size_t period = port_sets.size() / variants;
        return port_sets[variant * period + frame % period][slot];
    }
    [[nodiscard]] std::span<const DrawPipeline> pipelines_of(uint32_t variant) const {
        const size_t count = pipelines.size() / variants;
        return std::span(pipelines).subspan(variant * count, count);
    }
};

// PlanObjects cannot be moved, because its members refer to each other.
struct PlanObjects {
    PlanObjects(Device& device, FramePlan frame_plan)
        : plan(std::move(frame_plan)),
          views(device, plan, resources),
          samplers(device),
          dummies(device),
          validity(plan),
          areas(plan) {}
    PlanObjects(const PlanObjects&) = delete;
    PlanObjects& operator=(const PlanObjects&) = delete;

    FramePlan plan;
    // A store for the pipelines; null if the program provides a store.
    std::unique_ptr<PipelineStore> own_pipelines;
    // A store for shared resources; null if the program provides a store.
    std::unique_ptr<SharedStore> own_shared;
    PipelineCounts pipeline_counts;
    TransientHeap heap;
    ResourceTable resources;
    ViewCache views;
    SamplerCache samplers;
    DummyDescriptors dummies;
    ParamsMemory params;
    UploadMemory uploads;
    ReadbackMemory readbacks;
    UnitValidity validity;
    FrameAreas areas;
    PassTimer timer;
    PipelineCacheHandle cache;
    DescriptorPoolHandle pool;
    PassViewSets view_sets;
    // One element for each pass, in execution order.
    std::vector<PreparedPass> passes;
    const DrawSource* draws = nullptr;
};

[[nodiscard]] Result<std::unique_ptr<PlanObjects>> make_plan_objects(Device& device, ExecutorInput input);

// The new graph and pipelines that Executor::amend() puts in place of the old ones. The other parts of the
// plan stay, because the structure of the graph is the same.
struct PlanAmendment final : Amendment {
    ResolvedGraph graph;
    // The pipelines of each pass, indexed by the position of the pass in the execution order. Empty if the
    // old pipelines stay.
    std::vector<std::vector<DrawPipeline>> passes;
    // PreparedPass::frame_ranges of each pass, with the same index as `passes`.
    std::vector<std::vector<FrameRange>> frame_ranges;
    PipelineCounts counts;

    PipelineCounts pipelines() const override { return counts; }
};
[[nodiscard]] Result<std::unique_ptr<PlanAmendment>> make_plan_amendment(Device& device, ExecutorInput input);

}  // namespace weft::vk
