// Purpose: the parts of the HTML page. Each writes one section; what it draws carries the keys of
// plan_page.h, links to its explanation, and says in its label what a pointer over it reads.
#pragma once

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
void write_kept(const PlanPage& page, Markup& out);
void write_culled(const PlanPage& page, Markup& out);
void write_words(const PlanPage& page, Markup& out);  // every explanation

// An element that can be pointed at, focused and selected. `keys`: itself first; that is where it links to.
void open_item(Markup& out, const std::string& style, const std::string& keys, const std::string& label);
// Heading, and what it shows in a line.
void open_panel(Markup& out, const char* id, const char* title, const std::string& text);
// One whose columns are the passes that run. Where none does it says so and returns false: nothing is to be
// drawn.
[[nodiscard]] bool open_column_panel(const PlanPage& page, Markup& out, const char* id, const char* title,
                                     const std::string& text);
// "frame" around a drawing that scrolls sideways together with its like.
void open_drawing(Markup& out, const std::string& label, int32_t width_px, int32_t height_px);
void close_drawing(Markup& out);
void write_legend(Markup& out, const std::vector<std::pair<const char*, const char*>>& styles_and_texts);
// Names of all passes above the panels that share their columns. Returns the height it takes.
[[nodiscard]] int32_t heading_height_px(const PlanPage& page);
void write_heading(const PlanPage& page, Markup& out);
// The lines between columns, from `top_px` down.
void write_guides(const PlanPage& page, int32_t top_px, int32_t bottom_px, Markup& out);

// Texts of labels.
[[nodiscard]] std::string barrier_label(const PlanPage& page, size_t barrier);
[[nodiscard]] std::string edge_label(const PlanPage& page, size_t edge);
[[nodiscard]] std::string wait_label(const PlanPage& page, size_t wait);

// The style of a barrier's mark: by the kind of its reason.
[[nodiscard]] const char* barrier_style(BarrierReason reason);
// By what the edge is there for: "raw", "war", "waw", "after", "history".
[[nodiscard]] const char* edge_style(const EdgeItem& edge);

[[nodiscard]] std::string_view page_style();   // html/page.css
[[nodiscard]] std::string_view page_script();  // html/page.js

}  // namespace weft
