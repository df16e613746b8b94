// Purpose: collects the errors of a plan. An error with the same code and message as an earlier error is not
// added again. So an error that occurs in every frame is reported once.
#pragma once

#include <set>
#include <string>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft::check {

// Describes an access or a layout transition: its pass, frame, queue and batch. It is used in checks and in
// messages.
struct Actor {
    // The pass of the access or transition. kNoId: the prologue, the epilogue, or the program outside the
    // graph.
    PassId pass = kNoId;
    uint32_t frame = 0;
    // True for a layout transition or ownership transfer by a barrier before or after the pass; false for the
    // pass's own access.
    bool transition = false;
    QueueIndex queue = kGraphicsQueue;
    // Number of batches that the queue of the actor has begun, including the actor's own batch. 0: before all
    // frames.
    uint32_t batch_count = 0;
    // For an attachment access: number of the rendering scope of this access, counted over all frames from 1.
    // Otherwise 0.
    uint32_t scope = 0;
    uint32_t barriers = 0;  // Number of earlier vkCmdPipelineBarrier2 calls on the actor's queue.
};

class FaultList {
 public:
    explicit FaultList(const FramePlan& plan) : plan_(plan) {}

    // Adds an error. `loc` is the place in the graph's file that the message shows; an empty SourceLoc shows
    // none.
    void add(const char* code, SourceLoc loc, const std::string& message, const std::string& help);
    [[nodiscard]] bool any(const char* code) const;
    // Returns the name in quotes; for kNoId, returns "outside the graph" without quotes.
    [[nodiscard]] std::string pass_name(PassId pass) const;
    // Returns the name in quotes, such as "hdr".
    [[nodiscard]] std::string resource_name(ResourceId resource) const;
    // Returns the name of a part of a resource, such as "hdr".mip(0).layer(0).
    [[nodiscard]] std::string part_name(ResourceId resource, const SubresourceRange& range) const;
    [[nodiscard]] std::string actor_text(const Actor& actor, uint32_t current_frame) const;
    [[nodiscard]] Diagnostics take() { return std::move(faults_); }

 private:
    const FramePlan& plan_;
    std::set<std::string> seen_;
    Diagnostics faults_;
};

}  // namespace weft::check
