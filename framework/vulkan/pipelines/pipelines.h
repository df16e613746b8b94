// Purpose: the pipelines of a pass: one, or for raster passes one per variant of each draw list. Pipelines
// that are already in the store are reused. Errors: V412, V416.
#pragma once

#include <string>
#include <vector>

#include "vulkan/device/handle.h"
#include "vulkan/pipelines/pass_layout.h"
#include "vulkan/pipelines/pipeline_store.h"
#include "weft/imports.h"
#include "weft/vulkan/executor.h"

namespace weft::vk {

struct DrawPipeline {
    std::string list;  // empty for passes without draw lists
    uint32_t variant = 0;
    PipelineLease pipeline;
};

struct PipelineRequest {
    const FramePlan& plan;
    const PassDecl& pass;
    const ShaderProgram& program;
    const PassLayout& layout;
    const ImportCatalog* imports;  // required if the pass has draw lists
    VkPipelineCache cache;
    PipelineStore& store;
    PipelineCounts& counts;
};

// In drawing order: lists in the order of the pass, then variants.
[[nodiscard]] Result<std::vector<DrawPipeline>> make_pipelines(Device& device,
                                                               const PipelineRequest& request);
[[nodiscard]] Result<PipelineCacheHandle> make_pipeline_cache(Device& device);

}  // namespace weft::vk
