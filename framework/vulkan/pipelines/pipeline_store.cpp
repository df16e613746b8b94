#include "vulkan/pipelines/pipeline_store.h"

#include <cassert>

#include "weft/vulkan/shared_pipelines.h"

namespace weft::vk {

SharedPipelines::SharedPipelines() : store_(std::make_unique<PipelineStore>()) {}
SharedPipelines::~SharedPipelines() = default;

PipelineLease PipelineStore::lease(const std::string& hash, Entry& entry) {
    ++entry.leases;
    return {*this, hash, entry.pipeline.get()};
}

Result<PipelineLease> PipelineStore::get(const std::string& hash, const Make& make, uint32_t& made) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = entries_.find(hash); found != entries_.end())
            return lease(hash, found->second);
    }
    // The lock is not held here, because creating a pipeline may take long. If two threads create the same
    // pipeline, the second of the two pipelines is destroyed.
    Result<PipelineHandle> pipeline = make();
    if (!pipeline) return pipeline.take_errors();
    ++made;
    const std::lock_guard lock(mutex_);
    const auto [place, is_new] = entries_.try_emplace(hash);
    if (is_new) place->second.pipeline = std::move(*pipeline);
    return lease(hash, place->second);
}

void PipelineStore::give_back(const std::string& hash) {
    // This variable is declared before the lock, so that the pipeline is destroyed after the lock is
    // released.
    PipelineHandle last;
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(hash);
    assert(found != entries_.end() && found->second.leases > 0);
    if (--found->second.leases > 0) return;
    last = std::move(found->second.pipeline);
    entries_.erase(found);
}

}  // namespace weft::vk
