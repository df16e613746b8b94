// Purpose: what changed between two plans, told by names: passes and resources added, removed and changed,
// the order, barriers, memory. Two plans with one hash differ in nothing. Units: bytes. Shapes: a thing that
// is in both plans has the facts that only the first (`gone`) and only the second (`come`) states about it.
// Where in memory a resource lies is no fact of it: that shifts with everything else.
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
    std::string name;  // "barriers", "heap_bytes", …
    uint64_t from = 0, to = 0;
};

struct PlanDiff {
    bool same = false;  // one hash
    std::vector<CountChange> counts;
    NamesDiff passes;  // live or culled is one of their facts, barriers before them are others
    NamesDiff resources;
    std::vector<PassMove> moved;  // the fewest that explain the new order of what runs in both
};

[[nodiscard]] PlanDiff diff_plans(const FramePlan& from, const FramePlan& to);

// "+2 barriers, -14.0 MiB heap", then what is behind it. One line where nothing changed.
[[nodiscard]] std::string plan_diff_to_text(const PlanDiff& diff);
// {same counts{name: {from to}} passes{added removed changed[{name gone come}]} resources{…} moved[{name from
// to}]}
[[nodiscard]] std::string plan_diff_to_json(const PlanDiff& diff);

}  // namespace weft
