#include "tests/graph/compile/naive_plan.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <set>

namespace weft::test {
namespace {

constexpr StageMask kEveryStage = ((1u << stage::kCount) - 1) & ~stage::kHost;
constexpr AccessMask kEveryAccess = ((1u << access::kCount) - 1) & ~(access::kHostRead | access::kHostWrite);

std::vector<PassId> topological(const ResolvedGraph& graph) {
    std::vector<uint32_t> waiting(graph.passes.size(), 0);
    for (const EdgeDecl& edge : graph.edges) ++waiting[edge.to];
    std::set<std::pair<uint32_t, PassId>> ready;
    for (PassId pass(0); pass < waiting.size(); ++pass)
        if (waiting[pass] == 0) ready.emplace(graph.passes[pass].order_key, pass);
    std::vector<PassId> order;
    while (!ready.empty()) {
        const PassId pass = ready.begin()->second;
        ready.erase(ready.begin());
        order.push_back(pass);
        for (const EdgeDecl& edge : graph.edges)
            if (edge.from == pass && --waiting[edge.to] == 0)
                ready.emplace(graph.passes[edge.to].order_key, edge.to);
    }
    assert(order.size() == graph.passes.size());
    return order;
}

// Returns the layout that every copy of a persistent resource has at the end of each frame.
Layout rest_layout(const ResourceDecl& decl) {
    return decl.kind == ResourceKind::image ? Layout::general : Layout::undefined;
}

// Records the current layout of every mip level of every array layer while the plan is made.
class Layouts {
 public:
    explicit Layouts(const ResolvedGraph& graph) : graph_(graph), current_(graph.resources.size()) {
        for (size_t r = 0; r < current_.size(); ++r) {
            const ResourceDecl& decl = graph.resources[r];
            Layout entry = decl.import ? decl.import->entry.layout : Layout::undefined;
            if (decl.lifetime == ResourceLifetime::persistent) entry = rest_layout(decl);
            const bool transient = decl.lifetime == ResourceLifetime::transient;
            current_[r].assign(size_t{decl.mips} * decl.whole().layers, {entry, transient});
        }
    }

    // Adds one barrier for each mip level and each array layer of `range`.
    void move(ResourceId resource, const SubresourceRange& range, const AccessState& to, BarrierReason reason,
              std::vector<BarrierDecl>& barriers) {
        const ResourceDecl& decl = graph_.resources[resource];
        for (uint32_t layer = range.layer; layer < range.layer + range.layers; ++layer) {
            for (uint32_t mip = range.mip; mip < range.mip + range.mips; ++mip) {
                Cell& cell = current_[resource][layer * decl.mips + mip];
                BarrierDecl barrier;
                barrier.resource = resource;
                barrier.range = {mip, 1, layer, 1, decl.aspects};
                barrier.src = {kEveryStage, kEveryAccess, cell.layout};
                barrier.dst = to;
                barrier.reason = cell.fresh ? BarrierReason::alias : reason;
                barrier.from_previous_frame = cell.fresh;
                if (cell.fresh) barrier.aliased_from = {resource};
                cell = {to.layout, false};
                barriers.push_back(barrier);
            }
        }
    }

 private:
    // One mip level of one array layer.
    struct Cell {
        Layout layout = Layout::undefined;
        bool fresh = false;  // True if the resource is transient and the frame has not used this cell yet.
    };

    const ResolvedGraph& graph_;
    std::vector<std::vector<Cell>> current_;
};

// Returns true if an earlier use of the pass has the same resource and range. Then no second barrier is
// needed.
bool moved_before(const PassDecl& pass, size_t use) {
    for (size_t u = 0; u < use; ++u)
        if (pass.uses[u].resource == pass.uses[use].resource && pass.uses[u].range == pass.uses[use].range)
            return true;
    return false;
}

// Adds barriers that bring each persistent resource to its rest layout: before the first frame, in the
// prologue after the clear, and at the end of each frame, in the epilogue. So every frame begins with the
// same layouts.
void plan_rest(FramePlan& plan, Layouts& layouts) {
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        const ResourceDecl& decl = plan.graph.resources[id];
        if (decl.lifetime != ResourceLifetime::persistent) continue;
        const AccessState rest{kEveryStage, kEveryAccess, rest_layout(decl)};
        layouts.move(id, decl.whole(), rest, BarrierReason::layout, plan.barriers.epilogue);
        plan.boundary.push_back({id, decl.whole(), rest, 0});
        const bool image = decl.kind == ResourceKind::image;
        BarrierDecl barrier;
        barrier.resource = id;
        barrier.range = decl.whole();
        barrier.reason = BarrierReason::prologue;
        barrier.dst = access_state(Access::clear_write, 0, image ? decl.aspects : aspect::kNone);
        if (image) plan.barriers.prologue.before.push_back(barrier);
        plan.barriers.prologue.cleared.push_back(id);
        barrier.src = barrier.dst;
        barrier.dst = rest;
        plan.barriers.prologue.after.push_back(barrier);
    }
}

void plan_barriers(FramePlan& plan) {
    const ResolvedGraph& graph = plan.graph;
    Layouts layouts(graph);
    std::vector<uint8_t> touched(graph.resources.size(), 0);
    for (Position position(0); position < plan.schedule.order.size(); ++position) {
        const PassId id = plan.schedule.order[position];
        PassStep step;
        step.pass = id;
        const PassDecl& pass = graph.passes[id];
        for (size_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            // The images of a table of textures are not known to the plan.
            if (moved_before(pass, u) || graph.resources[use.resource].textures > 0) continue;
            layouts.move(use.resource, use.range, {kEveryStage, kEveryAccess, use.state.layout},
                         BarrierReason::waw, step.barriers);
            touched[use.resource] = 1;
        }
        plan.barriers.emitted += static_cast<uint32_t>(step.barriers.size());
        plan.barriers.steps.push_back(std::move(step));
    }
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        if (!graph.resources[id].import || !touched[id]) continue;
        const ImportState& import = *graph.resources[id].import;
        layouts.move(id, graph.resources[id].whole(), {kEveryStage, kEveryAccess, import.exit.layout},
                     BarrierReason::release_import, plan.barriers.epilogue);
        plan.boundary.push_back({id, graph.resources[id].whole(), import.exit, import.family});
    }
    plan_rest(plan, layouts);
    plan.barriers.emitted += static_cast<uint32_t>(plan.barriers.epilogue.size());
}

