// Writes the explanations of passes, repeats and resources. This file also has the functions that all
// explanations use.
#include <algorithm>

#include "graph/plan/plan_names.h"
#include "graph/report/explain_phrases.h"
#include "graph/report/group_phrases.h"
#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_html_articles.h"
#include "graph/report/plan_phrases.h"
#include "weft/report/plan_explain.h"

namespace weft {
namespace {

std::string pass_subtitle(const FramePlan& plan, PassId pass) {
    const PassDecl& decl = plan.graph.passes[pass];
    std::string text = decl.type + " pass";
    if (!decl.shader.empty()) text += ", shader " + decl.shader;
    if (const std::string round = describe_round(plan, pass); !round.empty()) text += ", " + round;
    const Position position = plan.schedule.position[pass];
    if (position == kNoId) return text + ", culled";
    return text + ", runs at position " + std::to_string(position) + " on queue " +
           std::to_string(plan.schedule.queue[position]);
}

void write_uses(const FramePlan& plan, PassId pass, Markup& out) {
    for (const bool output : {false, true}) {
        std::vector<ArticleLink> links;
        for (const UseDecl& use : plan.graph.passes[pass].uses) {
            if (use.is_output != output) continue;
            const ResourceDecl& resource = plan.graph.resources[use.resource];
            std::string more = use.range == resource.whole() ? "" : range_text(resource, use.range) + " ";
            more += std::string("port ") + use.port + ", " + access_name(use.access);
            links.push_back({resource_key(use.resource), resource.name, more});
        }
        write_links(out, output ? "Outputs" : "Inputs", links);
    }
}

void write_attachments(const FramePlan& plan, PassId pass, Markup& out) {
    const Position position = plan.schedule.position[pass];
    if (position == kNoId) return;
    std::vector<ArticleLink> links;
    for (const AttachmentOps& ops : plan.barriers.steps[position].attachments) {
        const ResourceId id = plan.graph.passes[pass].uses[ops.use].resource;
        links.push_back({resource_key(id), plan.graph.resources[id].name,
                         std::string("load ") + enum_name(ops.load) + ", store " + enum_name(ops.store)});
    }
    write_links(out, "Attachments", links);
}

void write_pass_barriers(const PlanPage& page, PassId pass, Markup& out) {
    const Position position = page.plan->schedule.position[pass];
    if (position == kNoId) return;
    for (const BarrierPlace place : {BarrierPlace::before_pass, BarrierPlace::after_pass}) {
        std::vector<ArticleLink> links;
        for (const size_t b : barriers_at(page, place, position)) {
            const BarrierDecl& barrier = *page.barriers[b].barrier;
            links.push_back({barrier_key(b), page.plan->graph.resources[barrier.resource].name,
                             describe_reason(barrier.reason)});
        }
        write_links(
            out, place == BarrierPlace::before_pass ? "Barriers before the pass" : "Barriers after the pass",
            links);
    }
}

void write_needed_by(const PlanPage& page, PassId pass, Markup& out) {
    std::vector<ArticleLink> links;
    const auto begin = std::lower_bound(page.edges.begin(), page.edges.end(), std::make_pair(false, pass),
                                        [](const EdgeItem& e, const std::pair<bool, PassId>& wanted) {
                                            return std::make_pair(e.history, e.from) < wanted;
                                        });
    for (auto it = begin; it != page.edges.end() && it->from == pass && !it->history; ++it)
        if (it->kind == EdgeKind::raw)
            links.push_back({pass_key(it->to), page.plan->graph.passes[it->to].name, ""});
    write_links(out, "Passes that read its results", links);
}

void write_alias_transitions(const FramePlan& plan, ResourceId id, Markup& out) {
    std::vector<ResourceId> others;
    for (const AliasTransition& h : plan.memory.alias_transitions) {
        if (h.from == h.to || (h.from != id && h.to != id)) continue;
        const ResourceId other = h.from == id ? h.to : h.from;
        if (std::find(others.begin(), others.end(), other) == others.end()) others.push_back(other);
    }
    for (const ResourceId other : others) write_sentences(out, describe_alias_transitions(plan, id, other));
}

}  // namespace

void open_article(Markup& out, const std::string& key, const std::string& title, const std::string& below) {
    out.open("article", {{"id", key}});
    out.leaf("h3", {}, title);
    if (!below.empty()) out.leaf("p", {{"class", "below"}}, below);
}

void write_sentences(Markup& out, const std::string& text) {
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const size_t first = std::min(text.find_first_not_of(' ', begin), end);
        if (first < end) out.leaf("p", {}, text.substr(first, end - first));
        begin = end + 1;
    }
}

