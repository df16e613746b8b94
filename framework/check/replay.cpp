#include "check/replay.h"

#include <algorithm>

namespace weft::check {
namespace {

std::vector<Cell> cells_of(const ResourceDecl& resource) {
    std::vector<Cell> cells;
    const SubresourceRange whole = resource.whole();
    for (AspectMask bit = 1; bit != 0 && bit <= whole.aspects; bit = static_cast<AspectMask>(bit << 1)) {
        if (!(whole.aspects & bit)) continue;
        for (uint32_t mip = 0; mip < whole.mips; ++mip)
            for (uint32_t layer = 0; layer < whole.layers; ++layer) {
                Cell cell;
                cell.range = {mip, 1, layer, 1, bit};
                cells.push_back(std::move(cell));
            }
    }
    return cells;
}

std::vector<std::vector<ResourceId>> memory_neighbours(const FramePlan& plan) {
    std::vector<std::vector<ResourceId>> neighbours(plan.graph.resources.size());
    const std::vector<Placement>& all = plan.memory.placements;
    for (size_t i = 0; i < all.size(); ++i) {
        for (size_t j = i + 1; j < all.size(); ++j) {
            const Placement &a = all[i], &b = all[j];
            if (a.heap != b.heap || a.offset_bytes >= b.offset_bytes + b.size_bytes ||
                b.offset_bytes >= a.offset_bytes + a.size_bytes)
                continue;
            neighbours[a.resource].push_back(b.resource);
            neighbours[b.resource].push_back(a.resource);
        }
    }
    return neighbours;
}

bool drops_content(const BarrierDecl& barrier) {
    return barrier.src.layout == Layout::undefined;
}

}  // namespace

const AttachmentOps* ops_of(const PassStep& step, uint32_t use) {
    const auto it = std::find_if(step.attachments.begin(), step.attachments.end(),
                                 [use](const AttachmentOps& ops) { return ops.use == use; });
    return it == step.attachments.end() ? nullptr : &*it;
}

AccessState effective_state(const UseDecl& use, const AttachmentOps* ops) {
    AccessState state = use.state;
    if (!ops) return state;
    const bool color = (state.stages & stage::kColorOutput) != 0;
    const bool clears = ops->load == LoadOp::clear || ops->load == LoadOp::dont_care;
    if (ops->load == LoadOp::load) state.access |= color ? access::kColorRead : access::kDepthStencilRead;
    if (clears || ops->store != StoreOp::none)
        state.access |= color ? access::kColorWrite : access::kDepthStencilWrite;
    return state;
}

Replay::Replay(const FramePlan& plan, FaultList& faults)
    : plan_(plan), faults_(faults), neighbours_(memory_neighbours(plan)) {
    cells_.reserve(plan.graph.resources.size());
    for (const ResourceDecl& resource : plan.graph.resources) cells_.push_back(cells_of(resource));
}

void Replay::run(uint32_t frames) {
    barriers(plan_.barriers.prologue.before, kNoId);
    for (frame_ = 0; frame_ < frames; ++frame_) {
        enter_frame();
        for (const PassStep& s : plan_.barriers.steps) step(s);
        barriers(plan_.barriers.epilogue, kNoId);
        leave_frame();
    }
}

void Replay::barriers(const std::vector<BarrierDecl>& batch, PassId before) {
    if (batch.empty()) return;
    std::vector<Scopes> scopes;
    scopes.reserve(batch.size());
    for (const BarrierDecl& barrier : batch) scopes.push_back(scopes_of(barrier));
    // What the batch waits for is judged by what came before the batch, so transitions are checked first,
    // then everything outstanding is carried through, then the transitions take effect.
    for (size_t i = 0; i < batch.size(); ++i) transition(batch[i], scopes[i], before);
    carry(batch, scopes);
    for (size_t i = 0; i < batch.size(); ++i) {
        const BarrierDecl& barrier = batch[i];
        const bool image = plan_.graph.resources[barrier.resource].kind == ResourceKind::image;
        if (!image || barrier.src.layout == barrier.dst.layout) continue;
        for (Cell& cell : cells_[barrier.resource]) {
            if (!overlaps(cell.range, barrier.range)) continue;
            cell.layout = barrier.dst.layout;
            if (drops_content(barrier)) cell.content = {};
            cell.has_write = true;
            cell.write = AccessRecord::transition({before, frame_, true}, scopes[i]);
            cell.reads.clear();
        }
        if (drops_content(barrier)) overwrite_neighbours(before, barrier.resource);
    }
}

void Replay::transition(const BarrierDecl& barrier, const Scopes& scopes, PassId before) {
    const ResourceDecl& resource = plan_.graph.resources[barrier.resource];
    if (resource.kind == ResourceKind::buffer || barrier.src.layout == barrier.dst.layout) return;
    const Actor actor{before, frame_, true};
    const auto unordered = [&](const AccessRecord& record) {
        if (record.ordered_before(scopes) &&
            (!record.is_write() || record.available() ||
             ((record.stages() & ~scopes.src_memory) == 0 &&
              (record.access() & access::kAllWrites & ~scopes.src_access) == 0)))
            return;
        faults_.add("C313", resource.loc,
                    faults_.actor_text(actor, frame_) + " changes " +
                        faults_.resource_name(barrier.resource) + range_text(barrier.range) + " to " +
                        layout_text(barrier.dst.layout) + " without waiting for " +
                        faults_.actor_text(record.actor(), frame_),
                    "the barrier's source needs " + stages_text(record.stages()) + " and " +
                        access_text(record.access() & access::kAllWrites));
    };
    for (const Cell& cell : cells_[barrier.resource]) {
        if (!overlaps(cell.range, barrier.range)) continue;
        if (barrier.src.layout != Layout::undefined && barrier.src.layout != cell.layout)
            faults_.add("C320", resource.loc,
                        "the barrier before " + faults_.actor_text({before, frame_}, frame_) + " takes " +
                            faults_.resource_name(barrier.resource) + range_text(cell.range) + " from " +
                            layout_text(barrier.src.layout) + ", but " +
                            faults_.actor_text(cell.has_write ? cell.write.actor() : Actor{}, frame_) +
                            " left it in " + layout_text(cell.layout),
                        "the old layout must be the one the range is in, or undefined");
        if (cell.has_write) unordered(cell.write);
        for (const AccessRecord& record : cell.reads) unordered(record);
    }
    if (drops_content(barrier)) expect_free_memory(actor, barrier.resource, resource.loc, 0, &scopes);
}

void Replay::carry(const std::vector<BarrierDecl>& batch, const std::vector<Scopes>& scopes) {
    std::vector<Scopes> on_memory;
    for (ResourceId id = 0; id < cells_.size(); ++id) {
        for (Cell& cell : cells_[id]) {
            if (!cell.has_write && cell.reads.empty()) continue;
            on_memory.clear();
            for (size_t i = 0; i < batch.size(); ++i) {
                const std::vector<ResourceId>& from = batch[i].hand_over_from;
                const bool own = batch[i].resource == id && overlaps(batch[i].range, cell.range);
                if (own || std::find(from.begin(), from.end(), id) != from.end())
                    on_memory.push_back(scopes[i]);
            }
            if (cell.has_write) cell.write.pass_barriers(scopes, on_memory);
            for (AccessRecord& record : cell.reads) record.pass_barriers(scopes, on_memory);
        }
    }
}

void Replay::step(const PassStep& step) {
    barriers(step.barriers, step.pass);
    const PassDecl& pass = plan_.graph.passes[step.pass];
    for (uint32_t u = 0; u < pass.uses.size(); ++u) {
        const UseDecl& use = pass.uses[u];
        const AttachmentOps* ops = ops_of(step, u);
        const AccessState state = effective_state(use, ops);
        if (reads(use.access)) {
            read(pass, step.pass, use, state);
            if (ops && ops->load != LoadOp::load)
                faults_.add(
                    "C331", use.loc,
                    "pass " + faults_.pass_name(step.pass) + " needs what is in " +
                        faults_.resource_name(use.resource) + " from pass " +
                        faults_.pass_name(use.sources.empty() ? kNoId : use.sources.front().producer) +
                        ", but does not load it",
                    "the attachment's load operation must be load");
        } else if (ops && ops->load == LoadOp::load) {
            faults_.add("C331", use.loc,
                        "pass " + faults_.pass_name(step.pass) + " loads " +
                            faults_.resource_name(use.resource) + ", whose content is undefined there",
                        "the attachment's load operation must be clear or dont_care");
        }
    }
    for (uint32_t u = 0; u < pass.uses.size(); ++u) {
        const UseDecl& use = pass.uses[u];
        const AttachmentOps* ops = ops_of(step, u);
        const AccessState state = effective_state(use, ops);
        if (writes(use.access) || (ops && ops->store != StoreOp::none))
            write(pass, step.pass, use, state, !ops || ops->store == StoreOp::store);
    }
}

void Replay::read(const PassDecl&, PassId id, const UseDecl& use, const AccessState& state) {
    const Actor actor{id, frame_};
    for (Cell& cell : cells_[use.resource]) {
        if (!overlaps(cell.range, use.range)) continue;
        expect_order(actor, use, cell, state, false);
        expect_content(id, use, cell);
        cell.reads.emplace_back(actor, state.stages, state.access, false);
    }
}

void Replay::write(const PassDecl&, PassId id, const UseDecl& use, const AccessState& state, bool kept) {
    const Actor actor{id, frame_};
    if (plan_.graph.resources[use.resource].lifetime == ResourceLifetime::transient)
        expect_free_memory(actor, use.resource, use.loc, state.stages, nullptr);
    for (Cell& cell : cells_[use.resource]) {
        if (!overlaps(cell.range, use.range)) continue;
        // A use that also reads was put into the list of reads by read(): it does not wait for itself.
        std::erase_if(cell.reads, [&](const AccessRecord& r) {
            return r.actor().pass == id && r.actor().frame == frame_;
        });
        expect_order(actor, use, cell, state, true);
        cell.reads.clear();
        cell.has_write = true;
        cell.write = AccessRecord(actor, state.stages, state.access, true);
        cell.content = kept ? Content{Content::Kind::written, id, frame_, kNoId} : Content{};
    }
    overwrite_neighbours(id, use.resource);
}

void Replay::enter_frame() {
    for (ResourceId id = 0; id < cells_.size(); ++id) {
        const ResourceDecl& resource = plan_.graph.resources[id];
        if (!resource.import) continue;
        const AccessState& entry = resource.import->entry;
        const bool pending = (entry.access & access::kAllWrites) != 0;
        for (Cell& cell : cells_[id]) {
            const AccessRecord outside({kNoId, frame_}, entry.stages, entry.access, pending);
            cell.reads.clear();
            cell.has_write = pending;
            if (pending) cell.write = outside;
            if (!pending && entry.stages != 0) cell.reads.push_back(outside);
            const bool dropped = resource.kind == ResourceKind::image && entry.layout == Layout::undefined;
            cell.content = dropped ? Content{} : Content{Content::Kind::outside, kNoId, frame_, kNoId};
            if (!dropped) cell.layout = entry.layout;
        }
    }
}

}  // namespace weft::check
