#include "vulkan/pipelines/pipeline_store.h"

#include "weft/vulkan/shared_pipelines.h"

namespace weft::vk {

SharedPipelines::SharedPipelines() : store_(std::make_unique<PipelineStore>()) {}
SharedPipelines::~SharedPipelines() = default;

Result<PipelineLease> PipelineStore::get(const std::string& hash, const Make& make, uint32_t& made) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = entries_.find(hash); found != entries_.end())
            return lease(hash, found->second, found->second.owner.get());
    }
    // The lock is not held here, because creating a pipeline may take long. If two threads create the same
    // pipeline, the second of the two pipelines is destroyed.
    Result<PipelineHandle> pipeline = make();
    if (!pipeline) return pipeline.take_errors();
    ++made;
    const std::lock_guard lock(mutex_);
    const auto [place, is_new] = entries_.try_emplace(hash);
    if (is_new) place->second.owner = std::move(*pipeline);
    return lease(hash, place->second, place->second.owner.get());
}

}  // namespace weft::vk
