#include "check/barrier_log.h"

#include <algorithm>
#include <bit>

namespace weft::check {

void StageChain::add(const Scopes& barrier) {
    for (StageMask rest = barrier.src_execution; rest != 0; rest &= rest - 1)
        after_[static_cast<size_t>(std::countr_zero(rest))] |= barrier.dst_execution;
}

StageMask StageChain::after(StageMask stages) const {
    StageMask all = 0;
    for (StageMask rest = stages; rest != 0; rest &= rest - 1)
        all |= after_[static_cast<size_t>(std::countr_zero(rest))];
    return all;
}

StageChain StageChain::then(const StageChain& next) const {
    StageChain both;
    for (size_t s = 0; s < after_.size(); ++s)
        both.after_[s] = after_[s] | next.after_[s] | next.after(after_[s]);
    return both;
}

void BarrierLog::append(const StageChain& batch) {
    for (Suffix& suffix : suffixes_) suffix.chain = suffix.chain.then(batch);
    suffixes_.push_back({count_++, batch});
    const auto same = [](const Suffix& a, const Suffix& b) { return a.chain == b.chain; };
    suffixes_.erase(std::unique(suffixes_.begin(), suffixes_.end(), same), suffixes_.end());
}

const StageChain& BarrierLog::since(uint32_t count) const {
    const auto later = [](uint32_t wanted, const Suffix& suffix) { return wanted < suffix.first; };
    return std::prev(std::upper_bound(suffixes_.begin(), suffixes_.end(), count, later))->chain;
}

}  // namespace weft::check
