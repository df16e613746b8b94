#include "weft/report/plan_diff.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "graph/diagnostics/quantity_text.h"
#include "graph/report/plan_summary.h"
#include "weft/compile.h"
#include "weft/declaration.h"

namespace weft {
namespace {

using Json = nlohmann::ordered_json;
using Facts = std::vector<std::string>;

Facts missing_in(const Facts& other, const Facts& facts) {
    Facts found;
    for (const std::string& fact : facts)
        if (std::find(other.begin(), other.end(), fact) == other.end()) found.push_back(fact);
    return found;
}

// Compares the items of two plans by name. Both lists of items must be sorted by name. `facts(plan, index)`
// returns texts that describe one item; an item has changed if these texts differ.
template <class Index, class T, class F>
NamesDiff diff_names(const FramePlan& from, const std::vector<T>& old_items, const FramePlan& to,
                     const std::vector<T>& new_items, F facts) {
    NamesDiff diff;
    Index i(0), j(0);
    while (i < old_items.size() || j < new_items.size()) {
        const bool only_old =
            j == new_items.size() || (i < old_items.size() && old_items[i].name < new_items[j].name);
        const bool only_new = !only_old && (i == old_items.size() || new_items[j].name < old_items[i].name);
        if (only_old) {
            diff.removed.push_back(old_items[i].name);
            ++i;
        } else if (only_new) {
            diff.added.push_back(new_items[j].name);
            ++j;
        } else {
            const Facts before = facts(from, i), after = facts(to, j);
            FactsChange change{old_items[i].name, missing_in(after, before), missing_in(before, after)};
            if (!change.gone.empty() || !change.come.empty()) diff.changed.push_back(std::move(change));
            ++i, ++j;
        }
    }
    return diff;
}

// Returns the passes that moved. These are the passes that run in both plans, except the longest sequence of
// them that has the same order in both plans. Patience sorting finds this sequence.
std::vector<PassMove> moved_passes(const FramePlan& from, const FramePlan& to) {
    std::vector<PassMove> common;  // Passes that run in both plans, in the order of `from`.
    for (Position p(0); p < from.schedule.order.size(); ++p) {
        const PassId other = find_pass(to.graph, from.graph.passes[from.schedule.order[p]].name);
        if (other == kNoId) continue;
        const Position position = to.schedule.position[other];
        if (position != kNoId) common.push_back({to.graph.passes[other].name, p, position});
    }
    // Consider all sequences of n + 1 passes that have the same order in both plans. Of these sequences, take
    // the one that ends earliest in the plan `to`: `ends[n]` is its last pass. `previous[i]` is the pass
    // before pass i in the longest sequence that ends with pass i; SIZE_MAX: none. Both contain indices into
    // `common`.
    std::vector<size_t> ends, previous(common.size(), SIZE_MAX);
    for (size_t i = 0; i < common.size(); ++i) {
        const auto it =
            std::lower_bound(ends.begin(), ends.end(), common[i].to,
                             [&](size_t end, uint32_t wanted) { return common[end].to < wanted; });
        if (it != ends.begin()) previous[i] = *std::prev(it);
        if (it == ends.end())
            ends.push_back(i);
        else
            *it = i;
    }
    std::vector<uint8_t> kept(common.size(), 0);
    for (size_t i = ends.empty() ? SIZE_MAX : ends.back(); i != SIZE_MAX; i = previous[i]) kept[i] = 1;
    std::vector<PassMove> moved;
    for (size_t i = 0; i < common.size(); ++i)
        if (!kept[i]) moved.push_back(common[i]);
    return moved;
}

std::vector<CountChange> count_changes(const FramePlan& a, const FramePlan& b) {
    const MemoryPlan &m = a.memory, &n = b.memory;
    return {{"passes", a.schedule.order.size(), b.schedule.order.size()},
            {"barriers", a.barriers.emitted, b.barriers.emitted},
            {"submissions", a.submissions.batches.size(), b.submissions.batches.size()},
            {"waits", a.submissions.dependencies.size(), b.submissions.dependencies.size()},
            {"heap_bytes", m.heap_bytes, n.heap_bytes},
            {"peak_live_bytes", m.peak_live_bytes, n.peak_live_bytes},
            {"sum_bytes", m.sum_bytes, n.sum_bytes},
            {"persistent_bytes", m.persistent_bytes, n.persistent_bytes}};
}

bool ends_with_bytes(const std::string& name) {
    return name.ends_with("_bytes");
}

std::string headline(const PlanDiff& diff) {
    std::string text;
    for (const CountChange& c : diff.counts) {
        if (c.from == c.to) continue;
        const uint64_t change = std::max(c.from, c.to) - std::min(c.from, c.to);
        text += text.empty() ? "" : ", ";
        if (ends_with_bytes(c.name)) {
            std::string what = c.name.substr(0, c.name.size() - std::string("_bytes").size());
            std::replace(what.begin(), what.end(), '_', ' ');
            text += bytes_change_text(c.from, c.to) + " " + what;
        } else {
            text += (c.to < c.from ? "-" : "+") + std::to_string(change) + " " +
                    (change != 1               ? c.name
                     : c.name.ends_with("ses") ? c.name.substr(0, c.name.size() - 2)
                                               : c.name.substr(0, c.name.size() - 1));
        }
    }
    return text.empty() ? "no change of counts and memory sizes" : text;
}

void names_text(const char* title, const NamesDiff& diff, std::string& text) {
    if (diff.added.empty() && diff.removed.empty() && diff.changed.empty()) return;
    text.append("\n").append(title).append("\n");
    for (const std::string& name : diff.added) text += "  + " + name + "\n";
    for (const std::string& name : diff.removed) text += "  - " + name + "\n";
    for (const FactsChange& change : diff.changed) {
        text += "  ~ " + change.name + "\n";
        for (const std::string& fact : change.gone) text += "      - " + fact + "\n";
        for (const std::string& fact : change.come) text += "      + " + fact + "\n";
    }
}

Json names_json(const NamesDiff& diff) {
    Json changed = Json::array();
    for (const FactsChange& c : diff.changed)
        changed.push_back({{"name", c.name}, {"gone", c.gone}, {"come", c.come}});
    return {{"added", diff.added}, {"removed", diff.removed}, {"changed", changed}};
}

}  // namespace

PlanDiff diff_plans(const FramePlan& from, const FramePlan& to) {
    PlanDiff diff;
    diff.same = plan_hash(from) == plan_hash(to);
    diff.counts = count_changes(from, to);
    diff.passes = diff_names<PassId>(from, from.graph.passes, to, to.graph.passes, summarize_pass);
    diff.resources =
        diff_names<ResourceId>(from, from.graph.resources, to, to.graph.resources, summarize_resource);
    diff.groups = diff_names<uint32_t>(from, from.graph.groups, to, to.graph.groups, summarize_group);
    diff.moved = moved_passes(from, to);
    return diff;
}

std::string plan_diff_to_text(const PlanDiff& diff) {
    if (diff.same) return "the two plans are identical\n";
    std::string text = headline(diff) + "\n";
    names_text("passes", diff.passes, text);
    names_text("resources", diff.resources, text);
    names_text("groups", diff.groups, text);
    if (!diff.moved.empty()) text += "\norder\n";
    for (const PassMove& move : diff.moved)
        text += "  " + move.name + ": position " + std::to_string(move.from) + " -> " +
                std::to_string(move.to) + "\n";
    return text;
}

std::string plan_diff_to_json(const PlanDiff& diff) {
    Json counts = Json::object(), moved = Json::array();
    for (const CountChange& c : diff.counts) counts[c.name] = {{"from", c.from}, {"to", c.to}};
    for (const PassMove& move : diff.moved)
        moved.push_back({{"name", move.name}, {"from", move.from}, {"to", move.to}});
    const Json json{{"same", diff.same},
                    {"counts", counts},
                    {"passes", names_json(diff.passes)},
                    {"resources", names_json(diff.resources)},
                    {"groups", names_json(diff.groups)},
                    {"moved", moved}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace weft
