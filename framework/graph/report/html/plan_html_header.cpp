#include "graph/diagnostics/quantity_text.h"
#include "graph/plan/plan_names.h"
#include "graph/report/html/html_sections.h"
#include "graph/report/live_phrases.h"
#include "weft/compile.h"

namespace weft {
namespace {

void write_fact(Markup& out, const char* name, const std::string& value) {
    if (value.empty()) return;
    out.open("div");
    out.leaf("dt", {}, name);
    out.leaf("dd", {}, value);
    out.close();
}

std::string queues_text(const FramePlan& plan) {
    std::string text;
    for (uint32_t q = 0; q < plan.schedule.queues.size(); ++q)
        text += (q > 0 ? ", " : "") + std::to_string(q) + ": " + enum_name(plan.schedule.queues[q].kind);
    return text;
}

void write_facts(const PlanPage& page, Markup& out) {
    const FramePlan& plan = *page.plan;
    out.open("dl", {{"class", "facts"}});
    write_fact(out, "file", page.info.file);
    write_fact(out, "tier", page.info.tier);
    write_fact(out, "profile", page.info.profile);
    write_fact(out, "output",
               std::to_string(plan.graph.output_extent.width) + " \xC3\x97 " +
                   std::to_string(plan.graph.output_extent.height));
    write_fact(out, plan.schedule.queues.size() == 1 ? "queue" : "queues", queues_text(plan));
    write_fact(out, "order", plan.schedule.chosen);
    std::string areas;
    for (const std::string& area : list_areas(plan.graph)) areas += (areas.empty() ? "" : "; ") + area;
    write_fact(out, "areas", areas);
    write_fact(out, "hash", plan_hash(plan));
    out.close();
    out.line();
}

void write_tile(Markup& out, const std::string& value, const char* what, const std::string& more) {
    out.open("li");
    out.leaf("b", {}, value);
    out.leaf("span", {}, what);
    if (!more.empty()) out.leaf("small", {}, more);
    out.close();
}

std::string of_text(size_t all, const char* what) {
    std::string text = "of ";
    return text.append(std::to_string(all)).append(" ").append(what);
}

void write_tiles(const PlanPage& page, Markup& out) {
    const FramePlan& plan = *page.plan;
    const MemoryPlan& memory = plan.memory;
    const size_t live = plan.schedule.order.size(), all = plan.graph.passes.size();
    out.open("ul", {{"class", "tiles"}});
    write_tile(out, std::to_string(live), live == 1 ? "pass runs" : "passes run",
               live == all ? "" : of_text(all, "in the graph"));
    write_tile(out, std::to_string(plan.barriers.emitted),
               plan.barriers.emitted == 1 ? "barrier" : "barriers", "per frame");
    write_tile(out, std::to_string(plan.submissions.batches.size()),
               plan.submissions.batches.size() == 1 ? "submission" : "submissions",
               count_text(page.waits.size(), "wait"));
    write_tile(out, bytes_text(memory.heap_bytes), "for transients",
               "sum of all sizes: " + bytes_text(memory.sum_bytes));
    const uint64_t saved = memory.sum_bytes > memory.heap_bytes ? memory.sum_bytes - memory.heap_bytes : 0;
    write_tile(out, percent_text(saved, memory.sum_bytes), "saved by aliasing", bytes_text(saved));
    if (memory.persistent_bytes > 0)
        write_tile(out, bytes_text(memory.persistent_bytes), "for kept resources", "from frame to frame");
    out.close();
    out.line();
}

}  // namespace

void write_header(const PlanPage& page, Markup& out) {
    out.open("header");
    out.leaf("h1", {}, page.plan->graph.name);
    write_facts(page, out);
    write_tiles(page, out);
    out.open("nav", {{"aria-label", "Panels"}});
    for (const auto& [id, title] : {std::pair{"graph", "Graph"}, std::pair{"timeline", "Timeline"},
                                    std::pair{"lifetimes", "Lifetimes"}, std::pair{"memory", "Memory"},
                                    std::pair{"groups", "Groups"}, std::pair{"kept", "Kept and imported"},
                                    std::pair{"culled", "Culled"}, std::pair{"words", "All explanations"}})
        if (std::string_view(id) != "groups" || !page.plan->graph.groups.empty())
            out.leaf("a", {{"href", std::string("#") + id}}, title);
    out.close();
    out.close();
    out.line();
}

}  // namespace weft
