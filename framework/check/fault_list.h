// Purpose: collects what is wrong with a plan, once for each cause: the same two passes and resource are
// reported once, however many subresources and frames show it.
#pragma once

#include <set>
#include <string>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft::check {

// Who touched a resource last, for messages.
struct Actor {
    PassId pass = kNoId;  // kNoId: the program around the graph
    uint32_t frame = 0;
    bool transition = false;  // a layout transition before that pass
    QueueIndex queue = 0;
    uint32_t batch_count = 0;  // of its queue, up to and with its own batch; 0: before all frames
    uint32_t scope = 0;        // what drew: its rendering scope, counted over all frames from 1; else 0
    uint32_t barriers = 0;     // the batches of barriers that its queue had recorded before
};

class FaultList {
 public:
    explicit FaultList(const FramePlan& plan) : plan_(plan) {}

    // `loc` is where the use at fault was written.
    void add(const char* code, SourceLoc loc, const std::string& message, const std::string& help);
    [[nodiscard]] bool any(const char* code) const;
    [[nodiscard]] std::string pass_name(PassId pass) const;              // quoted
    [[nodiscard]] std::string resource_name(ResourceId resource) const;  // quoted
    [[nodiscard]] std::string actor_text(const Actor& actor, uint32_t current_frame) const;
    [[nodiscard]] Diagnostics take() { return std::move(faults_); }

 private:
    const FramePlan& plan_;
    std::set<std::string> seen_;
    Diagnostics faults_;
};

}  // namespace weft::check
