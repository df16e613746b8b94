// Purpose: shares pipelines by a hash of their inputs (graph/plan/pipeline_hash.h). Passes of one plan, and
// plans that follow each other, can have leases on the same pipeline; when the last lease ends, the pipeline
// is destroyed. The draw sources of plans that share a store must have identical descriptor set layouts,
// because the hash does not cover them; all scenes of render/ have the same layouts. Thread-safe.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "vulkan/device/handle.h"
#include "weft/result.h"

namespace weft::vk {

class PipelineStore;

// The right to use one pipeline of a store. A lease can be moved but not copied. The store must outlive it.
class PipelineLease {
 public:
    PipelineLease() = default;
    ~PipelineLease() { reset(); }
    PipelineLease(PipelineLease&& other) noexcept
        : store_(std::exchange(other.store_, nullptr)),
          hash_(std::move(other.hash_)),
          pipeline_(std::exchange(other.pipeline_, VK_NULL_HANDLE)) {}
    PipelineLease& operator=(PipelineLease&& other) noexcept;

    [[nodiscard]] VkPipeline get() const { return pipeline_; }
    void reset();

 private:
    friend class PipelineStore;
    PipelineLease(PipelineStore& store, std::string hash, VkPipeline pipeline)
        : store_(&store), hash_(std::move(hash)), pipeline_(pipeline) {}

    PipelineStore* store_ = nullptr;
    std::string hash_;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

class PipelineStore {
 public:
    PipelineStore() = default;
    PipelineStore(const PipelineStore&) = delete;
    PipelineStore& operator=(const PipelineStore&) = delete;

    using Make = std::function<Result<PipelineHandle>()>;
    // Returns a lease on the pipeline with this hash. If the store does not have the pipeline, the function
    // creates it with `make` and adds 1 to `made`.
    [[nodiscard]] Result<PipelineLease> get(const std::string& hash, const Make& make, uint32_t& made);

 private:
    friend class PipelineLease;
    struct Entry {
        PipelineHandle pipeline;
        uint32_t leases = 0;
    };
    [[nodiscard]] PipelineLease lease(const std::string& hash, Entry& entry);
    void give_back(const std::string& hash);

    std::mutex mutex_;
    std::map<std::string, Entry> entries_;
};

}  // namespace weft::vk
