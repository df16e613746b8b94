// Purpose: renders frames with a stage, and keeps the data of the previous frame that the next one needs. For
// the thread that submits.
#pragma once

#include <optional>

#include "render/drawn_scene.h"
#include "render/render_stage.h"
#include "weft/render/frame_input.h"

namespace weft::render {

class FrameLoop {
 public:
    // `jitter_length`: as GraphDesc::jitter.
    FrameLoop(RenderStage stage, Extent3D size, uint32_t jitter_length);

    [[nodiscard]] Status render(const FrameInput& input, DrawnScene& scene);
    [[nodiscard]] Status finish() { return stage_.executor->finish(); }
    // W184: the graph has no output.
    [[nodiscard]] Result<vk::ReadbackData> read_output();

    // From the next frame on, uses the running stage with other values and pipelines, or another stage. Call
    // set_graph() after either.
    void amend(std::unique_ptr<vk::Amendment> amendment) { stage_.executor->amend(std::move(amendment)); }
    // `check`: check the transition. After an error of the checker nothing has changed.
    [[nodiscard]] Status take_over(RenderStage stage, bool check);
    void set_graph(Extent3D size, uint32_t jitter_length);

    [[nodiscard]] vk::Executor& executor() { return *stage_.executor; }
    [[nodiscard]] const FramePlan& plan() const { return stage_.executor->plan(); }
    [[nodiscard]] bool has_output() const { return plan().graph.output != kNoId; }
    // Of the last frame.
    [[nodiscard]] const shared::ViewConstants& view() const { return view_; }
    [[nodiscard]] const SunCascades& sun() const { return sun_; }
    [[nodiscard]] float pre_exposure() const { return pre_exposure_; }

 private:
    [[nodiscard]] shared::ViewConstants find_view(const scene::Camera& camera) const;

    Extent3D size_;
    uint32_t jitter_length_ = 0;
    SunMaps sun_maps_;
    uint64_t frame_index_ = 0;  // of the next frame
    shared::ViewConstants view_{};
    SunCascades sun_;
    float pre_exposure_ = 1;
    RenderStage stage_;  // last: destroyed first
};

}  // namespace weft::render
