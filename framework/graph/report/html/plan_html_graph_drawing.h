// Purpose: one drawing of the page's graph.
#pragma once

#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_page_repeats.h"

namespace weft {

// `folded`: repeats of many rounds are one box each, with a link to the drawing of all rounds.
void draw_graph(const PlanPage& page, bool folded, Markup& out);

// The id of the page element that the link in such a box leads to.
inline constexpr const char* kRoundsId = "rounds";

}  // namespace weft