// Sets load and store operations. Attachments that are only written are cleared, the others are loaded. All
// attachments are stored, except depth attachments that are only read.
void plan_attachments(FramePlan& plan) {
    for (PassStep& step : plan.barriers.steps) {
        const PassDecl& pass = plan.graph.passes[step.pass];
        const auto add = [&](const AttachmentDecl& attachment) {
            const Access access = pass.uses[attachment.use].access;
            const bool fresh = access == Access::color_write || access == Access::depth_write;
            step.attachments.push_back({attachment.use, fresh ? LoadOp::clear : LoadOp::load,
                                        access == Access::depth_read ? StoreOp::none : StoreOp::store});
        };
        for (const AttachmentDecl& color : pass.colors) add(color);
        if (pass.depth) add(*pass.depth);
    }
}

void plan_memory(FramePlan& plan, const MemoryNeeds& needs) {
    const Position last(plan.schedule.order.size() - 1);
    plan.lifetimes.spans.resize(plan.graph.resources.size());
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        const ResourceLifetime lifetime = plan.graph.resources[id].lifetime;
        if (lifetime == ResourceLifetime::imported) continue;
        plan.memory.placements.push_back(
            {id, static_cast<uint32_t>(plan.memory.heaps.size()), 0, needs[id].size_bytes});
        const bool persistent = lifetime == ResourceLifetime::persistent;
        plan.memory.heaps.push_back({needs[id].size_bytes, needs[id].type_bits,
                                     plan.graph.resources[id].kind == ResourceKind::buffer, persistent});
        if (persistent) {
            plan.memory.persistent_bytes += needs[id].size_bytes;
            continue;
        }
        plan.lifetimes.spans[id] = {0, last};
        plan.memory.alias_transitions.push_back({id, id, true});
        plan.memory.sum_bytes += needs[id].size_bytes;
    }
    plan.memory.peak_live_bytes = plan.memory.heap_bytes = plan.memory.sum_bytes;
}

}  // namespace

FramePlan naive_plan(const ResolvedGraph& graph, const MemoryNeeds& needs) {
    FramePlan plan;
    plan.graph = graph;
    plan.live.live_passes.assign(graph.passes.size(), 1);
    plan.live.live_resources.assign(graph.resources.size(), 1);
    plan.live.reasons.assign(graph.passes.size(), CullReason::live);
    plan.live.details.resize(graph.passes.size());
    plan.schedule.order = topological(graph);
    plan.schedule.chosen = "naive";
    plan.schedule.position.resize(graph.passes.size());
    for (Position p(0); p < plan.schedule.order.size(); ++p) {
        plan.schedule.position[plan.schedule.order[p]] = p;
        plan.schedule.queue.push_back(0);
        plan.schedule.clocks.values.push_back(p);
    }
    plan_memory(plan, needs);
    plan_barriers(plan);
    plan_attachments(plan);
    Batch batch;
    batch.positions.resize(plan.schedule.order.size());
    std::iota(batch.positions.begin(), batch.positions.end(), Position(0));
    batch.epilogue = true;
    plan.submissions.batches.push_back(batch);
    return plan;
}

FramePlan naive_plan(const ResolvedGraph& graph) {
    MemoryNeeds needs(graph.resources.size());
    for (ResourceId id(0); id < graph.resources.size(); ++id)
        needs[id] = {content_bytes(graph.resources[id]), 1, UINT32_MAX};
    return naive_plan(graph, needs);
}

}  // namespace weft::test
