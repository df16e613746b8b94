// Purpose: all Vulkan objects of a plan, created once: heap, views, layouts, descriptor sets, pipelines, and
// memory for transfers between host and device. Frames only use them. Errors: V410 to V418, all errors of a
// plan together.
#pragma once

#include <memory>
#include <optional>

#include "vulkan/memory/readback.h"
#include "vulkan/memory/uploads.h"
#include "vulkan/pipelines/descriptors.h"
#include "vulkan/pipelines/pipelines.h"
#include "vulkan/record/rendering_scope.h"
#include "vulkan/record/timing.h"

namespace weft::vk {

// Data for recording one pass, in addition to its declaration; the kind of pass determines which members are
// set.
struct PreparedPass {
    PassLayout layout;
    // Both are indexed by the frame's ring phase: resources with history return to the same copies after that
    // many frames.
    std::vector<SlotSets> port_sets;
    std::vector<RenderingScope> scopes;
    std::vector<DrawPipeline> pipelines;
    std::optional<PassType> type;  // for custom passes

    [[nodiscard]] const RenderingScope& scope(uint64_t frame) const { return scopes[frame % scopes.size()]; }
    [[nodiscard]] const VkDescriptorSet& port_set(uint64_t frame, uint32_t slot) const {
        return port_sets[frame % port_sets.size()][slot];
    }
};

// Cannot be moved: its parts refer to each other.
struct PlanObjects {
    PlanObjects(Device& device, FramePlan frame_plan)
        : plan(std::move(frame_plan)), views(device, plan, resources), samplers(device), dummies(device) {}
    PlanObjects(const PlanObjects&) = delete;
    PlanObjects& operator=(const PlanObjects&) = delete;

    FramePlan plan;
    std::unique_ptr<PipelineStore> own_pipelines;  // used if the program provides no store
    PipelineCounts pipeline_counts;
    TransientHeap heap;
    ResourceTable resources;
    ViewCache views;
    SamplerCache samplers;
    DummyDescriptors dummies;
    ParamsMemory params;
    UploadMemory uploads;
    ReadbackMemory readbacks;
    PassTimer timer;
    PipelineCacheHandle cache;
    DescriptorPoolHandle pool;
    std::vector<PreparedPass> passes;  // index: schedule position
    const DrawSource* draws = nullptr;
};

[[nodiscard]] Result<std::unique_ptr<PlanObjects>> make_plan_objects(Device& device, ExecutorInput input);

// The objects that amend() replaces.
struct PlanAmendment final : Amendment {
    FramePlan plan;
    std::vector<std::vector<DrawPipeline>> passes;  // index: schedule position
    PipelineCounts counts;

    PipelineCounts pipelines() const override { return counts; }
};
[[nodiscard]] Result<std::unique_ptr<PlanAmendment>> make_plan_amendment(Device& device, ExecutorInput input);

}  // namespace weft::vk
