// Purpose: stores pipelines by a hash of their inputs (graph/plan/pipeline_hash.h). Consecutive plans, and
// passes of one plan, hold leases on the same pipeline; the last lease destroys it. Plans that share a store
// must share a draw source too. Thread-safe.
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

// Move-only. The store must outlive it.
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
    // Calls `make` if the store has no such pipeline, and adds 1 to `made`.
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
