// Draws the timeline section: one row per queue with its batches, passes and barriers in submission order,
// and arrows for semaphore waits.
#include <algorithm>

#include "graph/plan/plan_names.h"
#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_page_sizes.h"
#include "graph/sync/scopes.h"

namespace weft {
namespace {

constexpr int32_t kLaneTop_px = 22;  // Space at the top of a batch for its name.
constexpr int32_t kRowHeight_px = static_cast<int32_t>(kMarkRows) * kMarkStepY_px;
constexpr int32_t kLaneHeight_px = kLaneTop_px + kRowHeight_px + 10;
constexpr int32_t kLaneGap_px = 26;  // Gap between rows, with space for the arrows of waits.
constexpr int32_t kStub_px = 26;

int32_t lane_top_px(size_t row) {
    return static_cast<int32_t>(row) * (kLaneHeight_px + kLaneGap_px);
}

// Returns the queues that have at least one batch, in ascending order. Other queues get no row.
std::vector<uint32_t> used_queues(const FramePlan& plan) {
    std::vector<uint32_t> used;
    for (uint32_t q = 0; q < plan.schedule.queues.size(); ++q)
        if (std::any_of(plan.submissions.batches.begin(), plan.submissions.batches.end(),
                        [&](const Batch& batch) { return batch.queue == q; }))
            used.push_back(q);
    return used;
}

class TimelineDrawing : ColumnDrawing {
 public:
    TimelineDrawing(const PlanPage& page, Markup& out)
        : ColumnDrawing(page, out), queues_(used_queues(*page.plan)) {}

    void draw() {
        const int32_t height_px = top_px_ + lane_top_px(queues_.size()) - kLaneGap_px + 4;
        out_.open("div", {{"class", "chart"}});
        write_labels();
        open_columns("Timeline of the queues", height_px);
        for (size_t batch = 0; batch < plan_.submissions.batches.size(); ++batch) draw_batch(batch);
        for (Position p(0); p < plan_.schedule.order.size(); ++p) draw_scope(p);
        for (Position p(0); p < plan_.schedule.order.size(); ++p) draw_pass(p);
        draw_end(BarrierPlace::prologue, page_.columns.prologue, queues_[0]);
        draw_end(BarrierPlace::epilogue, page_.columns.epilogue, epilogue_queue());
        draw_waits();
        close_drawing(out_);
        out_.close();
    }

 private:
    void write_labels() {
        open_labels("labels lanes");
        for (const uint32_t q : queues_) {
            const int32_t height_px = q == queues_[0] ? kLaneHeight_px : kLaneHeight_px + kLaneGap_px;
            out_.open("li", {{"style", "height:" + std::to_string(height_px) + "px;padding-top:" +
                                           std::to_string(height_px - kLaneHeight_px) + "px"}});
            out_.leaf("b", {{"class", "q" + std::to_string(q)}}, "queue " + std::to_string(q));
            out_.leaf("span", {}, enum_name(plan_.schedule.queues[q].kind));
            out_.leaf("small", {}, "family " + std::to_string(plan_.schedule.queues[q].family));
            out_.close();
        }
        out_.close();
    }

    uint32_t epilogue_queue() const {
        for (const Batch& batch : plan_.submissions.batches)
            if (batch.epilogue) return batch.queue;
        return queues_[0];
    }

    int32_t batch_left_px(const Batch& batch) const {
        return batch.positions.empty() ? page_.columns.epilogue.left_px
                                       : page_.columns.passes[batch.positions.front()].left_px - 5;
    }
    int32_t batch_right_px(const Batch& batch) const {
        const PageColumn& end = page_.columns.epilogue;
        if (batch.positions.empty() || (batch.epilogue && end.width_px > 0))
            return end.left_px + end.width_px;
        const PageColumn& last = page_.columns.passes[batch.positions.back()];
        return last.left_px + last.width_px + 5;
    }
    int32_t lane_px(uint32_t queue) const {
        const auto row = std::find(queues_.begin(), queues_.end(), queue) - queues_.begin();
        return top_px_ + lane_top_px(static_cast<size_t>(row));
    }
    int32_t middle_px(const Batch& batch) const {
        return lane_px(batch.queue) + kLaneTop_px + kRowHeight_px / 2;
    }

