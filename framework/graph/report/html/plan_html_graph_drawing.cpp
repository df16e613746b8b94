// Draws the graph of passes from left to right, with edges that tell why one pass must follow another.
#include "graph/report/html/plan_html_graph_drawing.h"

#include <algorithm>

#include "graph/plan/plan_names.h"
#include "graph/report/html/layered_layout.h"
#include "graph/report/html/plan_html_edges.h"
#include "graph/report/html/plan_page_sizes.h"

namespace weft {
namespace {

constexpr int32_t kBoxHeight_px = 44;
constexpr int32_t kMargin_px = 16;
constexpr int32_t kRoomyGraph_px = 880;                  // A narrower graph is widened towards this width.
constexpr int32_t kLeastGap_px = 64, kMostGap_px = 120;  // Limits of the horizontal gap between layers.
// Height of one lane below the boxes. Each link to a later frame has its own lane.
constexpr int32_t kLane_px = 20;
constexpr size_t kMostNamedEdges = 200;  // If a graph has more links than this, no link gets a name.
constexpr int32_t kBehind_px = 4;        // Offset between the stacked rectangles that show a repeat.
constexpr int32_t kOpen_px = 16;         // Side of the "+" square that opens a repeat.

// Returns how far below the middle of a box the edges of this kind leave and enter the box; negative: above.
// Each kind has a different value, so that the kinds can be distinguished.
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
    const Position position = plan.schedule.position[pass];
    if (position == kNoId) return plan.graph.passes[pass].type + ", culled";
    std::string text = std::to_string(position) + "  " + plan.graph.passes[pass].type;
    if (plan.schedule.queues.size() > 1) text += ", queue " + std::to_string(plan.schedule.queue[position]);
    return text;
}

class GraphDrawing {
 public:
    GraphDrawing(const PlanPage& page, bool folded, Markup& out)
        : page_(page), plan_(*page.plan), out_(out), graph_(make_node_graph(page, folded)) {
        lay_out();
    }

    void draw() {
        find_ways();
        const auto lanes = static_cast<int32_t>(std::count_if(
            graph_.links.begin(), graph_.links.end(), [](const GraphLink& link) { return link.history; }));
        const int32_t below_px = lanes == 0 ? 0 : (lanes + 1) * kLane_px;
        const PointPx size{layout_.width_px + 2 * kMargin_px, layout_.height_px + below_px + 2 * kMargin_px};
        open_drawing(out_, "Graph of passes", size.x, size.y);
        write_arrow_heads();
        const std::vector<EdgeName> names = edge_names(size);
        // Later links are drawn on top of earlier ones. First come the links without a name, then the links
        // with a name, so that no line covers a name. In both groups, the links of kind raw come last.
        for (const auto& [named, reads] :
             {std::pair{false, false}, {false, true}, {true, false}, {true, true}})
            for (size_t i = 0; i < paths_.size(); ++i)
                if (names[i].text.empty() != named &&
                    (graph_.links[drawn_[i]].kind == EdgeKind::raw) == reads)
                    draw_link(graph_.links[drawn_[i]], paths_[i].path(), names[i]);
        for (uint32_t node = 0; node < graph_.nodes.size(); ++node) draw_node(node);
        close_drawing(out_);
    }

 private:
    void lay_out() {
        for (const GraphNode& node : graph_.nodes) {
            const auto kind_px = static_cast<int32_t>(short_kind(node).size()) * 7 + 20;
            const int32_t open_px = node.repeat == kNoId ? 0 : kOpen_px + 6;
            boxes_.push_back({std::max(name_width_px(node.name) + open_px, kind_px) + 8, kBoxHeight_px});
        }
        std::vector<LayoutEdge> edges;
        for (const GraphLink& link : graph_.links)
            if (!link.history) edges.push_back({link.from, link.to});
        layout_ = layered_layout(boxes_, edges, kLeastGap_px);
        if (layout_.layers > 1 && layout_.width_px < kRoomyGraph_px) {
            const auto gaps = static_cast<int32_t>(layout_.layers) - 1;
            const int32_t more_px = (kRoomyGraph_px - layout_.width_px) / gaps;
            layout_ = layered_layout(boxes_, edges, std::min(kLeastGap_px + more_px, kMostGap_px));
        }
    }

    std::string short_kind(const GraphNode& node) const {
        std::string text = type_text(plan_, node.passes[0]);
        if (node.repeat != kNoId)
            text =
                std::to_string(node.passes.size()) + " \xC3\x97 " + plan_.graph.passes[node.passes[0]].type;
        return short_name(text, kMostNameCharacters + 4);
    }

