// The graph: passes from left to right, and why one has to follow another.
#include <algorithm>

#include "graph/layered_layout.h"
#include "graph/plan_html_edges.h"
#include "graph/plan_html_parts.h"
#include "graph/plan_names.h"
#include "graph/plan_page_sizes.h"

namespace weft {
namespace {

constexpr int32_t kBoxHeight_px = 44;
constexpr int32_t kMargin_px = 16;
constexpr int32_t kRoomyGraph_px = 880;                  // a graph of few layers fills it
constexpr int32_t kLeastGap_px = 64, kMostGap_px = 120;  // between layers
constexpr int32_t kLane_px = 20;                         // of edges from frame to frame, below the boxes
constexpr size_t kMostNamedEdges = 200;                  // more leave no room

// Edges of one kind leave and arrive at one height, so that those of other kinds can be told apart.
int32_t port_offset_px(EdgeKind kind) {
    switch (kind) {
        case EdgeKind::raw:
            return 0;
        case EdgeKind::war:
            return 9;
        case EdgeKind::waw:
            return -9;
        case EdgeKind::after:
            return 15;
    }
    return 0;
}

std::string type_text(const FramePlan& plan, PassId pass) {
    const uint32_t position = plan.schedule.position[pass];
    if (position == kNoId) return plan.graph.passes[pass].type + ", culled";
    std::string text = std::to_string(position) + "  " + plan.graph.passes[pass].type;
    if (plan.schedule.queues.size() > 1) text += ", queue " + std::to_string(plan.schedule.queue[position]);
    return text;
}

class GraphDrawing {
 public:
    GraphDrawing(const PlanPage& page, Markup& out) : page_(page), plan_(*page.plan), out_(out) {
        for (const PassId pass : plan_.schedule.order) passes_.push_back(pass);
        for (PassId pass = 0; pass < plan_.graph.passes.size(); ++pass)
            if (plan_.schedule.position[pass] == kNoId) passes_.push_back(pass);
        lay_out();
    }

    void draw() {
        find_ways();
        const auto lanes = static_cast<int32_t>(std::count_if(page_.edges.begin(), page_.edges.end(),
                                                              [](const EdgeItem& e) { return e.history; }));
        const int32_t below_px = lanes == 0 ? 0 : (lanes + 1) * kLane_px;
        const PointPx size{layout_.width_px + 2 * kMargin_px, layout_.height_px + below_px + 2 * kMargin_px};
        open_drawing(out_, "Graph of passes", size.x, size.y);
        write_arrow_heads();
        const std::vector<EdgeName> names = edge_names(size);
        for (const bool reads : {false, true})  // which lie on top
            for (size_t i = 0; i < ways_.size(); ++i)
                if ((page_.edges[drawn_[i]].kind == EdgeKind::raw) == reads)
                    draw_edge(drawn_[i], ways_[i].path(), names[i]);
        for (const PassId pass : passes_) draw_pass(pass);
        close_drawing(out_);
    }

 private:
    void lay_out() {
        std::vector<LayoutBox> boxes;
        box_of_.resize(plan_.graph.passes.size());
        for (uint32_t i = 0; i < passes_.size(); ++i) {
            const int32_t name_px = name_width_px(plan_.graph.passes[passes_[i]].name);
            const auto kind_px = static_cast<int32_t>(short_kind(passes_[i]).size()) * 7 + 20;
            boxes.push_back({std::max(name_px, kind_px) + 8, kBoxHeight_px});
            box_of_[passes_[i]] = i;
        }
        std::vector<LayoutEdge> edges;
        for (const EdgeItem& e : page_.edges)
            if (!e.history) edges.push_back({box_of_[e.from], box_of_[e.to]});
        layout_ = layered_layout(boxes, edges, kLeastGap_px);
        if (layout_.layers > 1 && layout_.width_px < kRoomyGraph_px) {
            const auto gaps = static_cast<int32_t>(layout_.layers) - 1;
            const int32_t more_px = (kRoomyGraph_px - layout_.width_px) / gaps;
            layout_ = layered_layout(boxes, edges, std::min(kLeastGap_px + more_px, kMostGap_px));
        }
        boxes_ = std::move(boxes);
    }

    std::string short_kind(PassId pass) const {
        return short_name(type_text(plan_, pass), kMostNameCharacters + 4);
    }