    void draw_batch(size_t index) {
        const Batch& batch = plan_.submissions.batches[index];
        const int32_t left_px = batch_left_px(batch), width_px = batch_right_px(batch) - left_px;
        open_item(out_, "batch q" + std::to_string(batch.queue), batch_keys(page_, index),
                  "submission " + std::to_string(index) + " of queue " + std::to_string(batch.queue));
        draw_box(out_, "box", {left_px, lane_px(batch.queue), width_px, kLaneHeight_px}, 8);
        const std::string number = std::to_string(index), name = "submission " + number;
        const int32_t room_px = width_px - 12;
        const bool fits = small_text_in(name, room_px) == name;
        out_.leaf("text", {{"class", "kind"}, {"x", left_px + 8}, {"y", lane_px(batch.queue) + 15}},
                  fits ? name : small_text_in("sub " + number, room_px));
        out_.close();
        out_.line();
    }

    void draw_pass(Position position) {
        const PageColumn& column = page_.columns.passes[position];
        const uint32_t queue = plan_.schedule.queue[position];
        const int32_t y_px = lane_px(queue) + kLaneTop_px;
        const PassId pass = plan_.schedule.order[position];
        draw_marks(barriers_at(page_, BarrierPlace::before_pass, position), column.left_px, y_px);
        open_item(out_, "pass q" + std::to_string(queue), pass_keys(page_, pass),
                  std::to_string(position) + " " + plan_.graph.passes[pass].name);
        draw_box(out_, "box", {column.box_left_px, y_px, column.box_width_px, kRowHeight_px}, 4);
        const int32_t middle_px = column.box_left_px + column.box_width_px / 2;
        if (!page_.columns.rotated_labels)
            out_.leaf("text", {{"class", "name mid"}, {"x", middle_px}, {"y", y_px + kRowHeight_px / 2 - 2}},
                      short_name(plan_.graph.passes[pass].name));
        const int32_t kind_y_px = y_px + kRowHeight_px / 2 + (page_.columns.rotated_labels ? 4 : 15);
        out_.leaf("text", {{"class", "kind mid"}, {"x", middle_px}, {"y", kind_y_px}},
                  small_text_in(below_name(position), column.box_width_px - 4));
        out_.close();
        draw_marks(barriers_at(page_, BarrierPlace::after_pass, position),
                   column.box_left_px + column.box_width_px + 4, y_px);
        out_.line();
    }

    std::string below_name(Position position) const {
        return page_.columns.rotated_labels ? std::to_string(position)
                                            : plan_.graph.passes[plan_.schedule.order[position]].type;
    }

    // Draws a bar from the previous pass to this pass if both share a rendering scope.
    void draw_scope(Position position) {
        const PassId before = continued_pass(plan_, position);
        if (before == kNoId) return;
        const PageColumn& from = page_.columns.passes[plan_.schedule.position[before]];
        const uint32_t queue = plan_.schedule.queue[position];
        const int32_t left_px = from.box_left_px + from.box_width_px;
        draw_box(out_, "scope q" + std::to_string(queue),
                 {left_px, lane_px(queue) + kLaneTop_px + kRowHeight_px / 2 - 4,
                  page_.columns.passes[position].box_left_px - left_px, 8});
    }

    void draw_marks(const std::vector<size_t>& barriers, int32_t left_px, int32_t top_px) {
        for (size_t i = 0; i < barriers.size(); ++i) {
            const BarrierDecl& barrier = *page_.barriers[barriers[i]].barrier;
            const int32_t x_px = left_px + static_cast<int32_t>(i / kMarkRows) * kMarkStepX_px;
            const int32_t y_px = top_px + static_cast<int32_t>(i % kMarkRows) * kMarkStepY_px + 1;
            open_item(out_, std::string("barrier ") + barrier_style(barrier.reason),
                      barrier_keys(page_, barriers[i]), barrier_label(page_, barriers[i]));
            draw_box(out_, "hit", {x_px - 1, y_px - 1, kMarkStepX_px, kMarkStepY_px});
            draw_box(out_, "mark", {x_px, y_px, kMark_px, kMark_px}, 2);
            out_.close();
        }
    }

    void draw_end(BarrierPlace place, const PageColumn& column, uint32_t queue) {
        if (column.width_px > 0)
            draw_marks(barriers_at(page_, place, kNoId), column.box_left_px, lane_px(queue) + kLaneTop_px);
    }

    void draw_waits() {
        std::vector<int32_t> drawn(plan_.submissions.batches.size(), 0);
        for (size_t w = 0; w < page_.waits.size(); ++w) draw_wait(w, drawn[page_.waits[w].batch]++);
    }