    PointPx corner(uint32_t node) const {
        const PointPx at = layout_.boxes[node];
        return {at.x + kMargin_px, at.y + kMargin_px};
    }
    int32_t right_px(uint32_t node) const { return corner(node).x + boxes_[node].width_px; }

    int32_t bottom_px(uint32_t node) const {
        return corner(node).y + kBoxHeight_px + (graph_.nodes[node].repeat == kNoId ? 0 : 2 * kBehind_px);
    }

    // Creates the paths of all links: first reads within the frame, then reads of earlier frames, then all
    // other links. Reads come first because earlier paths choose the place of their name first.
    void find_ways() {
        for (const auto& [history, raw] : {std::pair{false, true}, {true, true}, {false, false}}) {
            int32_t lane = 0;
            for (size_t i = 0; i < graph_.links.size(); ++i) {
                const GraphLink& link = graph_.links[i];
                if (link.history != history || (link.kind == EdgeKind::raw) != raw) continue;
                drawn_.push_back(i);
                paths_.push_back(history ? path_below(link, lane++) : path(i));
            }
        }
    }

    // Returns the path of a link within the frame: horizontal inside each layer, curved between layers.
    EdgePath path(size_t index) const {
        const GraphLink& item = graph_.links[index];
        const int32_t offset_px = kBoxHeight_px / 2 + port_offset_px(item.kind);
        std::vector<PointPx> points{{right_px(item.from), corner(item.from).y + offset_px}};
        // The layout's edges are the links within the frame. They come first in graph_.links, so they have
        // the same indices in layout_.bends.
        for (const PointPx& bend : layout_.bends[index])
            points.push_back({bend.x + kMargin_px, bend.y + kMargin_px + port_offset_px(item.kind) / 3});
        points.push_back({corner(item.to).x - 5, corner(item.to).y + offset_px});
        EdgePath path;
        path.move(points[0]);
        for (size_t i = 1; i < points.size(); ++i) {
            const PointPx &a = points[i - 1], &b = points[i];
            const int32_t middle = (a.x + b.x) / 2;
            if (i % 2 == 0 || a.y == b.y)
                path.line(b);
            else
                path.curve({middle, a.y}, {middle, b.y}, b);
        }
        return path;
    }

    // Returns the path of a link to a later frame: down from the first box, then sideways below all boxes,
    // then up to the second box.
    EdgePath path_below(const GraphLink& item, int32_t lane) const {
        constexpr int32_t kBend_px = 8;
        const int32_t from_x = right_px(item.from) - 14 - 4 * (lane % 4),
                      to_x = corner(item.to).x + 14 + 4 * (lane % 4);
        const int32_t from_y = bottom_px(item.from), to_y = bottom_px(item.to) + 5;
        const int32_t lane_y = layout_.height_px + kMargin_px + (lane + 1) * kLane_px;
        const int32_t bend_px = to_x < from_x ? -kBend_px : kBend_px;
        EdgePath path;
        path.move({from_x, from_y});
        path.line({from_x, lane_y - kBend_px});
        path.bend({from_x, lane_y}, {from_x + bend_px, lane_y});
        path.line({to_x - bend_px, lane_y});
        path.bend({to_x, lane_y}, {to_x, lane_y - kBend_px});
        path.line({to_x, to_y});
        return path;
    }

    // Returns the possible names of a link: all its resources, or the first resource and the number of
    // others, such as "hdr +2".
    NameChoices names_of(const GraphLink& link) const {
        const std::vector<ResourceId>& resources = link.resources;
        if (resources.empty()) return {};
        std::string all;
        for (const ResourceId id : resources)
            all += (all.empty() ? "" : ", ") + plan_.graph.resources[id].name;
        if (resources.size() == 1) return {all};
        return {all, plan_.graph.resources[resources[0]].name + " +" + std::to_string(resources.size() - 1)};
    }

