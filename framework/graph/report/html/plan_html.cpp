// Writes the whole HTML page: its head, its structure, and elements that several sections use.
#include <algorithm>

#include "graph/plan/plan_names.h"
#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_page_sizes.h"
#include "graph/report/plan_phrases.h"

namespace weft {
namespace {

constexpr const char* kPolicy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

void write_head(const PlanPage& page, Markup& out) {
    out.open("head");
    out.empty("meta", {{"charset", "utf-8"}});
    out.empty("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
    out.empty("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", kPolicy}});
    out.leaf("title", {}, "Plan of " + page.plan->graph.name);
    out.open("style");
    out.raw(page_style());
    out.close();
    out.close();
    out.line();
}

// Writes the area that shows the explanation of the item under the pointer or of the selected item.
void write_inspector(Markup& out) {
    out.open("aside", {{"id", "inspector"}, {"aria-live", "polite"}});
    out.leaf("h2", {}, "Explanation");
    out.open("div", {{"id", "explained"}});
    out.leaf("p", {},
             "Point at an item, or move to it with Tab and the arrow keys. Its explanation appears here.");
    out.leaf("p", {},
             "Click an item or press Enter to select it: related items stay bright in all panels. Press "
             "Escape to end the selection.");
    out.close();
    out.close();
    out.line();
}

std::string place_label(const PlanPage& page, const BarrierItem& item) {
    switch (item.place) {
        case BarrierPlace::prologue:
            return "once, before the first frame";
        case BarrierPlace::before_pass:
            return "before " + pass_at(*page.plan, item.position);
        case BarrierPlace::after_pass:
            return "after " + pass_at(*page.plan, item.position);
        case BarrierPlace::epilogue:
            return "at the end of the frame";
    }
    return "";
}

}  // namespace

void open_item(Markup& out, const std::string& style, const std::string& keys, const std::string& label) {
    out.open("a", {{"class", "i " + style},
                   {"href", "#" + keys.substr(0, keys.find(' '))},
                   {"data-k", keys},
                   {"aria-label", label}});
}

void open_panel(Markup& out, const char* id, const char* title, const std::string& text) {
    out.open("section", {{"class", "panel"}, {"id", id}, {"aria-label", title}});
    out.leaf("h2", {}, title);
    out.leaf("p", {{"class", "lead"}}, text);
}

void open_drawing(Markup& out, const std::string& label, int32_t width_px, int32_t height_px) {
    const std::string width = std::to_string(width_px), height = std::to_string(height_px);
    out.open("div", {{"class", "scroll"}});
    std::string box = "0 0 ";
    box.append(width).append(" ").append(height);
    out.open(
        "svg",
        {{"width", width}, {"height", height}, {"viewBox", box}, {"role", "group"}, {"aria-label", label}});
}

void close_drawing(Markup& out) {
    out.close();
    out.close();
    out.line();
}

void draw_box(Markup& out, const std::string& style, const BoxPx& box, std::optional<int32_t> round_px) {
    Markup::Attributes attributes{
        {"class", style}, {"x", box.left}, {"y", box.top}, {"width", box.width}, {"height", box.height}};
    if (round_px) attributes.emplace_back("rx", *round_px);
    out.empty("rect", attributes);
}

void write_legend(Markup& out, const std::vector<std::pair<const char*, const char*>>& styles_and_texts) {
    out.open("ul", {{"class", "legend"}});
    for (const auto& [style, text] : styles_and_texts) {
        out.open("li");
        out.leaf("span", {{"class", std::string("swatch ") + style}, {"aria-hidden", "true"}}, "");
        out.text(text);
        out.close();
    }
    out.close();
    out.line();
}

std::string barrier_label(const PlanPage& page, size_t barrier) {
    const BarrierItem& item = page.barriers[barrier];
    std::string part = describe_part(*page.plan, item.barrier->resource, item.barrier->range);
    part.erase(std::remove(part.begin(), part.end(), '"'), part.end());
    std::string reason = enum_name(item.barrier->reason);
    std::replace(reason.begin(), reason.end(), '_', ' ');
    return "barrier on " + part + " " + place_label(page, item) + ": " + reason;
}

std::string edge_label(const PlanPage& page, size_t edge) {
    const EdgeItem& item = page.edges[edge];
    const auto& passes = page.plan->graph.passes;
    std::string text = passes[item.from].name + " to " + passes[item.to].name + ": ";
    for (size_t i = 0; i < item.resources.size(); ++i)
        text += (i > 0 ? ", " : "") + page.plan->graph.resources[item.resources[i]].name;
    if (item.kind == EdgeKind::after) text += "an \"after\"";
    return text + (item.history ? ", from frame to frame" : "");
}

std::string wait_label(const PlanPage& page, size_t wait) {
    const WaitItem& item = page.waits[wait];
    const std::vector<Batch>& batches = page.plan->submissions.batches;
    return "queue " + std::to_string(batches[item.batch].queue) + " waits for queue " +
           std::to_string(batches[item.wait->batch].queue) +
           (item.wait->previous_frame ? " of the previous frame" : "");
}

const char* barrier_style(BarrierReason reason) {
    switch (reason) {
        case BarrierReason::raw:
            return "raw";
        case BarrierReason::war:
        case BarrierReason::waw:
            return "over";
        case BarrierReason::layout:
            return "layout";
        case BarrierReason::alias:
            return "handover";
        case BarrierReason::release_queue:
        case BarrierReason::acquire_queue:
            return "family";
        default:
            return "outside";
    }
}

const char* edge_style(const EdgeItem& edge) {
    return edge.history ? "history" : enum_name(edge.kind);
}

std::string plan_to_html(const FramePlan& plan, const PlanPageInfo& info) {
    const PlanPage page = make_page(plan, info);
    Markup out;
    out.raw("<!DOCTYPE html>\n");
    out.open("html", {{"lang", "en"}});
    write_head(page, out);
    out.open("body");
    out.open("div", {{"id", "page"}});
    out.open("div", {{"id", "content"}});
    write_header(page, out);
    out.open("main");
    write_graph(page, out);
    write_timeline(page, out);
    write_lifetimes(page, out);
    write_memory(page, out);
    write_groups(page, out);
    write_kept(page, out);
    write_culled(page, out);
    write_explanations(page, out);
    out.close();
    out.close();
    write_inspector(out);
    out.close();
    out.leaf("div", {{"id", "tip"}, {"aria-hidden", "true"}}, "");
    out.open("script");
    out.raw(page_script());
    out.close();
    out.close();
    out.close();
    out.line();
    return out.take();
}

}  // namespace weft
