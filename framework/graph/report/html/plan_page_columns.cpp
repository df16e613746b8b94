// Computes the width of the column of every pass. A column has the marks of the pass's barriers and the box
// with the name of the pass.
#include <algorithm>

#include "graph/report/html/plan_page.h"
#include "graph/report/html/plan_page_sizes.h"

namespace weft {
namespace {

constexpr int32_t kGap_px = 10;
constexpr int32_t kMostFlatWidth_px = 2400;
constexpr int32_t kRotatedBox_px = 30;
constexpr int32_t kWaitGap_px = 36;  // Space for the arrow of a wait.

int32_t marks_width_px(size_t barriers) {
    const size_t rows = std::min(barriers, kMarkRows);
    return rows == 0 ? 0 : static_cast<int32_t>((barriers + rows - 1) / rows) * kMarkStepX_px;
}

// Returns true if the plan has a batch without passes, which only records the barriers at the end of the
// frame.
bool ends_alone(const FramePlan& plan) {
    return std::any_of(plan.submissions.batches.begin(), plan.submissions.batches.end(),
                       [](const Batch& batch) { return batch.positions.empty(); });
}

// Returns the column for the barriers of the prologue or epilogue. Its width is 0 if there is nothing to
// show.
PageColumn end_column(const PlanPage& page, BarrierPlace place, int32_t left_px) {
    const size_t count = barriers_at(page, place, kNoId).size();
    const bool submitted = place == BarrierPlace::epilogue && ends_alone(*page.plan);
    if (count == 0 && !submitted) return {left_px, 0, left_px, 0};
    const int32_t width_px = std::max(marks_width_px(count), kEndColumn_px);
    return {left_px, width_px + 2 * kGap_px, left_px + kGap_px, width_px};
}

int32_t boxes_width_px(const FramePlan& plan) {
    int32_t width_px = 0;
    for (Position p(0); p < plan.schedule.order.size(); ++p)
        width_px += name_width_px(pass_at(plan, p)) + kGap_px;
    return width_px;
}

// Returns true if a batch that waits for another queue begins at this position.
bool waits_before(const FramePlan& plan, Position position) {
    return std::any_of(
        plan.submissions.batches.begin(), plan.submissions.batches.end(), [&](const Batch& batch) {
            return !batch.waits.empty() && !batch.positions.empty() && batch.positions.front() == position;
        });
}

// Returns a minimum width for the boxes of passes. It makes the columns of a frame with few passes fill
// kRoomyWidth_px, but it is at most kRoomyBox_px.
int32_t roomy_box_px(const PlanPage& page) {
    const auto count = static_cast<int32_t>(page.plan->schedule.order.size());
    if (count == 0) return 0;
    int32_t rest_px = kRoomyWidth_px - 2 * kGap_px - count * 2 * kGap_px;
    for (const BarrierPlace place : {BarrierPlace::prologue, BarrierPlace::epilogue})
        rest_px -= end_column(page, place, 0).width_px;
    for (Position p(0); p < page.plan->schedule.order.size(); ++p)
        rest_px -= waits_before(*page.plan, p) ? kWaitGap_px : 0;
    for (Position p(0); p < page.plan->schedule.order.size(); ++p)
        for (const BarrierPlace place : {BarrierPlace::before_pass, BarrierPlace::after_pass})
            rest_px -= marks_width_px(barriers_at(page, place, p).size());
    return std::clamp(rest_px / count, 0, kRoomyBox_px);
}

}  // namespace

int32_t name_width_px(const std::string& name) {
    return static_cast<int32_t>(std::min(name.size(), kMostNameCharacters)) * 15 / 2 + 20;
}

int32_t rotated_label_px(const std::string& name) {
    return name_width_px(name) * 71 / 100;
}

size_t characters_in(int32_t width_px) {
    return static_cast<size_t>(std::max(0, width_px)) * 2 / 15;
}

std::string small_text_in(const std::string& text, int32_t width_px) {
    constexpr int32_t kCharacter_px = 7, kEllipsis_px = 14;
    const auto characters = [](int32_t px) { return static_cast<size_t>(std::max(0, px) / kCharacter_px); };
    if (text.size() <= characters(width_px)) return text;
    const size_t fits = characters(width_px - kEllipsis_px) + 1;
    return fits < kLeastNameCharacters ? "" : short_name(text, fits);
}

std::string short_name(const std::string& name, size_t most_characters) {
    if (name.size() <= most_characters) return name;
    return name.substr(0, most_characters - 1) + "\xE2\x80\xA6";
}

PageColumns make_columns(const PlanPage& page) {
    const FramePlan& plan = *page.plan;
    PageColumns columns;
    columns.rotated_labels = boxes_width_px(plan) > kMostFlatWidth_px;
    columns.prologue = end_column(page, BarrierPlace::prologue, 0);
    const int32_t roomy_px = roomy_box_px(page);
    int32_t x_px = columns.prologue.width_px + kGap_px;
    for (Position p(0); p < plan.schedule.order.size(); ++p) {
        const int32_t before_px = marks_width_px(barriers_at(page, BarrierPlace::before_pass, p).size());
        const int32_t after_px = marks_width_px(barriers_at(page, BarrierPlace::after_pass, p).size());
        const int32_t box_px =
            columns.rotated_labels ? kRotatedBox_px : std::max(roomy_px, name_width_px(pass_at(plan, p)));
        if (waits_before(plan, p)) x_px += kWaitGap_px;
        PageColumn column{x_px, 0, x_px + before_px + kGap_px / 2, box_px};
        column.width_px = before_px + box_px + after_px + kGap_px;
        x_px += column.width_px + kGap_px;
        columns.passes.push_back(column);
    }
    columns.epilogue = end_column(page, BarrierPlace::epilogue, x_px);
    columns.width_px = x_px + columns.epilogue.width_px + kGap_px;
    if (columns.rotated_labels) {
        const PageColumn& last = columns.passes.back();
        const int32_t name_px = rotated_label_px(pass_at(plan, Position(columns.passes.size() - 1)));
        columns.width_px = std::max(columns.width_px, last.box_left_px + last.box_width_px + name_px);
    }
    return columns;
}

}  // namespace weft
