// Simulates barriers: their effects on ordering, visibility, layouts and queue family ownership.
#include <algorithm>
#include <span>
#include <utility>

#include "check/replay.h"

namespace weft::check {
namespace {

bool drops_content(const BarrierDecl& barrier) {
    return barrier.src.layout == Layout::undefined;
}

bool moves(const BarrierDecl& barrier) {
    return barrier.src_family != barrier.dst_family;
}

}  // namespace

bool Replay::changes_image(const BarrierDecl& barrier) const {
    return plan_.graph.resources[barrier.resource].kind == ResourceKind::image &&
           barrier.src.layout != barrier.dst.layout;
}

void Replay::barriers(const std::vector<BarrierDecl>& batch, PassId before) {
    if (batch.empty()) return;
    scopes_.clear();
    for (const BarrierDecl& barrier : batch) scopes_.push_back(scopes_of(barrier));
    // The barriers of one call wait only for work before the call. So first all layout transitions are
    // checked, then the records of earlier accesses are updated, and then the transitions take effect.
    for (size_t i = 0; i < batch.size(); ++i)
        if (moves(batch[i]) || changes_image(batch[i])) transition(batch[i], scopes_[i], before);
    carry(batch);
    for (size_t i = 0; i < batch.size(); ++i) {
        if (moves(batch[i]))
            transfer(batch[i], before);
        else if (changes_image(batch[i]))
            apply(batch[i], scopes_[i], before);
    }
}

void Replay::apply(const BarrierDecl& barrier, const Scopes& scopes, PassId before) {
    if (!drops_content(barrier)) holders_.use(barrier.resource);
    cells_[barrier.resource].each(barrier.range, [&](Cell& cell) {
        cell.layout = barrier.dst.layout;
        if (drops_content(barrier)) {
            cell.content = {};
            cell.owner = family();
            cell.released_to = kNoFamily;
        }
        cell.has_write = true;
        cell.write = AccessRecord::transition(actor(before, true), scopes);
        cell.reads.clear();
    });
    if (drops_content(barrier)) take_memory(before, barrier.resource);
}

// Simulates one half of an ownership transfer: the release on the old queue family or the acquire on the new
// one.
void Replay::transfer(const BarrierDecl& barrier, PassId before) {
    const ResourceDecl& resource = plan_.graph.resources[barrier.resource];
    const Scopes scopes = scopes_of(barrier);
    const std::string what = faults_.part_name(barrier.resource, barrier.range);
    const bool releases = family() == barrier.src_family;
    if (!releases && family() != barrier.dst_family)
        faults_.add("C360", resource.loc,
                    "pass " + faults_.pass_name(before) + " transfers " + what +
                        " between two queue families, but runs on a queue of a third family",
                    "record both halves of a transfer on queues of its two families");
    holders_.use(barrier.resource);
    cells_[barrier.resource].each(barrier.range, [&](Cell& cell) {
        if (releases) {
            cell.released_to = barrier.dst_family;
            cell.released_in = barrier.dst.layout;
        } else {
            if (cell.released_to != barrier.dst_family || cell.released_in != barrier.dst.layout)
                faults_.add("C360", resource.loc,
                            "pass " + faults_.pass_name(before) + " acquires " + what +
                                ", but the last user did not release it to this queue family: " +
                                faults_.actor_text(cell.has_write ? cell.write.actor() : Actor{}, frame_),
                            "add a matching release after the last user");
            cell.released_to = kNoFamily;
            cell.owner = barrier.dst_family;
            cell.layout = barrier.dst.layout;
        }
        cell.has_write = true;
        cell.write = AccessRecord::transition(actor(before, true), scopes);
        cell.reads.clear();
    });
}

void Replay::transition(const BarrierDecl& barrier, const Scopes& scopes, PassId before) {
    const ResourceDecl& resource = plan_.graph.resources[barrier.resource];
    const Actor by = actor(before, true);
    const auto expect_over = [&](AccessRecord& record) {
        follow(record);
        if (ordered(record, scopes) && flushed(record, scopes)) return;
        faults_.add("C313", resource.loc,
                    faults_.actor_text(by, frame_) + " changes " +
                        faults_.part_name(barrier.resource, barrier.range) + " to layout " +
                        layout_text(barrier.dst.layout) + " without waiting for " +
                        faults_.actor_text(record.actor(), frame_),
                    missing(record, "the source scope of the barrier needs " + stages_text(record.stages()) +
                                        " and " + access_text(record.access() & access::kAllWrites)));
    };
    cells_[barrier.resource].each(barrier.range, [&](Cell& cell) {
        if (barrier.src.layout != Layout::undefined && barrier.src.layout != cell.layout)
            faults_.add("C320", resource.loc,
                        "the barrier before " + faults_.actor_text({before, frame_}, frame_) + " changes " +
                            faults_.part_name(barrier.resource, cell.range) + " from layout " +
                            layout_text(barrier.src.layout) + ", but " +
                            faults_.actor_text(cell.has_write ? cell.write.actor() : Actor{}, frame_) +
                            " left it in layout " + layout_text(cell.layout),
                        "the old layout of the barrier must be the real layout or undefined");
        if (cell.has_write) expect_over(cell.write);
        for (AccessRecord& record : cell.reads) expect_over(record);
    });
    if (drops_content(barrier)) expect_free_memory(by, barrier.resource, resource.loc, 0, &barrier);
}

// Applies the barriers of one call to the access records. Barriers order only earlier work of their own
// queue. Only records of accesses to the memory of these barriers are updated here. All other records read
// the barriers from the log later, when they are checked. A barrier with `if_pass_runs` is recorded only in
// frames in which its pass runs, so it is applied only to the resources that it names. The order of accesses
// to other resources is checked without this barrier. So this order is also proved for frames in which the
// pass does not run.
void Replay::carry(const std::vector<BarrierDecl>& batch) {
    StageChain all;
    on_resource_.clear();
    for (size_t i = 0; i < batch.size(); ++i) {
        if (!batch[i].if_pass_runs) all.add(scopes_[i]);
        on_resource_.emplace_back(batch[i].resource, i);
        for (const ResourceId from : batch[i].aliased_from)
            if (from != batch[i].resource) on_resource_.emplace_back(from, i);
    }
    std::sort(on_resource_.begin(), on_resource_.end());
    StageChain chain;
    const auto pass_through = [&](AccessRecord& record) {
        if (record.actor().queue != clock_.queue()) return;
        follow(record);
        record.pass_barriers(chain, on_memory_);
    };
    ++barrier_batches_;
    for (size_t first = 0, last = 0; first < on_resource_.size(); first = last) {
        const ResourceId resource = on_resource_[first].first;
        while (last < on_resource_.size() && on_resource_[last].first == resource) ++last;
        const std::span same(on_resource_.begin() + first, on_resource_.begin() + last);
        chain = all;
        for (const auto& [id, i] : same)
            if (batch[i].if_pass_runs) chain.add(scopes_[i]);
        const auto pass_cell = [&](Cell& cell) {
            if (std::exchange(cell.last_batch, barrier_batches_) == barrier_batches_) return;
            on_memory_.clear();
            for (const auto& [id, i] : same)
                if (batch[i].resource != resource || overlaps(batch[i].range, cell.range))
                    on_memory_.push_back(scopes_[i]);
            if (cell.has_write) pass_through(cell.write);
            for (AccessRecord& record : cell.reads) pass_through(record);
        };
        for (const auto& [id, i] : same) {
            const bool taken_over = batch[i].resource != resource;
            cells_[resource].each(taken_over ? plan_.graph.resources[resource].whole() : batch[i].range,
                                  pass_cell);
        }
    }
    logs_[clock_.queue()].append(all);
}

}  // namespace weft::check
