// Purpose: the implementation of Executor::create(): runs frames (executor.cpp), and continues the work of a
// previous executor (executor_handover.cpp).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "vulkan/execute/frame_slots.h"
#include "vulkan/record/plan_objects.h"
#include "vulkan/record/record.h"

namespace weft::vk {

class ReplayExecutor final : public Executor {
 public:
    ReplayExecutor(Device& device, std::unique_ptr<PlanObjects> objects, FrameSlots slots,
                   ExecutorHooks hooks)
        : device_(device),
          objects_(std::move(objects)),
          slots_(std::make_unique<FrameSlots>(std::move(slots))),
          hooks_(hooks) {}
    ~ReplayExecutor() override;

    Result<uint32_t> begin_frame() override;
    Status run(const FrameInput& frame) override;
    Status finish() override;
    Status take_over(Predecessor predecessor) override;
    std::vector<FrameTiming> take_timings() override { return std::exchange(timings_, {}); }
    std::vector<ReadbackData> take_readbacks() override { return std::exchange(readbacks_, {}); }
    Result<ReadbackData> read_image(const Image& image) override { return read_image_now(device_, image); }
    const FramePlan& plan() const override { return objects_->plan; }
    PipelineCounts pipelines() const override { return objects_->pipeline_counts; }
    void amend(std::unique_ptr<Amendment> amendment) override;
    uint64_t transient_bytes() const override { return objects_->heap.bytes(); }

 private:
    struct InFlight {
        uint64_t frame_index = 0;
        FrameTiming timing;
    };
    // Pipelines that the plan no longer uses, and the frames that may still use them.
    struct Retired {
        std::vector<std::vector<DrawPipeline>> passes;
        std::array<bool, kFramesInFlight> in_flight{};
    };
    [[nodiscard]] Status complete(uint32_t slot);
    void drop_retired();
    [[nodiscard]] Diagnostic lost_frame(uint32_t slot, VkResult result);
    void prepare_host_data(const FrameInput& frame, uint32_t slot);
    void record_frame(const FrameInput& frame, uint32_t slot);
    void record_step(const RecordContext& context, uint32_t position);
    void record_epilogue(const RecordContext& context);
    void record_start(VkCommandBuffer commands) const;
    [[nodiscard]] Status submit_frame(uint32_t slot);
    // Prepares this executor for the first frame of the executor that replaces it.
    [[nodiscard]] Status be_followed(const FramePlan& next);
    [[nodiscard]] Status start_without_frame();
    [[nodiscard]] Status complete_predecessor(uint32_t slot);
    [[nodiscard]] Status retire_predecessor();
    void inherit_results();

    Device& device_;
    std::unique_ptr<PlanObjects> objects_;
    std::unique_ptr<FrameSlots> slots_;
    ExecutorHooks hooks_;
    std::array<InFlight, kFramesInFlight> in_flight_;
    uint64_t frames_begun_ = 0;
    uint32_t slot_ = kNoId;    // slot of the frame that has begun but not run yet
    uint64_t frames_run_ = 0;  // excludes frames that could not be submitted
    std::vector<Retired> retired_;
    std::vector<FrameTiming> timings_;
    std::vector<ReadbackData> readbacks_;
    Diagnostics lost_;  // set after a time-out or a lost device; no further frame runs
    bool timed_out_ = false;
    bool followed_ = false;  // another executor has taken over
    // The replaced executor; kept until this executor's first frame has finished.
    std::optional<Predecessor> predecessor_;
};

}  // namespace weft::vk
