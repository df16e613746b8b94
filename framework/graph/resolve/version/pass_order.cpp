#include "graph/resolve/version/pass_order.h"

#include <cassert>

namespace weft {

void PassOrder::add(const OrderArc& arc) {
    assert(arc.from < out_.size() && arc.to < out_.size());
    if (arc.from == arc.to) return;
    out_[arc.from].push_back(static_cast<uint32_t>(arcs_.size()));
    arcs_.push_back(arc);
}

bool PassOrder::sort() {
    std::vector<uint32_t> waits_for(out_.size(), 0);
    work_ += out_.size() + 2 * arcs_.size();
    for (const OrderArc& arc : arcs_) ++waits_for[arc.to];
    std::vector<PassId> ready;
    for (PassId pass = 0; pass < out_.size(); ++pass) {
        if (waits_for[pass] == 0) ready.push_back(pass);
    }
    for (size_t next = 0; next < ready.size(); ++next) {
        position_[ready[next]] = static_cast<uint32_t>(next);
        for (const uint32_t index : out_[ready[next]]) {
            if (--waits_for[arcs_[index].to] == 0) ready.push_back(arcs_[index].to);
        }
    }
    return ready.size() == out_.size();
}

bool PassOrder::reaches(PassId from, PassId to) {
    ++search_;
    std::vector<PassId> open{from};
    while (!open.empty()) {
        const PassId pass = open.back();
        open.pop_back();
        work_ += 1 + out_[pass].size();
        for (const uint32_t index : out_[pass]) {
            const PassId next = arcs_[index].to;
            if (next == to) return true;
            // Positions are in topological order, so a pass at a later position than the goal cannot lead to
            // the goal.
            if (position_[next] > position_[to] || stamp_[next] == search_) continue;
            stamp_[next] = search_;
            open.push_back(next);
        }
    }
    return false;
}

std::vector<uint8_t> PassOrder::reached_from(PassId from) const {
    std::vector<uint8_t> reached(out_.size(), 0);
    work_ += out_.size() / 16;
    std::vector<PassId> open{from};
    while (!open.empty()) {
        const PassId pass = open.back();
        open.pop_back();
        work_ += 1 + out_[pass].size();
        for (const uint32_t index : out_[pass]) {
            const PassId next = arcs_[index].to;
            if (reached[next]) continue;
            reached[next] = 1;
            open.push_back(next);
        }
    }
    return reached;
}

}  // namespace weft
