// Purpose: what a set of random frames and their plans has in it, so that a test can show that it tests
// something.
#pragma once

#include <cstdint>
#include <string>

#include "weft/plan.h"

namespace weft::test {

struct GraphCoverage {
    uint32_t graphs = 0;
    uint32_t hand_overs = 0;  // between two resources
    uint32_t several_queues = 0;
    uint32_t waits = 0;      // across queues, within a frame
    uint32_t transfers = 0;  // between queue families
    uint32_t history = 0;    // live
    uint32_t kept = 0;
    uint32_t ranges = 0;        // barriers on parts of images
    uint32_t repeats = 0;       // live rounds of repeats
    uint32_t chains = 0;        // live mip chains of graphs made in memory
    uint32_t conditionals = 0;  // something was left out for a condition, or read instead
    uint32_t after = 0;         // edges
    uint32_t depth_inputs = 0;  // attachment and input at once
    uint32_t culled = 0;
    uint32_t merged_scopes = 0;

    // `left_out`: what RandomText says.
    void add(const FramePlan& plan, bool left_out = false);
    [[nodiscard]] std::string text() const;  // shares in percent
};

}  // namespace weft::test
