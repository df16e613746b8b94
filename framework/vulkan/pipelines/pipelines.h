// Purpose: the pipelines of a pass: one, or for raster passes one for each variant of each draw list. Those
// that the store has are leased, not made.
// Errors: V412, V416.
#pragma once

#include <string>
#include <vector>

#include "vulkan/pipelines/pass_layout.h"
#include "weft/imports.h"
#include "weft/vulkan/handle.h"
#include "weft/vulkan/pipeline_store.h"

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
    const ImportCatalog* imports;  // needed by draw lists
    VkPipelineCache cache;
    PipelineStore& store;
    PipelineCounts& counts;
};

// In the order in which they are drawn: lists as the pass names them, then variants.
[[nodiscard]] Result<std::vector<DrawPipeline>> make_pipelines(Device& device,
                                                               const PipelineRequest& request);
[[nodiscard]] Result<PipelineCacheHandle> make_pipeline_cache(Device& device);

}  // namespace weft::vk
