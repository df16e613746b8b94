// Purpose: the class that Executor::create() makes. It runs frames (executor.cpp), and can continue the work
// of an executor that it replaces (executor_handover.cpp).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "graph/rest/frame_steps.h"
#include "graph/rest/rest_state.h"
#include "vulkan/execute/frame_slots.h"
#include "vulkan/execute/unit_input.h"
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
          hooks_(hooks),
          first_view_(count_recorded_views(objects_->plan)),
          rest_(objects_->plan) {}
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
    NativeResource native(ResourceId resource) const override;
    ResourceId last_copy(ResourceId resource) const override;

 private:
    struct InFlight {
        uint64_t frame_index = 0;
        std::vector<Wake> wakes;  // Index: unit.
        // Number of draws that were left out, for each view that a pass records; see RecordContext.
        std::vector<uint32_t> draws_left_out;
        // Areas of the images in the frame (FrameAreas::all()); empty if the plan has no live sizes.
        std::vector<Extent3D> areas;
        Combination switches = kAllSwitchesOn;
        FrameTiming timing;
    };
    // Pipelines that amend() replaced by new ones, and the frame slots whose frames in flight may still use
    // them.
    struct Retired {
        std::vector<std::vector<DrawPipeline>> passes;
        std::array<bool, kFramesInFlight> in_flight{};
    };
    [[nodiscard]] Status complete(uint32_t slot);
    void drop_retired();
    void wake_changed(PlanAmendment& amendment);
    [[nodiscard]] Diagnostic lost_frame(uint32_t slot, VkResult result);
    [[nodiscard]] TurnLists prepare_uploads(const FrameInput& frame, uint32_t slot);
    void choose_units(const FrameInput& frame, const TurnLists& turns, uint32_t slot);
    [[nodiscard]] PassTiming pass_timing(Position position, double gpu_ms, const InFlight& frame) const;
    void record_frame(const FrameInput& frame, uint32_t slot);
    void record_step(const RecordContext& context, const FrameStep& step);
    void record_epilogue(const RecordContext& context);
    void record_start(VkCommandBuffer commands) const;
    void name_changed_inputs(const UnitInputContext& context);
    [[nodiscard]] std::vector<uint8_t> running_units() const;
    [[nodiscard]] std::vector<uint8_t> empty_batches() const;
    [[nodiscard]] Status submit_frame(const FrameSubmit& how, uint32_t slot);
    // Called when another executor is about to replace this one. Prepares this executor's resources, so that
    // the first frame of the new executor, which runs the plan `next`, can copy their contents.
    [[nodiscard]] Status be_followed(const FramePlan& next);
    [[nodiscard]] Status start_without_frame();
    [[nodiscard]] Status complete_predecessor(uint32_t slot);
    [[nodiscard]] Status retire_predecessor();
    void inherit_results();

    Device& device_;
    std::unique_ptr<PlanObjects> objects_;
    std::unique_ptr<FrameSlots> slots_;
    ExecutorHooks hooks_;
    // The index of the first recorded view of each pass; see RecordContext.
    std::vector<uint32_t> first_view_;
    RestState rest_;
    // Result of needed_by_units() for the plan. The list stays empty until a frame needs the result.
    std::vector<uint8_t> needed_by_units_;
    // The inputs of each rest unit in the frame that is being recorded (index: unit), and the units that run
    // in this frame. A rest unit is a set of passes that run together: in each frame, either all of them run
    // or none.
    std::vector<UnitInput> unit_inputs_;
    UnitChoice chosen_;
    std::array<InFlight, kFramesInFlight> in_flight_;
    // Number of frames that have begun. It continues the count of the executor that this one replaces.
    uint64_t frames_begun_ = 0;
    // Frame slot of the frame that has begun but not run yet; kNoId if there is none.
    uint32_t slot_ = kNoId;
    // Number of frames that were submitted successfully.
    uint64_t frames_run_ = 0;
    std::vector<Retired> retired_;
    std::vector<FrameTiming> timings_;
    std::vector<ReadbackData> readbacks_;
    // The error after which no further frame runs: a time-out, a lost device, a frame that was submitted only
    // in part, or a failure of take_over(). Empty if frames can run.
    Diagnostics lost_;
    // True after a time-out and after the loss of the device.
    bool timed_out_ = false;
    // True if another executor has replaced this one.
    bool followed_ = false;
    // The executor that this one replaces. It is kept until the first frame of this executor has finished.
    std::optional<Predecessor> predecessor_;
};

}  // namespace weft::vk
