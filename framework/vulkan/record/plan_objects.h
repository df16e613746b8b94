// Purpose: everything a plan needs on the device, made once: heap, views, layouts, descriptor sets,
// pipelines, and the memory that host and device exchange. Frames only replay it. Errors: V410 to V418, all
// of a plan's at once.
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

// What recording one pass needs beside its declaration; which members are set depends on its kind.
struct PreparedPass {
    PassLayout layout;
    // Both by the frame's turn: what a pass sees of resources with history comes back after so many frames.
    std::vector<SlotSets> port_sets;
    std::vector<RenderingScope> scopes;
    std::vector<DrawPipeline> pipelines;
    std::optional<PassType> type;  // custom passes

    [[nodiscard]] const RenderingScope& scope(uint64_t frame) const { return scopes[frame % scopes.size()]; }
    [[nodiscard]] const VkDescriptorSet& port_set(uint64_t frame, uint32_t slot) const {
        return port_sets[frame % port_sets.size()][slot];
    }
};

// Stays where it was made: its parts refer to each other.
struct PlanObjects {
    PlanObjects(Device& device, FramePlan frame_plan)
        : plan(std::move(frame_plan)), views(device, plan, resources), samplers(device), stand_ins(device) {}
    PlanObjects(const PlanObjects&) = delete;
    PlanObjects& operator=(const PlanObjects&) = delete;

    FramePlan plan;
    std::unique_ptr<PipelineStore> own_pipelines;  // where the program gave none
    PipelineCounts pipeline_counts;
    TransientHeap heap;
    ResourceTable resources;
    ViewCache views;
    SamplerCache samplers;
    StandIns stand_ins;
    ParamsMemory params;
    UploadMemory uploads;
    ReadbackMemory readbacks;
    PassTimer timer;
    PipelineCacheHandle cache;
    DescriptorPoolHandle pool;
    std::vector<PreparedPass> passes;  // by position
    const DrawSource* draws = nullptr;
};

[[nodiscard]] Result<std::unique_ptr<PlanObjects>> make_plan_objects(Device& device, ExecutorInput input);

// What amend() exchanges.
struct PlanAmendment final : Amendment {
    FramePlan plan;
    std::vector<std::vector<DrawPipeline>> passes;  // by position
    PipelineCounts counts;

    PipelineCounts pipelines() const override { return counts; }
};
[[nodiscard]] Result<std::unique_ptr<PlanAmendment>> make_plan_amendment(Device& device, ExecutorInput input);

}  // namespace weft::vk
