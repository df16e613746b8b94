// Writes the elements that all sections with pass columns share: the pass names above the columns and the
// vertical lines between them.
#include <algorithm>

#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_page_sizes.h"

namespace weft {
namespace {

constexpr int32_t kFlatHeading_px = 30;

// Writes the name of the column of the prologue or epilogue. A column of width 0 gets no name.
void write_end(const PageColumn& column, const char* name, int32_t y_px, Markup& out) {
    if (column.width_px == 0) return;
    out.leaf("text", {{"class", "kind mid"}, {"x", column.left_px + column.width_px / 2}, {"y", y_px}}, name);
}

}  // namespace

bool open_column_panel(const PlanPage& page, Markup& out, const char* id, const char* title,
                       const std::string& text) {
    open_panel(out, id, title, text);
    const bool runs = !page.plan->schedule.order.empty();
    if (!runs) out.leaf("p", {{"class", "none"}}, "No pass runs.");
    return runs;
}

int32_t heading_height_px(const PlanPage& page) {
    if (!page.columns.rotated_labels) return kFlatHeading_px;
    int32_t longest_px = 0;
    for (Position p(0); p < page.plan->schedule.order.size(); ++p)
        longest_px = std::max(longest_px, rotated_label_px(pass_at(*page.plan, p)));
    return kFlatHeading_px + longest_px;
}

void write_heading(const PlanPage& page, Markup& out) {
    const int32_t bottom_px = heading_height_px(page) - 10;
    for (Position p(0); p < page.plan->schedule.order.size(); ++p) {
        const PageColumn& column = page.columns.passes[p];
        const PassId pass = page.plan->schedule.order[p];
        const std::string& name = page.plan->graph.passes[pass].name;
        const int32_t x_px = column.box_left_px + column.box_width_px / 2;
        open_item(out, "title", pass_keys(page, pass), std::to_string(p) + " " + name);
        if (page.columns.rotated_labels) {
            std::string transform = "translate(";
            transform += std::to_string(x_px) + " " + std::to_string(bottom_px) + ") rotate(-45)";
            out.leaf("text", {{"class", "name"}, {"transform", transform}}, short_name(name));
        } else {
            const size_t fits = characters_in(column.box_width_px);
            const std::string numbered = std::to_string(p) + " " + name;
            out.leaf("text", {{"class", "name mid"}, {"x", x_px}, {"y", bottom_px}},
                     short_name(numbered.size() <= fits ? numbered : name));
        }
        out.close();
    }
    write_end(page.columns.prologue, "once", bottom_px, out);
    write_end(page.columns.epilogue, "end", bottom_px, out);
    out.line();
}

void write_guides(const PlanPage& page, int32_t top_px, int32_t bottom_px, Markup& out) {
    std::string path;
    const auto line = [&](int32_t x_px) {
        path += "M" + std::to_string(x_px) + " " + std::to_string(top_px) + "V" + std::to_string(bottom_px);
    };
    for (const PageColumn& column : page.columns.passes) line(column.left_px - 5);
    if (!page.columns.passes.empty())
        line(page.columns.passes.back().left_px + page.columns.passes.back().width_px + 5);
    out.empty("path", {{"class", "guide"}, {"d", path}});
}

void ColumnDrawing::open_labels(const std::string& style) {
    out_.open("ol", {{"class", style}, {"style", "padding-top:" + std::to_string(top_px_) + "px"}});
}

void ColumnDrawing::open_columns(const std::string& label, int32_t height_px) {
    open_drawing(out_, label, page_.columns.width_px, height_px);
    write_heading(page_, out_);
    write_guides(page_, top_px_, height_px, out_);
}

}  // namespace weft
