// Purpose: makes the pipelines of a pass: one per variant of each draw list if the pass has draw lists,
// otherwise one. A pipeline that is already in the store is reused. Errors: V412 (a pipeline could not be
// created), V414 (the program has no such draw list), V416 (the draw list lacks a vertex input).
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
    // Name of the draw list, such as "opaque"; empty if the pass has no draw lists.
    std::string list;
    // Index into ImportDecl::variants of the draw list; 0 if the pass has no draw lists.
    uint32_t variant = 0;
    PipelineLease pipeline;
};

struct PipelineRequest {
    const FramePlan& plan;
    const PassDecl& pass;
    const ShaderProgram& program;
    const PassLayout& layout;
    // The imports of the program, which include the draw lists. Must not be null if the pass has draw lists.
    const ImportCatalog* imports;
    const DrawSource* draws;  // Null if the pass has no draw lists.
    VkPipelineCache cache;
    PipelineStore& store;
    PipelineCounts& counts;
};

// Returns the pipelines in drawing order: list by list in the order of PassDecl::draw_lists, and within a
// list in the order of its variants. Variants that DrawSource::draws_variant() excludes are left out.
[[nodiscard]] Result<std::vector<DrawPipeline>> make_pipelines(Device& device,
                                                               const PipelineRequest& request);
[[nodiscard]] Result<PipelineCacheHandle> make_pipeline_cache(Device& device);

}  // namespace weft::vk
