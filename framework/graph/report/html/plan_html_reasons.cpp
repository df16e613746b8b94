// Writes the explanations of barriers, waits, submissions and edges.
#include <algorithm>

#include "graph/plan/plan_names.h"
#include "graph/report/explain_phrases.h"
#include "graph/report/group_phrases.h"
#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_html_articles.h"
#include "graph/report/plan_phrases.h"

namespace weft {
namespace {

// Returns the passes for which a barrier waits:
// - If BarrierDecl::from is set: this pass.
// - Otherwise, if the barrier is in the prologue or has the reason `acquire_import`: no pass.
// - Otherwise: every live pass for which waits_for() returns true.
std::vector<PassId> waited_for(const PlanPage& page, const BarrierItem& item) {
    const BarrierDecl& barrier = *item.barrier;
    if (barrier.from != kNoId) return {barrier.from};
    if (item.place == BarrierPlace::prologue || barrier.reason == BarrierReason::acquire_import) return {};
    std::vector<ResourceId> owners = barrier.aliased_from;
    if (owners.empty()) owners.push_back(barrier.resource);
    std::vector<PassId> passes;
    for (const ResourceId owner : owners)
        for (const PassId pass : page.users[owner])
            if (page.plan->live.live_passes[pass] && waits_for(*page.plan, barrier, pass))
                passes.push_back(pass);
    std::sort(passes.begin(), passes.end());
    passes.erase(std::unique(passes.begin(), passes.end()), passes.end());
    return passes;
}

bool of_frame_before(const PlanPage& page, const BarrierItem& item, PassId pass) {
    const Position position = page.plan->schedule.position[pass];
    return item.barrier->from_previous_frame ||
           (item.position != kNoId && item.place == BarrierPlace::before_pass && position >= item.position);
}

void write_waited_for(const PlanPage& page, const BarrierItem& item, Markup& out) {
    const std::vector<PassId> passes = waited_for(page, item);
    std::vector<ArticleLink> links;
    for (const PassId pass : passes) {
        std::string more = of_frame_before(page, item, pass) ? "of the previous frame" : "";
        for (const UseDecl* use : uses_waited_for(*page.plan, *item.barrier, pass))
            more += (more.empty() ? "" : ", ") + describe_use(*page.plan, *use);
        links.push_back({pass_key(pass), page.plan->graph.passes[pass].name, more});
    }
    write_links(out, "Waits for", links);
    if (item.barrier->if_pass_runs)
        out.leaf(
            "p", {},
            "The barrier is recorded only in frames in which its pass, which may rest or wait for its turn, "
            "runs.");
    if (!passes.empty()) return;
    if (item.barrier->reason == BarrierReason::acquire_import)
        out.leaf("p", {}, "The barrier waits for uses of the import before the frame.");
    if (item.place == BarrierPlace::prologue)
        out.leaf("p", {}, "The barrier is recorded once, before the first frame.");
}

// Returns the uses by `pass` that overlap the barrier's range of its resource, as text; empty if there are
// none. Sets `writing` if one of them writes.
std::string uses_of(const FramePlan& plan, const BarrierDecl& barrier, PassId pass, bool& writing) {
    std::string text;
    for (const UseDecl& use : plan.graph.passes[pass].uses) {
        if (use.resource != barrier.resource || !overlaps(use.range, barrier.range)) continue;
        text += (text.empty() ? "" : ", ") + describe_use(plan, use);
        writing = writing || writes(use.access);
    }
    return text;
}

// Lists the passes that need the barrier. For a barrier before a pass, this is that pass. For a barrier after
// a pass, these are the later users of the range, up to and including the next writer.
void write_on_behalf_of(const PlanPage& page, const BarrierItem& item, Markup& out) {
    if (item.position == kNoId) return;
    const FramePlan& plan = *page.plan;
    const bool before = item.place == BarrierPlace::before_pass;
    std::vector<ArticleLink> links;
    bool writing = false;
    const Position first(before ? uint32_t{item.position} : item.position + 1);
    // If a barrier before the first pass of a group is recorded in every frame, it serves all rounds of the
    // group.
    const GroupBlock block = block_around(plan, item.position);
    const bool border = before && !block.empty() && !item.barrier->if_pass_runs;
    for (Position p = first; p < plan.schedule.order.size() && !writing; ++p) {
        const PassId pass = plan.schedule.order[p];
        const std::string uses = uses_of(plan, *item.barrier, pass, writing);
        const bool listed = !uses.empty() || (before && !border);
        if (listed) links.push_back({pass_key(pass), plan.graph.passes[pass].name, uses});
        if (border ? p == block.last : before) break;
    }
    if (border)
        out.leaf(
            "p", {},
            "The barrier stands before all rounds of the group, because any of them may run, in any order.");
    write_links(out, before && !border ? "Before the pass" : "For the passes", links);
}

std::string spaced(std::string text) {
    for (char& c : text) c = c == '_' ? ' ' : c == '|' ? ',' : c;
    for (size_t at = text.find(','); at != std::string::npos; at = text.find(',', at + 2))
        text.insert(at + 1, " ");
    return text;
}

void write_row(Markup& out, const char* what, const std::string& from, const std::string& to) {
    out.open("tr", {{"class", from == to ? "same" : "changes"}});
    out.leaf("th", {{"scope", "row"}}, what);
    out.leaf("td", {}, from);
    out.leaf("td", {}, to);
    out.close();
}

void write_states(const FramePlan& plan, const BarrierDecl& b, Markup& out) {
    out.open("table", {{"class", "states"}});
    out.open("tr");
    for (const char* heading : {"", "from", "to"}) out.leaf("th", {{"scope", "col"}}, heading);
    out.close();
    write_row(out, "stages", spaced(stages_text(b.src.stages)), spaced(stages_text(b.dst.stages)));
    write_row(out, "access", spaced(access_text(b.src.access)), spaced(access_text(b.dst.access)));
    if (plan.graph.resources[b.resource].kind == ResourceKind::image)
        write_row(out, "layout", spaced(layout_text(b.src.layout)), spaced(layout_text(b.dst.layout)));
    if (b.src_family != b.dst_family)
        write_row(out, "family", std::to_string(b.src_family), std::to_string(b.dst_family));
    out.close();
}

std::string describe_edge(const PlanPage& page, const EdgeItem& edge, ResourceId resource) {
    const std::string from = describe_pass(*page.plan, edge.from), to = describe_pass(*page.plan, edge.to);
    const std::string what = resource == kNoId ? "" : describe_resource(*page.plan, resource);
    if (edge.history)
        return to + " reads " + what + " with the content that " + from + " left in an earlier frame.";
    switch (edge.kind) {
        case EdgeKind::raw:
            return to + " reads " + what + ", which " + from + " writes before.";
        case EdgeKind::war:
            return to + " overwrites " + what + ", which " + from + " reads before.";
        case EdgeKind::waw:
            return to + " overwrites " + what + ", which " + from + " writes before.";
        case EdgeKind::after:
            return to + " names " + from + " in \"after\", so it runs after that pass.";
    }
    return "";
}

}  // namespace

void write_barrier_article(const PlanPage& page, size_t barrier, Markup& out) {
    const FramePlan& plan = *page.plan;
    const BarrierItem& item = page.barriers[barrier];
    const BarrierDecl& b = *item.barrier;
    open_article(out, barrier_key(barrier), barrier_label(page, barrier), "");
    out.leaf("p", {{"class", "why"}}, std::string("Reason: ") + describe_reason(b.reason) + ".");
    write_links(out, "Resource",
                {{resource_key(b.resource), plan.graph.resources[b.resource].name,
                  b.range == plan.graph.resources[b.resource].whole()
                      ? "the whole resource"
                      : range_text(plan.graph.resources[b.resource], b.range)}});
    std::vector<ArticleLink> owners;
    for (const ResourceId id : b.aliased_from)
        owners.push_back({resource_key(id), plan.graph.resources[id].name,
                          id == b.resource ? "of the previous frame: no other resource shares this memory"
                                           : "used this memory before"});
    write_links(out, "Takes over memory from", owners);
    write_waited_for(page, item, out);
    write_on_behalf_of(page, item, out);
    write_states(plan, b, out);
    out.close();
    out.line();
}

void write_wait_article(const PlanPage& page, size_t wait, Markup& out) {
    const FramePlan& plan = *page.plan;
    const WaitItem& item = page.waits[wait];
    open_article(out, wait_key(wait), wait_label(page, wait), "a semaphore");
    out.leaf(
        "p", {},
        "Before it begins, " + describe_batch(plan, plan.submissions.batches[item.batch]) +
            " waits for the end of " + describe_batch(plan, plan.submissions.batches[item.wait->batch]) +
            (item.wait->previous_frame ? " of the previous frame. The first frame does not wait." : "."));
    write_sentences(out, describe_cause(plan, item.wait->dependency));
    write_links(
        out, "Submissions",
        {{batch_key(item.wait->batch), "submission " + std::to_string(item.wait->batch), "ends before"},
         {batch_key(item.batch), "submission " + std::to_string(item.batch), "begins after"}});
    out.close();
    out.line();
}

void write_batch_article(const PlanPage& page, size_t batch, Markup& out) {
    const FramePlan& plan = *page.plan;
    const Batch& decl = plan.submissions.batches[batch];
    open_article(out, batch_key(batch), "submission " + std::to_string(batch),
                 "queue " + std::to_string(decl.queue) + ", " + std::to_string(decl.positions.size()) +
                     " pass" + (decl.positions.size() == 1 ? "" : "es"));
    std::vector<ArticleLink> passes, waits;
    for (const Position position : decl.positions)
        passes.push_back({pass_key(plan.schedule.order[position]), pass_at(plan, position), ""});
    for (size_t w = 0; w < page.waits.size(); ++w)
        if (page.waits[w].batch == batch || page.waits[w].wait->batch == batch)
            waits.push_back({wait_key(w), wait_label(page, w), ""});
    write_links(out, "Passes", passes);
    write_links(out, "Waits", waits);
    if (decl.epilogue)
        out.leaf(
            "p", {},
            "At its end, barriers change imports to the states that the program expects after the frame.");
    out.close();
    out.line();
}

void write_edge_article(const PlanPage& page, size_t edge, Markup& out) {
    const EdgeItem& item = page.edges[edge];
    const auto& passes = page.plan->graph.passes;
    open_article(out, edge_key(edge), passes[item.from].name + " to " + passes[item.to].name, "");
    if (item.resources.empty()) out.leaf("p", {}, describe_edge(page, item, kNoId));
    for (const ResourceId id : item.resources) out.leaf("p", {}, describe_edge(page, item, id));
    std::vector<ArticleLink> links;
    for (const ResourceId id : item.resources)
        links.push_back({resource_key(id), page.plan->graph.resources[id].name, ""});
    write_links(out, "Resources", links);
    out.close();
    out.line();
}

}  // namespace weft
