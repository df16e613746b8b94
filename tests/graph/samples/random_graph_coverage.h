// Purpose: counts the features in a set of random frames and their plans, so that a test can show that its
// set is not trivial.
#pragma once

#include <cstdint>
#include <string>

#include "weft/plan.h"

namespace weft::test {

struct GraphCoverage {
    uint32_t graphs = 0;
    uint32_t alias_transitions = 0;  // transfers of memory between two resources
    uint32_t several_queues = 0;
    uint32_t waits = 0;      // waits across queues, within a frame
    uint32_t transfers = 0;  // ownership transfers between queue families
    uint32_t history = 0;    // live resources with history
    uint32_t kept = 0;
    uint32_t ranges = 0;        // barriers on parts of images
    uint32_t repeats = 0;       // live rounds of repeats
    uint32_t chains = 0;        // live mip chains of graphs made in memory
    uint32_t conditionals = 0;  // cases in which a condition removed something or changed an input
    uint32_t after = 0;         // edges without a shared resource
    uint32_t depth_inputs = 0;  // depth as attachment and input of the same pass
    uint32_t culled = 0;
    uint32_t merged_scopes = 0;

    // `left_out`: see RandomText.
    void add(const FramePlan& plan, bool left_out = false);
    [[nodiscard]] std::string text() const;  // fractions in percent
};

}  // namespace weft::test
