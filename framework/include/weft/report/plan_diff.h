// Purpose: compares two plans by name: passes, resources and groups that were added, removed or changed, the
// order, barriers, memory. Plans with equal hashes have no differences. Units: bytes. Each property of a pass
// or resource is a line of text. If a pass or resource is in both plans, FactsChange::gone has the lines that
// only the first plan has, and `come` the lines that only the second plan has. The offset of a resource in
// memory is not compared, because almost every other change changes it, too.
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
    // Position of the pass in the first plan (`from`) and in the second plan (`to`).
    uint32_t from = 0, to = 0;
};

struct CountChange {
    std::string name;  // Name of the number, such as "barriers" or "heap_bytes".
    uint64_t from = 0, to = 0;
};

struct PlanDiff {
    bool same = false;  // True: the hashes of the plans are equal.
    std::vector<CountChange> counts;
    // The changes of passes, also of their barriers, and of whether a pass is live (not culled).
    NamesDiff passes;
    NamesDiff resources;
    NamesDiff groups;
    // The smallest set of moves that changes the first order into the second. Only passes in both plans are
    // listed.
    std::vector<PassMove> moved;
};

[[nodiscard]] PlanDiff diff_plans(const FramePlan& from, const FramePlan& to);

// Returns a summary such as "+2 barriers, -14.0 MiB heap", followed by details; one line if nothing changed.
[[nodiscard]] std::string plan_diff_to_text(const PlanDiff& diff);
// Returns the differences as JSON with the members of PlanDiff:
// { same, counts: { NAME: { from, to } }, passes: { added, removed, changed: [{ name, gone, come }] },
//   resources and groups: (like passes), moved: [{ name, from, to }] }
[[nodiscard]] std::string plan_diff_to_json(const PlanDiff& diff);

}  // namespace weft
