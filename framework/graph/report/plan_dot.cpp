#include <string>

#include "graph/diagnostics/diagnostic_text.h"
#include "graph/sync/scopes.h"
#include "weft/report/plan_dump.h"

namespace weft {
namespace {

std::string dot_string(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string pass_node(PassId id) {
    return std::string("p").append(std::to_string(id));
}
std::string resource_node(ResourceId id) {
    return std::string("r").append(std::to_string(id));
}

std::string grey_unless(bool live) {
    return live ? "" : ", color=grey, fontcolor=grey";
}

std::string use_edge(const FramePlan& plan, PassId pass, const UseDecl& use) {
    const bool whole = use.range == plan.graph.resources[use.resource].whole();
    const std::string label =
        use.port + (whole ? "" : range_text(plan.graph.resources[use.resource], use.range));
    const std::string style =
        " [label=" + dot_string(label) + grey_unless(plan.live.live_passes[pass] != 0) + "];\n";
    std::string text;
    if (reads(use.access)) text += "  " + resource_node(use.resource) + " -> " + pass_node(pass) + style;
    if (writes(use.access)) text += "  " + pass_node(pass) + " -> " + resource_node(use.resource) + style;
    return text;
}

}  // namespace

std::string plan_to_dot(const FramePlan& plan) {
    std::string text = "digraph " + dot_string(printable(plan.graph.name)) +
                       " {\n  rankdir=LR;\n  node [fontname=\"sans\"];\n";
    for (PassId id(0); id < plan.graph.passes.size(); ++id) {
        const Position position = plan.schedule.position[id];
        const std::string prefix = position == kNoId ? "" : std::to_string(position) + " ";
        text += "  " + pass_node(id) +
                " [shape=box, label=" + dot_string(prefix + plan.graph.passes[id].name) +
                grey_unless(plan.live.live_passes[id] != 0) + "];\n";
    }
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        const ResourceDecl& resource = plan.graph.resources[id];
        const char* shape = resource.lifetime == ResourceLifetime::imported ? "doubleoctagon" : "ellipse";
        text += "  " + resource_node(id) + " [shape=" + shape + ", label=" + dot_string(resource.name) +
                grey_unless(plan.live.live_resources[id] != 0) + "];\n";
    }
    for (PassId id(0); id < plan.graph.passes.size(); ++id)
        for (const UseDecl& use : plan.graph.passes[id].uses) text += use_edge(plan, id, use);
    for (Position p(0); p < plan.barriers.steps.size(); ++p)
        if (const PassId first = continued_pass(plan, p); first != kNoId)
            text += "  " + pass_node(first) + " -> " + pass_node(plan.schedule.order[p]) +
                    " [style=bold, dir=none, label=" + dot_string("one rendering scope") + "];\n";
    return text + "}\n";
}

}  // namespace weft
