// Purpose: collects the faults of a plan and reports each cause once: the same two passes and resource give
// one message, in however many subresources and frames the fault occurs.
#pragma once

#include <set>
#include <string>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft::check {

// The last user of a resource, for messages.
struct Actor {
    PassId pass = kNoId;  // kNoId: the program outside the graph
    uint32_t frame = 0;
    bool transition = false;  // true: a layout transition before that pass
    QueueIndex queue = 0;
    uint32_t batch_count = 0;  // batches of its queue up to and including its own; 0: before all frames
    uint32_t scope = 0;        // for drawing: its rendering scope, counted over all frames from 1; else 0
    uint32_t barriers = 0;     // number of barrier batches recorded earlier on its queue
};

class FaultList {
 public:
    explicit FaultList(const FramePlan& plan) : plan_(plan) {}

    // `loc` is the place in the source of the faulty use.
    void add(const char* code, SourceLoc loc, const std::string& message, const std::string& help);
    [[nodiscard]] bool any(const char* code) const;
    [[nodiscard]] std::string pass_name(PassId pass) const;              // in quotes
    [[nodiscard]] std::string resource_name(ResourceId resource) const;  // in quotes
    [[nodiscard]] std::string actor_text(const Actor& actor, uint32_t current_frame) const;
    [[nodiscard]] Diagnostics take() { return std::move(faults_); }

 private:
    const FramePlan& plan_;
    std::set<std::string> seen_;
    Diagnostics faults_;
};

}  // namespace weft::check