    PointPx corner(PassId pass) const {
        const PointPx at = layout_.boxes[box_of_[pass]];
        return {at.x + kMargin_px, at.y + kMargin_px};
    }
    int32_t right_px(PassId pass) const { return corner(pass).x + boxes_[box_of_[pass]].width_px; }

    // Reads of this frame first, then those from frame to frame.
    void find_ways() {
        for (const auto& [history, raw] : {std::pair{false, true}, {true, true}, {false, false}}) {
            int32_t lane = 0;
            for (size_t e = 0; e < page_.edges.size(); ++e) {
                if (page_.edges[e].history != history || (page_.edges[e].kind == EdgeKind::raw) != raw)
                    continue;
                drawn_.push_back(e);
                ways_.push_back(history ? way_below(page_.edges[e], lane++) : way(e));
            }
        }
    }

    // Level in boxes' layers, curved in between.
    EdgeWay way(size_t edge) const {
        const EdgeItem& item = page_.edges[edge];
        const int32_t offset_px = kBoxHeight_px / 2 + port_offset_px(item.kind);
        std::vector<PointPx> points{{right_px(item.from), corner(item.from).y + offset_px}};
        // Edges of this frame come first in the page's list, in the order of the layout's.
        for (const PointPx& bend : layout_.bends[edge])
            points.push_back({bend.x + kMargin_px, bend.y + kMargin_px + port_offset_px(item.kind) / 3});
        points.push_back({corner(item.to).x - 5, corner(item.to).y + offset_px});
        EdgeWay way;
        way.move(points[0]);
        for (size_t i = 1; i < points.size(); ++i) {
            const PointPx &a = points[i - 1], &b = points[i];
            const int32_t middle = (a.x + b.x) / 2;
            if (i % 2 == 0 || a.y == b.y)
                way.line(b);
            else
                way.curve({middle, a.y}, {middle, b.y}, b);
        }
        return way;
    }

    // From frame to frame: down, back below all boxes, and up.
    EdgeWay way_below(const EdgeItem& item, int32_t lane) const {
        constexpr int32_t kBend_px = 8;
        const int32_t from_x = right_px(item.from) - 14 - 4 * (lane % 4),
                      to_x = corner(item.to).x + 14 + 4 * (lane % 4);
        const int32_t from_y = corner(item.from).y + kBoxHeight_px,
                      to_y = corner(item.to).y + kBoxHeight_px + 5;
        const int32_t lane_y = layout_.height_px + kMargin_px + (lane + 1) * kLane_px;
        const int32_t turn = to_x < from_x ? -kBend_px : kBend_px;
        EdgeWay way;
        way.move({from_x, from_y});
        way.line({from_x, lane_y - kBend_px});
        way.bend({from_x, lane_y}, {from_x + turn, lane_y});
        way.line({to_x - turn, lane_y});
        way.bend({to_x, lane_y}, {to_x, lane_y - kBend_px});
        way.line({to_x, to_y});
        return way;
    }

    // All resources, or the first of them and how many more there are.
    NameChoices names_of(size_t edge) const {
        const std::vector<ResourceId>& resources = page_.edges[edge].resources;
        if (resources.empty()) return {};
        std::string all;
        for (const ResourceId id : resources)
            all += (all.empty() ? "" : ", ") + plan_.graph.resources[id].name;
        if (resources.size() == 1) return {all};
        return {all, plan_.graph.resources[resources[0]].name + " +" + std::to_string(resources.size() - 1)};
    }

    std::vector<EdgeName> edge_names(PointPx drawing) const {
        if (ways_.size() > kMostNamedEdges) return std::vector<EdgeName>(ways_.size());
        std::vector<NameChoices> names;
        for (const size_t edge : drawn_) names.push_back(names_of(edge));
        std::vector<AreaPx> boxes;
        for (const PassId pass : passes_) {
            const PointPx at = corner(pass);
            boxes.push_back({at.x, at.y, boxes_[box_of_[pass]].width_px, kBoxHeight_px});
        }
        return place_edge_names(ways_, names, boxes, drawing);
    }

