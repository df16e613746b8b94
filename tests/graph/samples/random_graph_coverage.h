// Purpose: counts how many frames of a set of random frames have each feature, so that a test can show that
// its random frames cover all features. Each field counts frames.
#pragma once

#include <cstdint>
#include <string>

#include "weft/plan.h"

namespace weft::test {

struct GraphCoverage {
    uint32_t graphs = 0;
    // Frames in which a resource takes over memory from another one.
    uint32_t alias_transitions = 0;
    uint32_t several_queues = 0;
    // Frames in which a queue waits for work of the same frame on another queue.
    uint32_t waits = 0;
    // Frames with an ownership transfer between queue families.
    uint32_t transfers = 0;
    // Frames in which a live pass uses the history of a resource, such as "x[-1]".
    uint32_t history = 0;
    // Frames in which a live pass uses a resource that keeps its content from frame to frame without history.
    uint32_t kept = 0;
    // Frames in which a pass copies the content of the last frame (PassDecl::carries).
    uint32_t carried = 0;
    // Frames with a barrier on a part of an image.
    uint32_t ranges = 0;
    // Frames with a barrier on a part of a buffer.
    uint32_t buffer_ranges = 0;
    // Frames with a live iteration of a repeated pass.
    uint32_t repeats = 0;
    // Frames with a live pass of a mip chain that the class RandomFeatures made. A mip chain of random_text()
    // is a repeated pass and counts in `repeats`.
    uint32_t chains = 0;
    // Frames in which a condition removed a pass or changed an input.
    uint32_t conditionals = 0;
    // Frames with an `after` edge, which orders two passes even if they share no resource.
    uint32_t after = 0;
    // Frames in which a live pass uses an array of mips, or an array of layers.
    uint32_t arrays = 0;
    uint32_t layer_arrays = 0;
    // Frames in which a live pass draws a view of a list of this kind.
    uint32_t program_views = 0;
    uint32_t mirrors = 0;
    uint32_t cube_views = 0;
    uint32_t buffer_views = 0;
    // Frames in which a live pass reads its numbers of workgroups after the start of a buffer.
    uint32_t indirect_offsets = 0;
    uint32_t indirect_draws = 0;
    // Frames in which a live pass reads its number of draws from a buffer.
    uint32_t draw_counts = 0;
    // Frames with a sampler that has a reduction, that is anisotropic, or that limits or moves its level.
    uint32_t reductions = 0;
    uint32_t anisotropic = 0;
    uint32_t levels = 0;
    // Frames in which a live pass uses a resource that all tiers share, a resource with a file, or a buffer
    // of the scene.
    uint32_t shared = 0;
    uint32_t files = 0;
    uint32_t scene_buffers = 0;
    // Frames in which a live pass uses a depth image as attachment and as input.
    uint32_t depth_inputs = 0;
    // Frames in which a live pass samples a table of textures.
    uint32_t tables = 0;
    uint32_t culled = 0;
    uint32_t merged_scopes = 0;
    // Frames with a live pass that draws several views.
    uint32_t views = 0;

    // Counts the features of one plan. `omitted` is RandomText::omitted: a condition removed a pass or
    // changed an input.
    void add(const FramePlan& plan, bool omitted = false);
    // Returns the share of frames with each feature, in percent.
    [[nodiscard]] std::string text() const;

 private:
    void add_views(const FramePlan& plan);
    void add_indirect(const FramePlan& plan);
    void add_samplers(const FramePlan& plan);
};

}  // namespace weft::test
