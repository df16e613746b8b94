// Purpose: a plan as the HTML page shows it: every barrier, wait and edge numbered, so that all panels and
// explanations name the same thing in the same way, and the columns that the panels share.
// Keys: p3 is pass 3 of the plan, r4 a resource, b12 a barrier, w0 a wait, s1 a submission, e7 an edge,
// g0 a repeat.
// Units: pixels of the page.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"
#include "weft/report/plan_dump.h"

namespace weft {

enum class BarrierPlace : uint8_t { prologue, before_pass, after_pass, epilogue };

struct BarrierItem {
    const BarrierDecl* barrier = nullptr;
    BarrierPlace place = BarrierPlace::before_pass;
    uint32_t position = kNoId;  // of the pass it stands beside
};

// All resources for which one pass has to follow another, for one kind of reason.
struct EdgeItem {
    PassId from = kNoId;
    PassId to = kNoId;
    EdgeKind kind = EdgeKind::raw;
    bool history = false;  // `to` reads what `from` wrote in an earlier frame
    std::vector<ResourceId> resources;
};

// The rounds of a repeat that the graph may draw as one box.
struct RepeatItem {
    std::string name;            // without the round's number
    std::vector<PassId> passes;  // as they run
};

struct WaitItem {
    uint32_t batch = 0;  // which waits
    const QueueWait* wait = nullptr;
};

// Where a pass stands in the panels that share their columns. In front of it is room for its barriers.
struct PageColumn {
    int32_t left_px = 0;
    int32_t width_px = 0;
    int32_t box_left_px = 0;
    int32_t box_width_px = 0;
};

struct PageColumns {
    std::vector<PageColumn> passes;  // by position
    PageColumn prologue, epilogue;   // width 0: there is none
    int32_t width_px = 0;
    bool rotated_labels = false;  // names stand above at a slant: there are too many to lie flat

    // The column of a position; past the last one: the end of the frame.
    [[nodiscard]] const PageColumn& at(uint32_t position) const {
        return position < passes.size() ? passes[position] : epilogue;
    }
};

struct PlanPage {
    const FramePlan* plan = nullptr;
    PlanPageInfo info;
    std::vector<BarrierItem> barriers;  // prologue, position by position, epilogue
    std::vector<EdgeItem> edges;        // sorted
    std::vector<RepeatItem> repeats;    // of many rounds
    std::vector<WaitItem> waits;
    std::vector<std::vector<PassId>> users;  // by resource, ascending
    PageColumns columns;
};

[[nodiscard]] PlanPage make_page(const FramePlan& plan, const PlanPageInfo& info);
[[nodiscard]] PageColumns make_columns(const PlanPage& page);

[[nodiscard]] std::string pass_key(PassId pass);
[[nodiscard]] std::string resource_key(ResourceId resource);
[[nodiscard]] std::string barrier_key(size_t barrier);
[[nodiscard]] std::string wait_key(size_t wait);
[[nodiscard]] std::string batch_key(size_t batch);
[[nodiscard]] std::string edge_key(size_t edge);
[[nodiscard]] std::string repeat_key(size_t repeat);

// The things an element of the page stands for and belongs to, itself first: "b12 p3 r4".
[[nodiscard]] std::string pass_keys(const PlanPage& page, PassId pass);
[[nodiscard]] std::string resource_keys(const PlanPage& page, ResourceId resource);
[[nodiscard]] std::string barrier_keys(const PlanPage& page, size_t barrier);
[[nodiscard]] std::string wait_keys(const PlanPage& page, size_t wait);
[[nodiscard]] std::string batch_keys(const PlanPage& page, size_t batch);
[[nodiscard]] std::string edge_keys(const PlanPage& page, size_t edge);
[[nodiscard]] std::string repeat_keys(const PlanPage& page, size_t repeat);

// Written by passes that run and read by none, in this frame or a later one. Who takes an import is not
// known.
[[nodiscard]] bool has_no_reader(const PlanPage& page, ResourceId resource);
// The barriers that stand right before or after the pass at a position, by index.
[[nodiscard]] std::vector<size_t> barriers_at(const PlanPage& page, BarrierPlace place, uint32_t position);
[[nodiscard]] const std::string& pass_at(const FramePlan& plan, uint32_t position);

}  // namespace weft
