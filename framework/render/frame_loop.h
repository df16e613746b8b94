// Purpose: renders frames with a RenderStage, and keeps the data of the previous frame that the next frame
// needs. All functions must be called on the thread that submits.
#pragma once

#include <optional>

#include "render/drawn_scene.h"
#include "render/live_inputs.h"
#include "render/render_stage.h"
#include "render/views/frame_views.h"
#include "weft/render/frame_input.h"

namespace weft::render {

class FrameLoop {
 public:
    // `jitter_length` is the number of frames after which the sub-pixel offsets of the camera repeat (see
    // GraphDesc::jitter); 0 means no offsets. `size` is the size of the output in pixels.
    FrameLoop(RenderStage stage, Extent3D size, uint32_t jitter_length);

    // normal: the next frame of the program. warm_up: an additional frame before the next frame, without a
    // picture. The additional frame runs only the passes with "rest", the groups, and the passes whose
    // results these read. It has the same number as the next frame, and the next frame cannot read contents
    // of previous frames.
    enum class Kind : uint8_t { normal, warm_up };
    // `live` replaces the switches and scales in FrameInput::parameters.
    [[nodiscard]] Status render(const FrameInput& input, const LiveInputs& live, DrawnScene& scene,
                                Kind kind = Kind::normal);
    [[nodiscard]] Status finish() { return stage_.executor->finish(); }
    // Reads the output image of the last frame. Errors: W184 the graph has no output, V426 its final layout
    // is not transfer_src.
    [[nodiscard]] Result<vk::ReadbackData> read_output();

    // Replaces values of parameters and pipelines of the running stage from the next frame on. Call
    // set_graph() afterwards.
    void amend(std::unique_ptr<vk::Amendment> amendment) { stage_.executor->amend(std::move(amendment)); }
    // Replaces the running stage by another one from the next frame on. If `check` is true, the checker first
    // checks the transition between the two plans; if it finds an error, nothing changes. Call set_graph()
    // afterwards.
    [[nodiscard]] Status take_over(RenderStage stage, bool check);
    // Sets the output size and the jitter for the running plan, and finds the views that the plan uses.
    void set_graph(Extent3D size, uint32_t jitter_length);

    [[nodiscard]] vk::Executor& executor() const { return *stage_.executor; }
    [[nodiscard]] const FramePlan& plan() const { return stage_.executor->plan(); }
    // Returns a resource that the running graph exports; nullopt if there is none of this name.
    [[nodiscard]] std::optional<ExportedResource> exported(std::string_view name) const;
    // Returns a frame number. When the frame with this number begins, the frames that are in flight now have
    // finished. Memory that no frame uses from now on can be freed then.
    [[nodiscard]] uint64_t next_free_frame() const { return frame_index_ + vk::kFramesInFlight; }
    // Returns true if the running graph has a group for which `import` selects the rounds that run in a frame
    // (GroupDecl::turns).
    [[nodiscard]] bool takes_turns(std::string_view import) const;
    [[nodiscard]] bool has_output() const { return plan().graph.output != kNoId; }
    // Returns the view constants of the last frame.
    [[nodiscard]] const shared::ViewConstants& view() const { return view_; }
    // Returns all views of the last frame.
    [[nodiscard]] const FrameViews& views() const { return views_; }
    [[nodiscard]] const SunCascades& sun() const { return sun_; }
    [[nodiscard]] const FurtherSunMaps& further_suns() const { return further_suns_; }
    [[nodiscard]] const LampShadows& lamp_shadows() const { return lamp_shadows_; }
    [[nodiscard]] float pre_exposure() const { return pre_exposure_; }

 private:
    [[nodiscard]] shared::ViewConstants find_view(const scene::Camera& camera, bool cut) const;

    Extent3D size_;
    uint32_t jitter_length_ = 0;
    SunMaps sun_maps_;
    FurtherSunSizes further_sun_sizes_{};
    uint32_t lamp_maps_ = 0;
    FrameViews views_;
    bool hides_history_ = false;  // True: the next frame cannot read contents of previous frames.
    // Index of the next frame, counted from 0.
    uint64_t frame_index_ = 0;
    shared::ViewConstants view_{};
    SunCascades sun_;
    FurtherSunMaps further_suns_;
    LampShadows lamp_shadows_;
    float pre_exposure_ = 1;
    // Objects of stages that were replaced. Frames in flight may still use them until the frame with the
    // number `until` begins.
    struct Retired {
        FileUses files;
        ExportObjects exports;
        std::map<std::string, vk::Image> own_images;
        uint64_t until = 0;
    };
    std::vector<Retired> retired_;
    // Declared last, so that `stage_` is destroyed first: its executor then waits for the frames in flight.
    RenderStage stage_;
};

}  // namespace weft::render
