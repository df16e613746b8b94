// Writes the tables below the drawings: groups, resources that outlive the frame or are unused, and culled
// passes.
#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "graph/plan/plan_names.h"
#include "graph/report/group_phrases.h"
#include "graph/report/html/html_sections.h"
#include "weft/report/memory_report.h"

namespace weft {
namespace {

void open_table(Markup& out, const std::vector<const char*>& columns) {
    out.open("div", {{"class", "scroll"}});
    out.open("table");
    out.open("thead");
    out.open("tr");
    for (const char* column : columns) out.leaf("th", {{"scope", "col"}}, column);
    out.close();
    out.close();
    out.open("tbody");
    out.line();
}

void close_table(Markup& out) {
    for (int i = 0; i < 3; ++i) out.close();
    out.line();
}

std::string shape_text(const ResourceDecl& r) {
    if (r.textures > 0) return count_text(r.textures, "texture");
    if (r.kind == ResourceKind::buffer) return "buffer, " + bytes_text(r.size_bytes);
    return std::string(format_info(r.format).name) + ", " + std::to_string(r.extent.width) + " \xC3\x97 " +
           std::to_string(r.extent.height);
}

std::string lasts_text(const FramePlan& plan, ResourceId id) {
    const ResourceDecl& r = plan.graph.resources[id];
    if (!plan.live.live_resources[id]) return "unused: no running pass uses it";
    if (!r.texture_files.empty()) return "table of textures from files";
    if (r.textures > 0) return "table of textures of the program";
    if (!r.file.empty()) return "content of the file " + r.file;
    if (r.lifetime == ResourceLifetime::imported)
        return r.import ? std::string("imported: before the frame in layout ") +
                              layout_text(r.import->entry.layout) + ", after the frame in layout " +
                              layout_text(r.import->exit.layout)
                        : "imported";
    if (r.age > 0)
        return "content of " + plan.graph.resources[r.ring].name + " from " + count_text(r.age, "frame") +
               " ago";
    const std::string kept = r.history > 0 ? "keeps " + count_text(r.history, "earlier frame")
                                           : "keeps its content from frame to frame";
    if (!r.between) return kept;
    return kept + "; the program reads it between frames" +
           (r.kind == ResourceKind::image ? std::string(" in layout ") + layout_text(r.between->layout) : "");
}

void write_kept_row(const PlanPage& page, ResourceId id, Markup& out) {
    const ResourceDecl& r = page.plan->graph.resources[id];
    const uint64_t bytes = placed_bytes(*page.plan, id);
    const std::string lasts = lasts_text(*page.plan, id);
    out.open("tr");
    out.open("th", {{"scope", "row"}});
    open_item(out, "cellname", resource_keys(page, id), r.name + ": " + lasts);
    out.text(r.name);
    out.close();
    out.close();
    out.leaf("td", {}, shape_text(r));
    out.leaf("td", {{"class", "number"}}, bytes > 0 ? bytes_text(bytes) : "\xE2\x80\x93");
    out.leaf("td", {}, lasts);
    out.close();
    out.line();
}

}  // namespace

void write_kept(const PlanPage& page, Markup& out) {
    const FramePlan& plan = *page.plan;
    open_panel(out, "kept", "Kept and imported",
               "Resources that live longer than the frame, and resources that no pass uses.");
    std::vector<ResourceId> ids;
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id)
        if (plan.graph.resources[id].lifetime != ResourceLifetime::transient || !plan.live.live_resources[id])
            ids.push_back(id);
    if (ids.empty()) {
        out.leaf("p", {{"class", "none"}}, "The graph has no such resources.");
    } else {
        open_table(out, {"resource", "type", "memory", "lifetime"});
        for (const ResourceId id : ids) write_kept_row(page, id, out);
        close_table(out);
    }
    out.close();
}

void write_groups(const PlanPage& page, Markup& out) {
    const FramePlan& plan = *page.plan;
    if (plan.graph.groups.empty()) return;
    open_panel(out, "groups", "Groups",
               "The passes of a group make rounds. Each frame runs some of the rounds, in any order.");
    open_table(out, {"group", "rounds", "passes", "turns"});
    for (const GroupDecl& group : plan.graph.groups) {
        const auto passes = std::ranges::count_if(plan.schedule.order, [&](PassId pass) {
            return plan.graph.passes[pass].rest_unit != kNoId &&
                   group.has_unit(plan.graph.passes[pass].rest_unit);
        });
        out.open("tr");
        out.leaf("th", {{"scope", "row"}}, group.name);
        out.leaf("td", {{"class", "number"}}, std::to_string(group.rounds));
        out.leaf("td", {{"class", "number"}}, std::to_string(passes));
        out.leaf("td", {}, describe_group(group));
        out.close();
        out.line();
    }
    close_table(out);
    out.close();
}

void write_culled(const PlanPage& page, Markup& out) {
    const FramePlan& plan = *page.plan;
    open_panel(out, "culled", "Culled", "Passes that do not run, because no output depends on them.");
    if (plan.schedule.order.size() == plan.graph.passes.size()) {
        out.leaf("p", {{"class", "none"}}, "Every pass runs.");
        out.close();
        return;
    }
    open_table(out, {"pass", "type", "why"});
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass) {
        if (plan.live.live_passes[pass]) continue;
        const PassDecl& decl = plan.graph.passes[pass];
        out.open("tr");
        out.open("th", {{"scope", "row"}});
        open_item(out, "cellname", pass_keys(page, pass),
                  decl.name + " is culled: " + plan.live.details[pass]);
        out.text(decl.name);
        out.close();
        out.close();
        out.leaf("td", {}, decl.type);
        out.leaf("td", {}, plan.live.details[pass]);
        out.close();
        out.line();
    }
    close_table(out);
    out.close();
}

}  // namespace weft
