#include "check/ordering.h"

#include <algorithm>
#include <bit>

namespace weft::check {
namespace {

// The stages of the graphics pipeline in logical order. In a compute pipeline, only the indirect read comes
// before the compute shader. All other stages have no order.
constexpr std::array kGraphicsOrder{
    stage::kDrawIndirect,   stage::kVertexInput,       stage::kVertexShader, stage::kEarlyFragmentTests,
    stage::kFragmentShader, stage::kLateFragmentTests, stage::kColorOutput};

bool has(StageMask mask, int bit) {
    return (mask & (1u << bit)) != 0;
}

}  // namespace

StageMask with_earlier(StageMask stages) {
    StageMask widened = stages;
    bool later_seen = false;
    for (size_t i = kGraphicsOrder.size(); i-- > 0;) {
        later_seen = later_seen || (stages & kGraphicsOrder[i]);
        if (later_seen) widened |= kGraphicsOrder[i];
    }
    if (stages & stage::kComputeShader) widened |= stage::kDrawIndirect;
    return widened;
}

StageMask with_later(StageMask stages) {
    StageMask widened = stages;
    bool earlier_seen = false;
    for (const StageMask s : kGraphicsOrder) {
        earlier_seen = earlier_seen || (stages & s);
        if (earlier_seen) widened |= s;
    }
    if (stages & stage::kDrawIndirect) widened |= stage::kComputeShader;
    return widened;
}

Scopes scopes_of(const BarrierDecl& barrier) {
    return {with_earlier(barrier.src.stages),
            with_later(barrier.dst.stages),
            barrier.src.stages,
            barrier.dst.stages,
            barrier.src.access,
            barrier.dst.access};
}

AccessRecord::AccessRecord(const Actor& actor, StageMask stages, AccessMask access, bool is_write)
    : actor_(actor), stages_(stages), access_(access), is_write_(is_write), followed_(actor.barriers) {}

AccessRecord AccessRecord::transition(const Actor& actor, const Scopes& scopes) {
    AccessRecord record(actor, 0, 0, true);
    record.actor_.transition = true;
    record.available_reach_ = scopes.dst_execution;  // A layout transition makes its own writes available.
    record.transition_reach_ = scopes.dst_execution;
    for (int t = 0; t < stage::kCount; ++t)
        if (has(scopes.dst_memory, t))
            record.visible_[static_cast<size_t>(t)] = static_cast<ShortMask>(scopes.dst_access);
    return record;
}

bool AccessRecord::ordered_before(const Scopes& scopes) const {
    if (stages_ == 0) return (transition_reach_ & scopes.src_execution) != 0 || !actor_.transition;
    for (int s = 0; s < stage::kCount; ++s) {
        if (!has(stages_, s)) continue;
        if ((((1u << s) | reach_[static_cast<size_t>(s)]) & scopes.src_execution) == 0) return false;
    }
    return true;
}

bool AccessRecord::ordered_before(StageMask stages) const {
    if (stages_ == 0) return !actor_.transition || (stages & ~transition_reach_) == 0;
    for (int s = 0; s < stage::kCount; ++s)
        if (has(stages_, s) && (stages & ~reach_[static_cast<size_t>(s)]) != 0) return false;
    return true;
}

void AccessRecord::carry(const StageChain& chain, StageMask available_before) {
    available_reach_ |= chain.after(available_before);
    if (actor_.transition) transition_reach_ |= chain.after(transition_reach_);
    for (StageMask rest = stages_; rest != 0; rest &= rest - 1) {
        ShortMask& reach = reach_[static_cast<size_t>(std::countr_zero(rest))];
        reach |= chain.after((rest & -rest) | reach);
    }
}

void AccessRecord::follow(const BarrierLog& log) {
    if (followed_ >= log.count()) return;
    carry(log.since(followed_), available_reach_);
    followed_ = log.count();
}

void AccessRecord::pass_barriers(const StageChain& all, std::span<const Scopes> on_memory) {
    const StageMask available_before_all = available_reach_;
    for (const Scopes& scopes : on_memory) {
        if (!is_write_) break;
        const bool flushed = stages_ != 0 && flushed_by(scopes);
        if (flushed) available_reach_ |= scopes.dst_execution;
        const bool available = flushed || (available_before_all & scopes.src_execution) != 0;
        if (!available || !ordered_before(scopes)) continue;
        for (int t = 0; t < stage::kCount; ++t)
            if (has(scopes.dst_memory, t)) visible_[static_cast<size_t>(t)] |= scopes.dst_access;
    }
    carry(all, available_before_all);
    ++followed_;
}

bool AccessRecord::visible_to(StageMask stages, AccessMask access) const {
    for (int t = 0; t < stage::kCount; ++t)
        if (has(stages, t) && (access & ~visible_[static_cast<size_t>(t)]) != 0) return false;
    return true;
}

}  // namespace weft::check
