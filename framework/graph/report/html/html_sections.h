// Purpose: writes the sections of the HTML page of a plan. An element that represents an item of the plan,
// such as a pass or a barrier, has three things: the keys defined in plan_page.h, a link to its explanation,
// and a label that appears when the pointer is over it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graph/report/html/markup.h"
#include "graph/report/html/plan_page.h"

namespace weft {

void write_header(const PlanPage& page, Markup& out);
void write_graph(const PlanPage& page, Markup& out);
void write_timeline(const PlanPage& page, Markup& out);
void write_lifetimes(const PlanPage& page, Markup& out);
void write_memory(const PlanPage& page, Markup& out);
// Writes nothing if the graph has no groups.
void write_groups(const PlanPage& page, Markup& out);
void write_kept(const PlanPage& page, Markup& out);
void write_culled(const PlanPage& page, Markup& out);
// Writes the last section: all explanations of the page as text.
void write_explanations(const PlanPage& page, Markup& out);

// Opens an element that reacts to the pointer, gets keyboard focus and can be selected. `keys` begins with
// the element's own key, which is also the target of its link.
void open_item(Markup& out, const std::string& style, const std::string& keys, const std::string& label);
// Opens a section with a heading. `text` is one line that says what the section shows.
void open_panel(Markup& out, const char* id, const char* title, const std::string& text);
// Opens a section with one column per live pass. If no pass is live, it writes a sentence about this and
// returns false; then the caller must not draw.
[[nodiscard]] bool open_column_panel(const PlanPage& page, Markup& out, const char* id, const char* title,
                                     const std::string& text);
// Opens an SVG drawing in a scrollable area. The areas of all drawings with pass columns scroll sideways
// together.
void open_drawing(Markup& out, const std::string& label, int32_t width_px, int32_t height_px);
void close_drawing(Markup& out);
struct BoxPx {
    int32_t left = 0, top = 0, width = 0, height = 0;
};
// Draws a rectangle. `style` is its class, and `round_px` the radius of its corners.
void draw_box(Markup& out, const std::string& style, const BoxPx& box,
              std::optional<int32_t> round_px = std::nullopt);
void write_legend(Markup& out, const std::vector<std::pair<const char*, const char*>>& styles_and_texts);
// Returns the height of the heading: the names of the live passes, at the top of each drawing with pass
// columns.
[[nodiscard]] int32_t heading_height_px(const PlanPage& page);
void write_heading(const PlanPage& page, Markup& out);
// Draws the vertical lines between the columns of passes, from `top_px` to `bottom_px`.
void write_guides(const PlanPage& page, int32_t top_px, int32_t bottom_px, Markup& out);

// The base of drawings with pass columns: labels at the left, and the drawing itself.
class ColumnDrawing {
 public:
    ColumnDrawing(const PlanPage& page, Markup& out)
        : page_(page), plan_(*page.plan), out_(out), top_px_(heading_height_px(page)) {}

 protected:
    // Opens the list of labels beside the drawing. `style` is its class.
    void open_labels(const std::string& style);
    // Opens the drawing, and draws its heading and the lines between the columns.
    void open_columns(const std::string& label, int32_t height_px);

    const PlanPage& page_;
    const FramePlan& plan_;
    Markup& out_;
    int32_t top_px_;  // The height of the heading.
};

// Each of these functions returns a label of a barrier, edge or wait. The label appears when the pointer is
// over this item. The parameter is an index into PlanPage::barriers, PlanPage::edges or PlanPage::waits.
[[nodiscard]] std::string barrier_label(const PlanPage& page, size_t barrier);
[[nodiscard]] std::string edge_label(const PlanPage& page, size_t edge);
[[nodiscard]] std::string wait_label(const PlanPage& page, size_t wait);

// Returns the CSS class for the mark of a barrier with this reason.
[[nodiscard]] const char* barrier_style(BarrierReason reason);
// Returns the CSS class of an edge, which is the reason of the edge: "raw", "war", "waw", "after" or
// "history".
[[nodiscard]] const char* edge_style(const EdgeItem& edge);

[[nodiscard]] std::string_view page_style();   // Returns the text of html/page.css.
[[nodiscard]] std::string_view page_script();  // Returns the text of html/page.js.

}  // namespace weft