void write_links(Markup& out, const char* title, const std::vector<ArticleLink>& links) {
    if (links.empty()) return;
    out.leaf("h4", {}, title);
    out.open("ul");
    for (const ArticleLink& link : links) {
        out.open("li");
        out.leaf("a", {{"href", "#" + link.key}}, link.text);
        if (!link.more.empty()) {
            out.text(" ");
            out.leaf("span", {}, link.more);
        }
        out.close();
    }
    out.close();
}

void write_pass_article(const PlanPage& page, PassId pass, Markup& out) {
    const FramePlan& plan = *page.plan;
    const std::string& name = plan.graph.passes[pass].name;
    open_article(out, pass_key(pass), name, pass_subtitle(plan, pass));
    if (!plan.live.live_passes[pass])
        if (const Result<std::string> why = explain_culled(plan, name)) write_sentences(out, *why);
    if (!plan.graph.passes[pass].lowering_reason.empty())
        if (const Result<std::string> how = explain_views(plan, name)) write_sentences(out, *how);
    if (plan.graph.passes[pass].rest_unit != kNoId)
        if (const Result<std::string> why = explain_rest(plan, name)) write_sentences(out, *why);
    const auto depends = [](const UseDecl& use) { return use.used_in != kEveryCombination; };
    if (plan.graph.passes[pass].switch_id != kNoId ||
        std::ranges::any_of(plan.graph.passes[pass].uses, depends))
        if (const Result<std::string> why = explain_switch(plan, name)) write_sentences(out, *why);
    write_uses(plan, pass, out);
    write_attachments(plan, pass, out);
    write_pass_barriers(page, pass, out);
    write_needed_by(page, pass, out);
    out.close();
    out.line();
}

void write_repeat_article(const PlanPage& page, size_t repeat, Markup& out) {
    const RepeatItem& item = page.repeats[repeat];
    open_article(out, repeat_key(repeat), item.name,
                 "a repeat of " + std::to_string(item.passes.size()) + " iterations");
    std::vector<ArticleLink> links;
    for (const PassId pass : item.passes)
        links.push_back({pass_key(pass), page.plan->graph.passes[pass].name,
                         "runs at position " + std::to_string(page.plan->schedule.position[pass])});
    write_links(out, "Iterations", links);
    out.close();
    out.line();
}

void write_resource_article(const PlanPage& page, ResourceId resource, Markup& out) {
    const FramePlan& plan = *page.plan;
    const ResourceDecl& decl = plan.graph.resources[resource];
    open_article(out, resource_key(resource), decl.name,
                 std::string(enum_name(decl.lifetime)) + " " + enum_name(decl.kind));
    if (const Result<std::string> what = explain_resource(plan, decl.name)) write_sentences(out, *what);
    write_alias_transitions(plan, resource, out);
    out.close();
    out.line();
}

void write_explanations(const PlanPage& page, Markup& out) {
    const FramePlan& plan = *page.plan;
    out.open("section", {{"class", "panel"}, {"id", "words"}, {"aria-label", "All explanations"}});
    out.open("details");
    out.leaf("summary", {}, "All explanations of this page as text");
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass) write_pass_article(page, pass, out);
    for (size_t r = 0; r < page.repeats.size(); ++r) write_repeat_article(page, r, out);
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) write_resource_article(page, id, out);
    for (size_t b = 0; b < page.barriers.size(); ++b) write_barrier_article(page, b, out);
    for (size_t w = 0; w < page.waits.size(); ++w) write_wait_article(page, w, out);
    for (size_t s = 0; s < plan.submissions.batches.size(); ++s) write_batch_article(page, s, out);
    for (size_t e = 0; e < page.edges.size(); ++e) write_edge_article(page, e, out);
    out.close();
    out.close();
    out.line();
}

}  // namespace weft