    // Draws a wait as an arrow. It leads from the end of one batch to the start of the batch that waits for
    // it. If the first batch belongs to the previous frame, the arrow starts at a dot instead. `nth` counts
    // the waits of the waiting batch from 0; it shifts the arrow.
    void draw_wait(size_t index, int32_t nth) {
        const WaitItem& item = page_.waits[index];
        const Batch &to = plan_.submissions.batches[item.batch],
                    &from = plan_.submissions.batches[item.wait->batch];
        const bool before = item.wait->previous_frame;
        const bool upward = from.queue > to.queue;
        const int32_t to_x = batch_left_px(to) - 5,
                      to_y = middle_px(to) + (upward ? 12 : -12) + (upward ? 6 : -6) * nth;
        const int32_t from_x = before ? to_x - kStub_px : batch_right_px(from);
        const int32_t from_y =
            before ? lane_px(to.queue) + (upward ? kLaneHeight_px + 10 + 6 * nth : -10 - 6 * nth)
                   : middle_px(from);
        const int32_t bend_px = std::max(kStub_px, (to_x - from_x) / 2);
        const auto point = [](int32_t x, int32_t y) { return std::to_string(x) + " " + std::to_string(y); };
        const std::string path =
            before ? "M" + point(from_x, from_y) + "Q" + point(from_x, to_y) + " " + point(to_x, to_y)
                   : "M" + point(from_x, from_y) + "C" + point(from_x + bend_px, from_y) + " " +
                         point(to_x - bend_px, to_y) + " " + point(to_x, to_y);
        open_item(out_, std::string("wait") + (before ? " before" : ""), wait_keys(page_, index),
                  wait_label(page_, index));
        out_.empty("path", {{"class", "hit"}, {"d", path}});
        out_.empty("path", {{"class", "line"}, {"d", path}, {"marker-end", "url(#head-wait)"}});
        if (before) out_.empty("circle", {{"class", "origin"}, {"cx", from_x}, {"cy", from_y}, {"r", 4}});
        out_.close();
        out_.line();
    }

    std::vector<uint32_t> queues_;  // The queues that have a row in the drawing; at least one.
};

void write_idle_queues(const FramePlan& plan, Markup& out) {
    const std::vector<uint32_t> used = used_queues(plan);
    std::string names;
    size_t idle = 0;
    for (uint32_t q = 0; q < plan.schedule.queues.size(); ++q) {
        if (std::find(used.begin(), used.end(), q) != used.end()) continue;
        names += (idle++ > 0 ? ", " : "") + std::to_string(q) + " (" +
                 enum_name(plan.schedule.queues[q].kind) + ")";
    }
    if (idle > 0)
        out.leaf("p", {{"class", "none"}},
                 std::string("No pass runs on ") + (idle == 1 ? "queue " : "queues ") + names + ".");
}

void write_timeline_legend(const PlanPage& page, Markup& out) {
    std::vector<std::pair<const char*, const char*>> used;
    const auto add = [&](const char* kind, const char* style, const char* text) {
        if (std::any_of(page.barriers.begin(), page.barriers.end(), [&](const BarrierItem& item) {
                return std::string_view(barrier_style(item.barrier->reason)) == kind;
            }))
            used.emplace_back(style, text);
    };
    add("raw", "barrier raw", "a read after a write");
    add("over", "barrier over", "a write after a read or a write");
    add("layout", "barrier layout", "a change of the layout");
    add("handover", "barrier handover", "memory passes to another resource");
    add("family", "barrier family", "a transfer between queue families");
    add("outside", "barrier outside", "the start or end of an import, or first-frame values");
    const std::vector<PassStep>& steps = page.plan->barriers.steps;
    if (std::any_of(steps.begin(), steps.end(), [](const PassStep& s) { return s.merges_render_pass; }))
        used.emplace_back("scope", "continues the same rendering scope");
    if (!page.waits.empty()) used.emplace_back("wait", "a queue waits for another queue");
    if (std::any_of(page.waits.begin(), page.waits.end(),
                    [](const WaitItem& w) { return w.wait->previous_frame; }))
        used.emplace_back("wait before", "a queue waits for the previous frame");
    write_legend(out, used);
}

}  // namespace

void write_timeline(const PlanPage& page, Markup& out) {
    if (open_column_panel(
            page, out, "timeline", "Timeline",
            "The passes of each queue, in the order of submission. Marks before a pass are barriers that it "
            "waits for; marks after a pass are barriers for later passes.")) {
        TimelineDrawing(page, out).draw();
        write_idle_queues(*page.plan, out);
    }
    write_timeline_legend(page, out);
    out.close();
}

}  // namespace weft
