#include "graph/report/html/plan_page_repeats.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace weft {
namespace {

constexpr size_t kFewRounds = 8;  // A repeat with at most this many iterations is drawn as separate boxes.

// Returns the live iterations of each repeat in schedule order. The key is the name before "#", such as
// "down" for "down#1".
std::map<std::string, std::vector<PassId>> rounds_by_name(const FramePlan& plan) {
    std::map<std::string, std::vector<PassId>> rounds;
    for (const PassId pass : plan.schedule.order) {
        const std::string& name = plan.graph.passes[pass].name;
        const size_t mark = name.find('#');
        if (mark != std::string::npos) rounds[name.substr(0, mark)].push_back(pass);
    }
    return rounds;
}

bool on_one_queue(const FramePlan& plan, const std::vector<PassId>& passes) {
    const auto queue_of = [&](PassId pass) { return plan.schedule.queue[plan.schedule.position[pass]]; };
    return std::all_of(passes.begin(), passes.end(),
                       [&](PassId pass) { return queue_of(pass) == queue_of(passes[0]); });
}

// Returns true if the links within a frame form no cycle. Repeatedly removes the nodes without incoming
// links. If nodes remain, there is a cycle.
bool is_acyclic(const NodeGraph& graph) {
    std::vector<uint32_t> arriving(graph.nodes.size(), 0), ready;
    std::vector<std::vector<uint32_t>> next(graph.nodes.size());
    for (const GraphLink& link : graph.links) {
        if (link.history) continue;
        next[link.from].push_back(link.to);
        ++arriving[link.to];
    }
    for (uint32_t node = 0; node < graph.nodes.size(); ++node)
        if (arriving[node] == 0) ready.push_back(node);
    for (size_t i = 0; i < ready.size(); ++i)
        for (const uint32_t to : next[ready[i]])
            if (--arriving[to] == 0) ready.push_back(to);
    return ready.size() == graph.nodes.size();
}

void add_resources(const std::vector<ResourceId>& from, std::vector<ResourceId>& to) {
    for (const ResourceId id : from)
        if (std::find(to.begin(), to.end(), id) == to.end()) to.push_back(id);
}

// Adds the nodes of all passes to the graph. Returns the node of each pass, indexed by PassId.
std::vector<uint32_t> add_nodes(const PlanPage& page, const std::vector<RepeatItem>& repeats,
                                NodeGraph& graph) {
    const FramePlan& plan = *page.plan;
    std::vector<uint32_t> repeat_of(plan.graph.passes.size(), kNoId),
        node_of(plan.graph.passes.size(), kNoId);
    for (uint32_t r = 0; r < repeats.size(); ++r)
        for (const PassId pass : repeats[r].passes) repeat_of[pass] = r;
    const auto add = [&](PassId pass) {
        if (node_of[pass] != kNoId) return;
        const uint32_t repeat = repeat_of[pass];
        GraphNode node{plan.graph.passes[pass].name, {pass}, repeat};
        if (repeat != kNoId) {
            node.name = repeats[repeat].name;
            node.passes = repeats[repeat].passes;
        }
        for (const PassId each : node.passes) node_of[each] = static_cast<uint32_t>(graph.nodes.size());
        graph.nodes.push_back(std::move(node));
    };
    for (const PassId pass : plan.schedule.order) add(pass);
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass) add(pass);
    return node_of;
}

NodeGraph node_graph(const PlanPage& page, const std::vector<RepeatItem>& repeats) {
    NodeGraph graph;
    const std::vector<uint32_t> node_of = add_nodes(page, repeats, graph);
    std::map<std::tuple<bool, uint32_t, uint32_t, EdgeKind>, size_t> known;
    for (size_t e = 0; e < page.edges.size(); ++e) {
        const EdgeItem& edge = page.edges[e];
        const uint32_t from = node_of[edge.from], to = node_of[edge.to];
        // An edge between two iterations that share a box is not drawn, unless the edge leads to a later
        // frame.
        if (from == to && !edge.history) continue;
        const auto [at, is_new] = known.try_emplace({edge.history, from, to, edge.kind}, graph.links.size());
        if (is_new) graph.links.push_back({from, to, edge.kind, edge.history, {}, {}});
        graph.links[at->second].edges.push_back(e);
        add_resources(edge.resources, graph.links[at->second].resources);
    }
    return graph;
}

}  // namespace

std::vector<RepeatItem> find_long_repeats(const PlanPage& page) {
    std::vector<RepeatItem> repeats;
    for (auto& [name, passes] : rounds_by_name(*page.plan)) {
        if (passes.size() <= kFewRounds || !on_one_queue(*page.plan, passes)) continue;
        repeats.push_back({name, std::move(passes)});
        if (!is_acyclic(node_graph(page, repeats))) repeats.pop_back();
    }
    return repeats;
}

NodeGraph make_node_graph(const PlanPage& page, bool folded) {
    return node_graph(page, folded ? page.repeats : std::vector<RepeatItem>{});
}

}  // namespace weft