    std::vector<EdgeName> edge_names(PointPx drawing) const {
        if (paths_.size() > kMostNamedEdges) return std::vector<EdgeName>(paths_.size());
        std::vector<NameChoices> names;
        for (const size_t link : drawn_) names.push_back(names_of(graph_.links[link]));
        std::vector<AreaPx> boxes;
        for (uint32_t node = 0; node < graph_.nodes.size(); ++node) {
            const PointPx at = corner(node);
            boxes.push_back({at.x, at.y, boxes_[node].width_px, kBoxHeight_px});
        }
        return place_edge_names(paths_, names, boxes, drawing);
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

    bool is_live(uint32_t node) const { return plan_.live.live_passes[graph_.nodes[node].passes[0]]; }

    // A line of the drawing (a GraphLink) represents all edges of one kind between two boxes. Returns the
    // keys of these edges and of related items, for the HTML element of the line. A click opens the
    // explanation of the first key.
    std::string link_keys(const GraphLink& link) const {
        std::string keys;
        for (const size_t edge : link.edges) keys += (keys.empty() ? "" : " ") + edge_keys(page_, edge);
        return keys;
    }

    std::string link_label(const GraphLink& link) const {
        if (link.edges.size() == 1) return edge_label(page_, link.edges[0]);
        std::string text = graph_.nodes[link.from].name + " to " + graph_.nodes[link.to].name + ": ";
        for (size_t i = 0; i < link.resources.size(); ++i)
            text += (i > 0 ? ", " : "") + plan_.graph.resources[link.resources[i]].name;
        return text + ", " + std::to_string(link.edges.size()) + " edges";
    }

    void draw_link(const GraphLink& link, const std::string& path, const EdgeName& name) {
        const std::string kind = edge_style(page_.edges[link.edges[0]]);
        const bool live = is_live(link.from) && is_live(link.to);
        open_item(out_, "edge " + kind + (live ? "" : " dead"), link_keys(link), link_label(link));
        out_.empty("path", {{"class", "hit"}, {"d", path}});
        out_.empty("path", {{"class", "line"}, {"d", path}, {"marker-end", "url(#head-" + kind + ")"}});
        if (!name.text.empty())
            out_.leaf("text", {{"class", "edgename mid"}, {"x", name.at.x}, {"y", name.at.y}}, name.text);
        out_.close();
        out_.line();
    }

    void draw_rect(const char* style, PointPx at, PointPx size, int32_t round_px) {
        draw_box(out_, style, {at.x, at.y, size.x, size.y}, round_px);
    }

    void draw_node(uint32_t index) {
        const GraphNode& node = graph_.nodes[index];
        const bool repeat = node.repeat != kNoId;
        const PointPx at = corner(index);
        const Position position = plan_.schedule.position[node.passes[0]];
        const std::string style =
            position == kNoId ? "dead" : "q" + std::to_string(plan_.schedule.queue[position]);
        const int32_t width_px = boxes_[index].width_px;
        open_item(out_, "pass " + style + (repeat ? " repeat" : ""),
                  repeat ? repeat_keys(page_, node.repeat) : pass_keys(page_, node.passes[0]),
                  node.name + ": " + (repeat ? short_kind(node) : type_text(plan_, node.passes[0])));
        if (repeat)  // Two more rectangles behind the box show that it is a repeat.
            for (const int32_t behind_px : {2 * kBehind_px, kBehind_px})
                draw_rect("behind", {at.x + behind_px, at.y + behind_px}, {width_px, kBoxHeight_px}, 6);
        draw_rect("box", at, {width_px, kBoxHeight_px}, 6);
        draw_rect("stripe", {at.x + 5, at.y + 8}, {4, kBoxHeight_px - 16}, 2);
        out_.leaf("text", {{"class", "name"}, {"x", at.x + 16}, {"y", at.y + 19}}, short_name(node.name));
        out_.leaf("text", {{"class", "kind"}, {"x", at.x + 16}, {"y", at.y + 35}}, short_kind(node));
        out_.close();
        if (repeat) draw_opener(node, {at.x + width_px - kOpen_px - 6, at.y + 6});
        out_.line();
    }

    // Draws the "+" link that opens the drawing with all iterations of the repeats.
    void draw_opener(const GraphNode& node, PointPx at) {
        const std::string x = std::to_string(at.x + 4), y = std::to_string(at.y + 4);
        const std::string middle = std::to_string(kOpen_px / 2 - 4), arm = std::to_string(kOpen_px - 8);
        out_.open("a", {{"class", "open"},
                        {"href", std::string("#") + kRoundsId},
                        {"aria-label", "Draw every iteration of " + node.name}});
        draw_rect("plus", at, {kOpen_px, kOpen_px}, 4);
        out_.empty("path", {{"d", "M" + x + " " + y + "m0 " + middle + "h" + arm + "m-" + middle + " -" +
                                      middle + "v" + arm}});
        out_.close();
    }

    const PlanPage& page_;
    const FramePlan& plan_;
    Markup& out_;
    NodeGraph graph_;
    std::vector<LayoutBox> boxes_;
    LayeredLayout layout_;
    // The links that are drawn, as indices into graph_.links. The names of the links are placed in this
    // order, so the first links get the best places.
    std::vector<size_t> drawn_;
    std::vector<EdgePath> paths_;  // The path of each link in drawn_.
};

}  // namespace

void draw_graph(const PlanPage& page, bool folded, Markup& out) {
    GraphDrawing(page, folded, out).draw();
}

}  // namespace weft
