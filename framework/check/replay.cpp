#include "check/replay.h"

#include <algorithm>

#include "check/structure/check_scopes.h"

namespace weft::check {
namespace {

// Returns the rings of the persistent resources. A ring contains the copies of one resource; the copy of age
// n has the content of n frames ago (see ResourceDecl::history). Index: [ring's resource of age 0][age].
std::vector<std::vector<ResourceId>> rings_of(const ResolvedGraph& graph) {
    std::vector<std::vector<ResourceId>> rings(graph.resources.size());
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDecl& resource = graph.resources[id];
        if (resource.ring >= rings.size()) continue;
        std::vector<ResourceId>& ring = rings[resource.ring];
        if (ring.size() <= resource.age) ring.resize(resource.age + size_t{1}, kNoId);
        ring[resource.age] = id;
    }
    for (std::vector<ResourceId>& ring : rings)
        if (std::find(ring.begin(), ring.end(), kNoId) != ring.end())
            ring.clear();  // If a resource of the ring is missing, the replay ignores this ring.
    return rings;
}

// Each ring is the list of the copies of one persistent resource. Returns, for the copy of age 0 of each
// ring, the parts that live passes write. Index: ResourceId; the lists of all other resources are empty.
std::vector<std::vector<SubresourceRange>> written_parts(const FramePlan& plan) {
    std::vector<std::vector<SubresourceRange>> parts(plan.graph.resources.size());
    for (const PassId pass : plan.schedule.order)
        for (const UseDecl& use : plan.graph.passes[pass].uses)
            if (writes(use.access) && plan.graph.resources[use.resource].ring == use.resource)
                parts[use.resource].push_back(use.range);
    return parts;
}

}  // namespace

Replay::Replay(const FramePlan& plan, FaultList& faults, Combination combination)
    : plan_(plan),
      faults_(faults),
      combination_(combination),
      clock_(plan),
      logs_(plan.schedule.queues.size()),
      holders_(plan),
      written_(written_parts(plan)),
      rings_(rings_of(plan.graph)) {
    cells_.reserve(plan.graph.resources.size());
    for (const ResourceDecl& resource : plan.graph.resources) cells_.emplace_back(resource);
}

void Replay::run(uint32_t frames) {
    prologue();
    for (frame_ = 0; frame_ < frames; ++frame_) {
        clock_.begin_frame();
        if (frame_ > 0) rotate_rings();
        check_boundary();
        enter_imports();
        for (uint32_t i = 0; i < plan_.submissions.batches.size(); ++i) batch(i);
        clock_.look_from(kGraphicsQueue);
        leave_imports();
        read_kept();
        seal_rings();
    }
}

void Replay::prologue() {
    const ProloguePlan& prologue = plan_.barriers.prologue;
    barriers(prologue.before, kNoId);
    for (const ResourceId id : prologue.cleared) {
        const ResourceDecl& resource = plan_.graph.resources[id];
        const AccessState cleared = clear_state(resource);
        holders_.use(id);
        UseDecl use;
        use.resource = id;
        use.access = Access::clear_write;
        use.loc = resource.loc;
        for (Cell& cell : cells_[id]) {
            expect_order(actor(kNoId), use, cell, cleared, true);
            cell.has_write = true;
            cell.write = AccessRecord({}, cleared.stages, cleared.access, true);
            cell.reads.clear();
            cell.content = {Content::Kind::initial, kNoId, 0, kNoId};
            cell.owner = family();
        }
    }
    barriers(prologue.after, kNoId);
}

// Advances all rings by one frame: the content of age a becomes the content of age a + 1. The memory of the
// oldest content is reused for the new frame, so its content counts as undefined. Only a value that the
// prologue wrote and that no frame has overwritten stays valid.
void Replay::rotate_rings() {
    for (const std::vector<ResourceId>& ring : rings_) {
        if (ring.size() < 2) continue;
        Cells oldest = std::move(cells_[ring.back()]);
        for (size_t age = ring.size() - 1; age > 0; --age)
            cells_[ring[age]] = std::move(cells_[ring[age - 1]]);
        for (Cell& cell : oldest)
            if (cell.content.kind != Content::Kind::initial) cell.content = {};
        cells_[ring.front()] = std::move(oldest);
    }
}

void Replay::seal_rings() {
    for (const std::vector<ResourceId>& ring : rings_) {
        if (ring.empty()) continue;
        const bool kept = ring.size() == 1;
        for (Cell& cell : cells_[ring.front()])
            if (kept || cell.content.kind == Content::Kind::written)
                cell.content = {Content::Kind::carried, cell.content.pass, frame_, kNoId};
    }
}

void Replay::check_boundary() {
    for (const BoundaryState& boundary : plan_.boundary) {
        const ResourceDecl& resource = plan_.graph.resources[boundary.resource];
        if (resource.import || boundary.state.layout == Layout::undefined) continue;
        cells_[boundary.resource].each(boundary.range, [&](const Cell& cell) {
            if (cell.layout == boundary.state.layout) return;
            faults_.add("C350", resource.loc,
                        "at the start of a frame, " + faults_.part_name(boundary.resource, cell.range) +
                            " is in layout " + layout_text(cell.layout) + ", but the plan expects layout " +
                            layout_text(boundary.state.layout),
                        "the prologue or the previous frame must leave the image in the planned layout");
        });
    }
}