    void write_arrow_heads() {
        out_.open("defs");
        for (const char* kind : {"raw", "war", "waw", "after", "history", "wait"}) {
            out_.open("marker", {{"id", std::string("head-") + kind},
                                 {"class", std::string("head ") + kind},
                                 {"viewBox", "0 0 8 8"},
                                 {"refX", "4"},
                                 {"refY", "4"},
                                 {"markerWidth", "8"},
                                 {"markerHeight", "8"},
                                 {"markerUnits", "userSpaceOnUse"},
                                 {"orient", "auto"}});
            out_.empty("path", {{"d", "M0 0L8 4L0 8z"}});
            out_.close();
        }
        out_.close();
    }

    void draw_edge(size_t edge, const std::string& path, const EdgeName& name) {
        const std::string kind = edge_style(page_.edges[edge]);
        const bool live =
            plan_.live.live_passes[page_.edges[edge].from] && plan_.live.live_passes[page_.edges[edge].to];
        open_item(out_, "edge " + kind + (live ? "" : " dead"), edge_keys(page_, edge),
                  edge_label(page_, edge));
        out_.empty("path", {{"class", "hit"}, {"d", path}});
        out_.empty("path", {{"class", "line"}, {"d", path}, {"marker-end", "url(#head-" + kind + ")"}});
        if (!name.text.empty())
            out_.leaf("text", {{"class", "edgename mid"}, {"x", name.at.x}, {"y", name.at.y}}, name.text);
        out_.close();
        out_.line();
    }

    void draw_pass(PassId pass) {
        const PointPx at = corner(pass);
        const uint32_t position = plan_.schedule.position[pass];
        const std::string style =
            position == kNoId ? "dead" : "q" + std::to_string(plan_.schedule.queue[position]);
        const PassDecl& decl = plan_.graph.passes[pass];
        open_item(out_, "pass " + style, pass_keys(page_, pass), decl.name + ": " + type_text(plan_, pass));
        const int32_t width_px = boxes_[box_of_[pass]].width_px;
        out_.empty("rect", {{"class", "box"},
                            {"x", at.x},
                            {"y", at.y},
                            {"width", width_px},
                            {"height", kBoxHeight_px},
                            {"rx", 6}});
        out_.empty("rect", {{"class", "stripe"},
                            {"x", at.x + 5},
                            {"y", at.y + 8},
                            {"width", 4},
                            {"height", kBoxHeight_px - 16},
                            {"rx", 2}});
        out_.leaf("text", {{"class", "name"}, {"x", at.x + 16}, {"y", at.y + 19}}, short_name(decl.name));
        out_.leaf("text", {{"class", "kind"}, {"x", at.x + 16}, {"y", at.y + 35}}, short_kind(pass));
        out_.close();
        out_.line();
    }

    const PlanPage& page_;
    const FramePlan& plan_;
    Markup& out_;
    std::vector<PassId> passes_;  // as they run, then what was culled
    std::vector<uint32_t> box_of_;
    std::vector<LayoutBox> boxes_;
    LayeredLayout layout_;
    std::vector<size_t> drawn_;  // edges, in the order of their names' rank
    std::vector<EdgeWay> ways_;  // of each of these
};

void write_graph_legend(const PlanPage& page, Markup& out) {
    std::vector<std::pair<const char*, const char*>> used;
    const auto add = [&](const char* kind, const char* style, const char* text) {
        if (std::any_of(page.edges.begin(), page.edges.end(),
                        [&](const EdgeItem& e) { return std::string_view(edge_style(e)) == kind; }))
            used.emplace_back(style, text);
    };
    add("raw", "edge raw", "reads what the other wrote");
    add("war", "edge war", "overwrites what the other read");
    add("waw", "edge waw", "overwrites what the other wrote");
    add("after", "edge after", "an \"after\"");
    add("history", "edge history", "reads what an earlier frame wrote");
    if (page.plan->schedule.order.size() < page.plan->graph.passes.size())
        used.emplace_back("pass dead", "culled");
    write_legend(out, used);
}

}  // namespace

void write_graph(const PlanPage& page, Markup& out) {
    open_panel(out, "graph", "Graph",
               "What has to follow what, from left to right. An edge stands for all resources that two "
               "passes share.");
    if (page.plan->graph.passes.empty())
        out.leaf("p", {{"class", "none"}}, "The graph has no passes.");
    else
        GraphDrawing(page, out).draw();
    write_graph_legend(page, out);
    out.close();
}

}  // namespace weft
