// Purpose: records the draws of parts of a scene for one pass. The draws of a list are recorded in runs; each
// run has draws of one part.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "render/parts/gpu_part.h"
#include "render/views/frustum.h"
#include "weft/vulkan/draw_source.h"

namespace weft::render {

// Draws of one part in the order in which they are recorded.
struct DrawRun {
    const GpuPart* part = nullptr;
    const std::vector<PartDraw>* draws = nullptr;
    // Indices into `draws`; absent: all draws in their order.
    std::optional<std::span<const uint32_t>> order;
    // True: the draws have commands in DrawContext::draw_commands, at the same indices.
    bool has_commands = false;
};

class DrawRecorder {
 public:
    // Draws outside of all `frusta` are left out; without frustums, all draws are recorded. `mirrored` says
    // whether the picture is a mirror image.
    DrawRecorder(const vk::DrawContext& context, Frusta frusta, bool mirrored)
        : context_(context), frusta_(std::move(frusta)), mirrored_(mirrored) {}

    // Returns the number of draws that were left out.
    uint32_t record(const DrawRun& run);
    // Records one command that draws as many commands of the buffer as the GPU has counted. resolve() ensures
    // that the pass culls no faces and reads no materials, so all draws have the same state.
    void record_counted(const GpuPart& part);

 private:
    void bind(const GpuPart& part);
    [[nodiscard]] uint32_t count_alike(const DrawRun& run, uint32_t i, uint32_t size) const;
    void set_state(const GpuPart& part, const PartDraw& draw);

    const vk::DrawContext& context_;
    Frusta frusta_;
    bool mirrored_;
    // The state that the previous draws in the command buffer have set.
    const GpuPart* bound_ = nullptr;
    uint32_t material_ = scene::kNone;
    std::optional<bool> clockwise_, double_sided_;
};

}  // namespace weft::render
