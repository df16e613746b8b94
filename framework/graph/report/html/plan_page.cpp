#include "graph/report/html/plan_page.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "graph/model/subresource_grid.h"
#include "graph/report/html/plan_page_repeats.h"

namespace weft {
namespace {

void add_barriers(const std::vector<BarrierDecl>& barriers, BarrierPlace place, Position position,
                  PlanPage& page) {
    for (const BarrierDecl& b : barriers) page.barriers.push_back({&b, place, position});
}

void number_barriers(PlanPage& page) {
    const BarrierPlan& barriers = page.plan->barriers;
    add_barriers(barriers.prologue.before, BarrierPlace::prologue, kNoId, page);
    add_barriers(barriers.prologue.after, BarrierPlace::prologue, kNoId, page);
    for (Position p(0); p < barriers.steps.size(); ++p) {
        add_barriers(barriers.steps[p].barriers, BarrierPlace::before_pass, p, page);
        add_barriers(barriers.steps[p].after, BarrierPlace::after_pass, p, page);
    }
    add_barriers(barriers.epilogue, BarrierPlace::epilogue, kNoId, page);
}

auto edge_order(const EdgeItem& e) {
    return std::make_tuple(e.history, e.from, e.to, e.kind);
}

// Finds, for each cell of a resource (see SubresourceGrid), the passes whose writes can still be there at the
// end of a frame. A later writer replaces earlier ones. Exception: a frame may skip a pass of a `perFrame`
// repeat or with a switch, so such a pass replaces no earlier writer and is only added to the list.
class LastWriters {
 public:
    LastWriters(const FramePlan& plan, ResourceId resource, const std::vector<SubresourceRange>& read)
        : grid_(plan.graph.resources[resource], ranges_of(plan, resource, read)),
          writers_(grid_.cell_count()) {
        for (const PassId pass : plan.schedule.order) {
            const PassDecl& decl = plan.graph.passes[pass];
            for (const UseDecl& use : decl.uses) {
                if (use.resource != resource || !writes(use.access)) continue;
                for (const uint32_t cell : grid_.cells_of(use.range)) {
                    if (decl.frame_slices == 0 && decl.switch_id == kNoId) writers_[cell].clear();
                    writers_[cell].push_back(pass);
                }
            }
        }
    }

    [[nodiscard]] std::set<PassId> of(const SubresourceRange& range) const {
        std::set<PassId> found;
        for (const uint32_t cell : grid_.cells_of(range))
            found.insert(writers_[cell].begin(), writers_[cell].end());
        return found;
    }

 private:
    static std::vector<SubresourceRange> ranges_of(const FramePlan& plan, ResourceId resource,
                                                   std::vector<SubresourceRange> ranges) {
        for (const PassDecl& pass : plan.graph.passes)
            for (const UseDecl& use : pass.uses)
                if (use.resource == resource) ranges.push_back(use.range);
        return ranges;
    }

    SubresourceGrid grid_;
    std::vector<std::vector<PassId>> writers_;  // Index: cell of the resource. Its last writers.
};

// A read of content that no pass of the same frame wrote.
struct PastRead {
    PassId pass = kNoId;
    ResourceId resource = kNoId;
    SubresourceRange range;
};

// Adds edges for each read of content from an earlier frame. Each edge leads from a pass that can be the last
// writer of the content to the pass that reads it.
void add_history(const FramePlan& plan, std::vector<EdgeItem>& edges) {
    // The copies of a persistent resource form a ring, see ResourceDecl::ring. Key: the ring's resource of
    // age 0. Value: all reads of content that the ring kept from earlier frames.
    std::map<ResourceId, std::vector<PastRead>> reads;
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass)
        for (const UseDecl& use : plan.graph.passes[pass].uses) {
            const ResourceId ring = plan.graph.resources[use.resource].ring;
            if (ring == kNoId) continue;
            for (const VersionSource& source : use.sources)
                if (source.producer == kNoId) reads[ring].push_back({pass, use.resource, source.range});
        }
    for (const auto& [ring, pasts] : reads) {
        std::vector<SubresourceRange> ranges;
        for (const PastRead& past : pasts) ranges.push_back(past.range);
        const LastWriters writers(plan, ring, ranges);
        for (const PastRead& past : pasts)
            for (const PassId writer : writers.of(past.range))
                edges.push_back({writer, past.pass, EdgeKind::raw, true, {past.resource}});
    }
}

// Merges edges with the same two passes and the same kind into one edge with all their resources.
std::vector<EdgeItem> bundle(std::vector<EdgeItem> edges) {
    std::stable_sort(edges.begin(), edges.end(),
                     [](const EdgeItem& a, const EdgeItem& b) { return edge_order(a) < edge_order(b); });
    std::vector<EdgeItem> bundles;
    for (EdgeItem& edge : edges) {
        if (bundles.empty() || edge_order(bundles.back()) != edge_order(edge)) {
            bundles.push_back(std::move(edge));
            continue;
        }
        std::vector<ResourceId>& known = bundles.back().resources;
        for (const ResourceId id : edge.resources)
            if (std::find(known.begin(), known.end(), id) == known.end()) known.push_back(id);
    }
    return bundles;
}

void number_edges(PlanPage& page) {
    std::vector<EdgeItem> edges;
    for (const EdgeDecl& e : page.plan->graph.edges) {
        EdgeItem item{e.from, e.to, e.kind, false, {}};
        if (e.resource != kNoId) item.resources.push_back(e.resource);
        edges.push_back(std::move(item));
    }
    add_history(*page.plan, edges);
    page.edges = bundle(std::move(edges));
}

std::string key(char kind, size_t number) {
    return kind + std::to_string(number);
}

}  // namespace

