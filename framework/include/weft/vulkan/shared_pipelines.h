// Purpose: lets several sessions on one device share pipelines.
#pragma once

#include <memory>

namespace weft::vk {

class PipelineStore;

// The pipelines of several sessions (render::SessionInput::pipelines). Equal pipelines are created only once.
// The object must outlive the sessions, and must be destroyed before the Device. Thread-safe.
class SharedPipelines {
 public:
    SharedPipelines();
    ~SharedPipelines();
    SharedPipelines(const SharedPipelines&) = delete;
    SharedPipelines& operator=(const SharedPipelines&) = delete;

    [[nodiscard]] PipelineStore& store() { return *store_; }

 private:
    std::unique_ptr<PipelineStore> store_;
};

}  // namespace weft::vk
