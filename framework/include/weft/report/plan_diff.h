// Purpose: the differences between two plans by name: passes and resources added, removed and changed, the
// order, barriers, memory. Plans with equal hashes have no differences. Units: bytes. Shapes: an item in both
// plans lists the facts that only the first plan (`gone`) or only the second plan (`come`) has. The offset of
// a resource in memory is not compared, because it changes whenever anything else does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

struct FactsChange {
    std::string name;
    std::vector<std::string> gone;
    std::vector<std::string> come;
};

struct NamesDiff {
    std::vector<std::string> added, removed;
    std::vector<FactsChange> changed;
};

struct PassMove {
    std::string name;
    uint32_t from = 0, to = 0;  // positions
};

struct CountChange {
    std::string name;  // such as "barriers", "heap_bytes"
    uint64_t from = 0, to = 0;
};

struct PlanDiff {
    bool same = false;  // the hashes are equal
    std::vector<CountChange> counts;
    NamesDiff passes;  // includes whether a pass is live and its barriers
    NamesDiff resources;
    std::vector<PassMove> moved;  // the smallest set of moves that explains the new order of the common
                                  // passes
};

[[nodiscard]] PlanDiff diff_plans(const FramePlan& from, const FramePlan& to);

// "+2 barriers, -14.0 MiB heap", followed by details. One line if nothing changed.
[[nodiscard]] std::string plan_diff_to_text(const PlanDiff& diff);
// {same counts{name: {from to}} passes{added removed changed[{name gone come}]} resources{…} moved[{name from
// to}]}
[[nodiscard]] std::string plan_diff_to_json(const PlanDiff& diff);

}  // namespace weft