PlanPage make_page(const FramePlan& plan, const PlanPageInfo& info) {
    PlanPage page;
    page.plan = &plan;
    page.info = info;
    number_barriers(page);
    number_edges(page);
    page.repeats = find_long_repeats(page);
    for (uint32_t b = 0; b < plan.submissions.batches.size(); ++b)
        for (const QueueWait& wait : plan.submissions.batches[b].waits) page.waits.push_back({b, &wait});
    page.users.resize(plan.graph.resources.size());
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass)
        for (const UseDecl& use : plan.graph.passes[pass].uses)
            if (page.users[use.resource].empty() || page.users[use.resource].back() != pass)
                page.users[use.resource].push_back(pass);
    page.columns = make_columns(page);
    return page;
}

std::string pass_key(PassId pass) {
    return key('p', pass);
}
std::string resource_key(ResourceId resource) {
    return key('r', resource);
}
std::string barrier_key(size_t barrier) {
    return key('b', barrier);
}
std::string wait_key(size_t wait) {
    return key('w', wait);
}
std::string batch_key(size_t batch) {
    return key('s', batch);
}
std::string edge_key(size_t edge) {
    return key('e', edge);
}

std::string repeat_key(size_t repeat) {
    return key('g', repeat);
}

std::string pass_keys(const PlanPage& page, PassId pass) {
    std::string keys = pass_key(pass);
    std::vector<ResourceId> seen;
    for (const UseDecl& use : page.plan->graph.passes[pass].uses) {
        if (std::find(seen.begin(), seen.end(), use.resource) != seen.end()) continue;
        seen.push_back(use.resource);
        keys += " " + resource_key(use.resource);
    }
    return keys;
}

std::string resource_keys(const PlanPage& page, ResourceId resource) {
    std::string keys = resource_key(resource);
    for (const PassId pass : page.users[resource]) keys += " " + pass_key(pass);
    return keys;
}

std::string barrier_keys(const PlanPage& page, size_t barrier) {
    const BarrierItem& item = page.barriers[barrier];
    std::string keys = barrier_key(barrier) + " " + resource_key(item.barrier->resource);
    if (item.position != kNoId) keys += " " + pass_key(page.plan->schedule.order[item.position]);
    if (item.barrier->from != kNoId) keys += " " + pass_key(item.barrier->from);
    for (const ResourceId owner : item.barrier->aliased_from)
        if (owner != item.barrier->resource) keys += " " + resource_key(owner);
    return keys;
}

std::string wait_keys(const PlanPage& page, size_t wait) {
    const WaitItem& item = page.waits[wait];
    const FramePlan& plan = *page.plan;
    std::string keys = wait_key(wait) + " " + batch_key(item.batch) + " " + batch_key(item.wait->batch);
    if (item.wait->dependency == kNoId) return keys;
    const QueueDependency& d = plan.submissions.dependencies[item.wait->dependency];
    for (const Position position : {d.from, d.to})
        if (position < plan.schedule.order.size()) keys += " " + pass_key(plan.schedule.order[position]);
    if (d.resource != kNoId) keys += " " + resource_key(d.resource);
    return keys;
}

std::string batch_keys(const PlanPage& page, size_t batch) {
    std::string keys = batch_key(batch);
    for (const Position position : page.plan->submissions.batches[batch].positions)
        keys += " " + pass_key(page.plan->schedule.order[position]);
    return keys;
}

std::string edge_keys(const PlanPage& page, size_t edge) {
    const EdgeItem& item = page.edges[edge];
    std::string keys = edge_key(edge) + " " + pass_key(item.from);
    if (item.to != item.from) keys += " " + pass_key(item.to);
    for (const ResourceId id : item.resources) keys += " " + resource_key(id);
    return keys;
}

std::string repeat_keys(const PlanPage& page, size_t repeat) {
    std::string keys = repeat_key(repeat);
    for (const PassId pass : page.repeats[repeat].passes) keys += " " + pass_key(pass);
    return keys;
}

bool has_no_reader(const PlanPage& page, ResourceId resource) {
    const FramePlan& plan = *page.plan;
    const ResourceDecl& decl = plan.graph.resources[resource];
    if (decl.import) return false;
    bool read = false, written = false;
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        const bool same =
            id == resource || (decl.ring != kNoId && plan.graph.resources[id].ring == decl.ring);
        if (!same) continue;
        for (const PassId pass : page.users[id]) {
            if (!plan.live.live_passes[pass]) continue;
            for (const UseDecl& use : plan.graph.passes[pass].uses) {
                if (use.resource != id) continue;
                read = read || reads(use.access);
                written = written || writes(use.access);
            }
        }
    }
    return written && !read;
}

std::vector<size_t> barriers_at(const PlanPage& page, BarrierPlace place, Position position) {
    const auto order = [](const BarrierItem& item) {
        const bool prologue = item.place == BarrierPlace::prologue;
        return std::make_pair(prologue                 ? 0ull
                              : item.position == kNoId ? UINT64_MAX
                                                       : item.position + 1ull,
                              item.place);
    };
    const BarrierItem wanted{nullptr, place, position};
    const auto begin = std::lower_bound(page.barriers.begin(), page.barriers.end(), wanted,
                                        [&](const auto& a, const auto& b) { return order(a) < order(b); });
    std::vector<size_t> found;
    for (auto it = begin; it != page.barriers.end() && order(*it) == order(wanted); ++it)
        found.push_back(static_cast<size_t>(it - page.barriers.begin()));
    return found;
}

const std::string& pass_at(const FramePlan& plan, Position position) {
    return plan.graph.passes[plan.schedule.order[position]].name;
}

}  // namespace weft
