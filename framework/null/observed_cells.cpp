#include "null/observed_cells.h"

#include <algorithm>
#include <tuple>

#include "null/pass_values.h"

namespace weft {
namespace {

auto key(const ObservedCell& c) {
    return std::tie(c.frame, c.pass, c.use, c.resource, c.range);
}

std::string cell_text(const ResolvedGraph& graph, const ObservedCell& cell) {
    const ResourceDecl& resource = graph.resources[cell.resource];
    const std::string what = "\"" + resource.name + "\"" + range_text(resource, cell.range);
    const std::string frame = "frame " + std::to_string(cell.frame) + ": ";
    if (cell.pass == kNoId) return frame + what + " after the frame";
    return frame + what + " as \"" + graph.passes[cell.pass].name + "\" sees it";
}

}  // namespace

namespace null {

void settle(std::vector<ObservedCell>& observed) {
    std::sort(observed.begin(), observed.end(),
              [](const ObservedCell& a, const ObservedCell& b) { return key(a) < key(b); });
    std::vector<ObservedCell> settled;
    for (const ObservedCell& cell : observed) {
        const bool again = !settled.empty() && key(settled.back()) == key(cell);
        if (!again)
            settled.push_back(cell);
        else if (settled.back().value != cell.value)
            settled.back().value = ValueHash().add("torn").add(settled.back().value).add(cell.value).value();
    }
    observed = std::move(settled);
}

std::vector<uint8_t> used_resources(const ResolvedGraph& graph, const LiveGraph& live) {
    std::vector<uint8_t> used(graph.resources.size(), 0);
    const auto ring_of = [&](ResourceId id) {
        return graph.resources[id].ring == kNoId ? id : graph.resources[id].ring;
    };
    for (PassId id(0); id < graph.passes.size(); ++id)
        if (live.live_passes[id])
            for (const UseDecl& use : graph.passes[id].uses) used[ring_of(use.resource)] = 1;
    for (ResourceId id(0); id < used.size(); ++id) used[id] = used[ring_of(id)];
    return used;
}

}  // namespace null

std::vector<std::string> differences(const ResolvedGraph& graph, const NullRun& wanted,
                                     const NullRun& found) {
    std::vector<std::string> all;
    auto other = found.observed.begin();
    for (const ObservedCell& cell : wanted.observed) {
        while (other != found.observed.end() && key(*other) < key(cell)) ++other;
        if (cell.value == kUndefinedValue) continue;
        if (other == found.observed.end() || key(*other) != key(cell))
            all.push_back(cell_text(graph, cell) + " is missing");
        else if (other->value != cell.value)
            all.push_back(cell_text(graph, cell) + " has another value");
    }
    return all;
}

}  // namespace weft