void Replay::batch(uint32_t index) {
    const Batch& batch = plan_.submissions.batches[index];
    clock_.begin_batch(index, faults_);
    for (size_t i = 0; i < batch.positions.size(); ++i) {
        const bool last = i + 1 == batch.positions.size();
        step(plan_.barriers.steps[batch.positions[i]],
             !last && plan_.barriers.steps[batch.positions[i + 1]].merges_render_pass);
    }
    if (batch.epilogue) barriers(plan_.barriers.epilogue, kNoId);
    clock_.end_batch(index);
}

void Replay::step(const PassStep& step, bool scope_continues) {
    barriers(step.barriers, step.pass);
    if (!step.merges_render_pass) ++scope_;
    uses(step, scope_continues);
    barriers(step.after, step.pass);
}

Actor Replay::actor_of_use(PassId pass, uint32_t use) const {
    Actor by = actor(pass);
    if (is_attachment(plan_.graph.passes[pass], use)) by.scope = scope_;
    return by;
}

void Replay::uses(const PassStep& step, bool scope_continues) {
    const PassDecl& pass = plan_.graph.passes[step.pass];
    if (!has_combination(pass.runs_in, combination())) return;
    for (uint32_t u = 0; u < pass.uses.size(); ++u) {
        const UseDecl& use = pass.uses[u];
        if (!is_active(use)) continue;
        const AttachmentOps* ops = ops_of(step, u);
        const AccessState state = effective_state(use, ops);
        if (reads(use.access)) {
            read(actor_of_use(step.pass, u), use, state);
            if (ops && ops->load != LoadOp::load)
                faults_.add(
                    "C331", use.loc,
                    "pass " + faults_.pass_name(step.pass) + " needs the content of " +
                        faults_.resource_name(use.resource) + " from pass " +
                        faults_.pass_name(use.sources.empty() ? kNoId : use.sources.front().producer) +
                        ", but does not load this content",
                    "the attachment's load operation must be load");
        } else if (ops && ops->load == LoadOp::load) {
            faults_.add("C331", use.loc,
                        "pass " + faults_.pass_name(step.pass) + " loads " +
                            faults_.resource_name(use.resource) +
                            ", but its content is undefined at this point",
                        "the attachment's load operation must be clear or dont_care");
        }
    }
    for (uint32_t u = 0; u < pass.uses.size(); ++u) {
        const UseDecl& use = pass.uses[u];
        const AttachmentOps* ops = ops_of(step, u);
        const AccessState state = effective_state(use, ops);
        if (writes(use.access) || (ops && ops->store != StoreOp::none))
            // The content is kept if the next pass draws in the same rendering scope, because the store
            // operation takes effect only at the end of the scope.
            write(actor_of_use(step.pass, u), use, state,
                  !ops || scope_continues || ops->store == StoreOp::store);
    }
}

void Replay::read(const Actor& by, const UseDecl& use, const AccessState& state) {
    size_t source = 0;
    holders_.use(use.resource);
    cells_[use.resource].each(use.range, [&](Cell& cell) {
        expect_owner(by, use, cell);
        expect_order(by, use, cell, state, false);
        expect_content(by.pass, use, cell, source);
        note_read(cell, AccessRecord(by, state.stages, state.access, false));
    });
}

// Adds a read to the cell. Of the reads on one queue with the same stages and rendering scope, only the two
// latest are kept: a wait for a later read also covers the earlier reads. One kept read would not be enough:
// a pass that reads and then writes does not wait for its own read, but it must wait for the read before its
// own read.
void Replay::note_read(Cell& cell, const AccessRecord& record) {
    const Actor& by = record.actor();
    const auto alike = [&](const AccessRecord& other) {
        const Actor& who = other.actor();
        return other.stages() == record.stages() && who.queue == by.queue && who.scope == by.scope &&
               who.pass != kNoId;
    };
    const auto by_same_pass = [&](const AccessRecord& other) {
        return alike(other) && other.actor().pass == by.pass && other.actor().frame == by.frame;
    };
    if (std::erase_if(cell.reads, by_same_pass) == 0 && std::ranges::count_if(cell.reads, alike) >= 2)
        cell.reads.erase(std::ranges::find_if(cell.reads, alike));
    cell.reads.push_back(record);
}

void Replay::write(const Actor& by, const UseDecl& use, const AccessState& state, bool kept) {
    const ResourceDecl& resource = plan_.graph.resources[use.resource];
    if (resource.lifetime == ResourceLifetime::transient)
        expect_free_memory(by, use.resource, use.loc, state.stages, nullptr);
    cells_[use.resource].each(use.range, [&](Cell& cell) {
        // If a pass discards the content of a buffer, the family of the pass's queue becomes the owner of the
        // buffer without an ownership transfer. For an image, the transition from UNDEFINED changes the
        // owner.
        if (resource.kind == ResourceKind::buffer && !reads(use.access)) cell.owner = family();
        expect_owner(by, use, cell);
        // If this pass also reads the cell, read() has added this read to the reads of the cell. A pass does
        // not wait for its own read.
        std::erase_if(cell.reads, [&](const AccessRecord& r) {
            return r.actor().pass == by.pass && r.actor().frame == frame_;
        });
        expect_order(by, use, cell, state, true);
        cell.reads.clear();
        cell.has_write = true;
        cell.write = AccessRecord(by, state.stages, state.access, true);
        cell.content = kept ? Content{Content::Kind::written, by.pass, frame_, kNoId} : Content{};
    });
    take_memory(by.pass, use.resource);
}

}  // namespace weft::check
