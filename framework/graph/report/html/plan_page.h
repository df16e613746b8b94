// Purpose: prepares a plan for the HTML page. It numbers every barrier, wait and edge, so that all sections
// and explanations use the same keys, and computes the columns that several sections share.
// A key is a letter and an index. Examples: p3 is the pass with index 3, r4 a resource, b12 a barrier, w0 a
// wait, s1 a submission (batch), e7 an edge, g0 a repeat.
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
    Position position = kNoId;  // Position of the barrier's pass; kNoId in the prologue and epilogue.
};

// All dependencies of one kind between two passes, shown as one edge: `to` must run after `from`. `resources`
// lists the resources that cause these dependencies.
struct EdgeItem {
    PassId from = kNoId;
    PassId to = kNoId;
    EdgeKind kind = EdgeKind::raw;
    bool history = false;  // True if `to` reads content that `from` wrote in an earlier frame.
    std::vector<ResourceId> resources;
};

// A repeat with many iterations. The picture of the plan can show all passes of the repeat as one box.
struct RepeatItem {
    std::string name;  // Name of the repeat, such as "down" if its passes are "down#1", "down#2" ...
    std::vector<PassId> passes;  // The passes of its iterations, in schedule order.
};

struct WaitItem {
    uint32_t batch = 0;  // Index of the batch that waits for another batch.
    const QueueWait* wait = nullptr;
};

// The column of a pass in the drawings of the page. It has the marks of the barriers before the pass, then
// the pass's box, then the marks of the barriers after the pass.
struct PageColumn {
    int32_t left_px = 0;
    int32_t width_px = 0;
    int32_t box_left_px = 0;
    int32_t box_width_px = 0;
};

struct PageColumns {
    std::vector<PageColumn> passes;  // Index: schedule position. Column of the pass there.
    PageColumn prologue, epilogue;   // Columns at both ends of the frame; not drawn if their width is 0.
    int32_t width_px = 0;
    // True if the names above the columns are rotated by 45°, because there are too many for horizontal text.
    bool rotated_labels = false;

    // Returns the column of a position. A position after the last pass is the end of the frame.
    [[nodiscard]] const PageColumn& at(Position position) const {
        return position < passes.size() ? passes[position] : epilogue;
    }
};

struct PlanPage {
    const FramePlan* plan = nullptr;
    PlanPageInfo info;
    // All barriers: first those of the prologue, then those of the passes in schedule order, then those of
    // the epilogue.
    std::vector<BarrierItem> barriers;
    std::vector<EdgeItem> edges;      // All edges, sorted by history, from, to and kind.
    std::vector<RepeatItem> repeats;  // Repeats with many iterations.
    std::vector<WaitItem> waits;
    // Index: ResourceId. The passes that use the resource, ascending.
    std::vector<std::vector<PassId>> users;
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

// Each returns the key of the element itself, followed by the keys of related elements, such as "b12 r4 p3".
[[nodiscard]] std::string pass_keys(const PlanPage& page, PassId pass);
[[nodiscard]] std::string resource_keys(const PlanPage& page, ResourceId resource);
[[nodiscard]] std::string barrier_keys(const PlanPage& page, size_t barrier);
[[nodiscard]] std::string wait_keys(const PlanPage& page, size_t wait);
[[nodiscard]] std::string batch_keys(const PlanPage& page, size_t batch);
[[nodiscard]] std::string edge_keys(const PlanPage& page, size_t edge);
[[nodiscard]] std::string repeat_keys(const PlanPage& page, size_t repeat);

// Returns true if live passes write the resource but none reads it, in this frame or a later one. Returns
// false for an import, because the program outside the graph may read it.
[[nodiscard]] bool has_no_reader(const PlanPage& page, ResourceId resource);
// Returns the barriers at a place, as indices into PlanPage::barriers. For `before_pass` and `after_pass`,
// `position` is the schedule position of the pass. For `prologue` and `epilogue`, `position` is kNoId.
[[nodiscard]] std::vector<size_t> barriers_at(const PlanPage& page, BarrierPlace place, Position position);
[[nodiscard]] const std::string& pass_at(const FramePlan& plan, Position position);

}  // namespace weft
