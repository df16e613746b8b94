// Purpose: draws the graph of passes for the HTML page.
#pragma once

#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_page_repeats.h"

namespace weft {

// Draws the graph. If `folded` is true, each entry of PlanPage::repeats is one box with a link to the drawing
// of all iterations.
void draw_graph(const PlanPage& page, bool folded, Markup& out);

// Id of the page element with the drawing of all iterations, to which the "+" link of a repeat's box leads.
inline constexpr const char* kRoundsId = "rounds";

}  // namespace weft
