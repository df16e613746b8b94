// Purpose: pipelines by what they are made of (graph/pipeline_hash.h). Plans that follow each other, and
// passes of one plan, hold leases on the same pipeline; it goes with the last lease. Plans that share a store
// share a draw source too. Every function may be called from any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "weft/result.h"
#include "weft/vulkan/handle.h"

namespace weft::vk {

// How many pipelines a plan draws and computes with, and how many of them were made for it.
struct PipelineCounts {
    uint32_t all = 0;
    uint32_t made = 0;
};

class PipelineStore;

// Move-only. The store outlives it.
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
    // Calls `make` where nobody holds such a pipeline; `made` counts that.
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
