// Writes the graph section of the page: the drawings and the zoom buttons.
#include <algorithm>
#include <tuple>

#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_html_graph_drawing.h"

namespace weft {
namespace {

// Writes the zoom buttons. They are hidden until the page's script shows them; without a script the drawing
// keeps its size and can be scrolled.
void write_zoom(Markup& out) {
    out.open("div",
             {{"class", "zoom"}, {"role", "group"}, {"aria-label", "Size of the drawing"}, {"hidden", ""}});
    for (const auto& [name, text, title] :
         {std::tuple{"out", "\xE2\x88\x92", "Smaller (key -, or Ctrl and the wheel)"},
          std::tuple{"in", "+", "Larger (key +, or Ctrl and the wheel)"},
          std::tuple{"fit", "Fit", "The whole width (key f)"},
          std::tuple{"full", "100 %", "Original size (key 0)"}})
        out.leaf("button", {{"type", "button"}, {"data-zoom", name}, {"title", title}, {"aria-label", title}},
                 text);
    out.leaf("output", {}, "");
    out.close();
    out.line();
}

// Draws the graph twice. The first drawing shows each long repeat as one box. The second drawing, in a
// `details` element, shows all iterations. While this element is open, the first drawing is hidden.
void draw_both(const PlanPage& page, Markup& out) {
    out.open("div", {{"class", "folded"}});
    draw_graph(page, true, out);
    out.close();
    out.open("details", {{"class", "rounds"}});
    out.leaf("summary", {},
             "Every iteration: " + std::to_string(page.plan->schedule.order.size()) + " passes");
    out.open("div", {{"id", kRoundsId}});
    draw_graph(page, false, out);
    out.close();
    out.close();
}

void write_graph_legend(const PlanPage& page, Markup& out) {
    std::vector<std::pair<const char*, const char*>> used;
    const auto add = [&](const char* kind, const char* style, const char* text) {
        if (std::any_of(page.edges.begin(), page.edges.end(),
                        [&](const EdgeItem& e) { return std::string_view(edge_style(e)) == kind; }))
            used.emplace_back(style, text);
    };
    add("raw", "edge raw", "reads the result of the other pass");
    add("war", "edge war", "overwrites content that the other pass reads");
    add("waw", "edge waw", "overwrites content that the other pass writes");
    add("after", "edge after", "order set by \"after\"");
    add("history", "edge history", "reads content of an earlier frame");
    if (page.plan->schedule.order.size() < page.plan->graph.passes.size())
        used.emplace_back("pass dead", "culled");
    if (!page.repeats.empty())
        used.emplace_back("pass repeat", "a repeat of many iterations; + draws each iteration");
    write_legend(out, used);
}

}  // namespace

void write_graph(const PlanPage& page, Markup& out) {
    open_panel(
        out, "graph", "Graph",
        "Which pass must run before which, from left to right. An edge represents all resources that two "
        "passes share.");
    if (page.plan->graph.passes.empty()) {
        out.leaf("p", {{"class", "none"}}, "The graph has no passes.");
    } else {
        write_zoom(out);
        if (page.repeats.empty())
            draw_graph(page, false, out);
        else
            draw_both(page, out);
    }
    write_graph_legend(page, out);
    out.close();
}

}  // namespace weft
