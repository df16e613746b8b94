// Purpose: shares pipelines by a hash of their inputs (graph/plan/pipeline_hash.h). Passes of one plan, and
// plans that follow each other, can have leases on the same pipeline; when the last lease ends, the pipeline
// is destroyed. The draw sources of plans that share a store must have identical descriptor set layouts,
// because the hash does not cover them; all scenes of render/ have the same layouts. Thread-safe.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "vulkan/device/handle.h"
#include "vulkan/device/lease.h"
#include "weft/result.h"

namespace weft::vk {

using PipelineEntries = LeaseStore<PipelineHandle, VkPipeline>;
using PipelineLease = Lease<PipelineEntries, VkPipeline>;

class PipelineStore : public PipelineEntries {
 public:
    using Make = std::function<Result<PipelineHandle>()>;
    // Returns a lease on the pipeline with this hash. If the store does not have the pipeline, the function
    // creates it with `make` and adds 1 to `made`.
    [[nodiscard]] Result<PipelineLease> get(const std::string& hash, const Make& make, uint32_t& made);
};

}  // namespace weft::vk
