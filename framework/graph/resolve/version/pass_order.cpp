#include "graph/resolve/version/pass_order.h"

#include <cassert>
#include <utility>

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
    for (PassId pass(0); pass < out_.size(); ++pass) {
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

template <class Visitor>
void PassOrder::search(PassId from, const Visitor& visit) const {
    std::vector<PassId> open{from};
    while (!open.empty()) {
        const PassId pass = open.back();
        open.pop_back();
        work_ += 1 + out_[pass].size();
        for (const uint32_t index : out_[pass]) {
            switch (visit(arcs_[index].to)) {
                case Visit::stop:
                    return;
                case Visit::enter:
                    open.push_back(arcs_[index].to);
                    break;
                case Visit::skip:
                    break;
            }
        }
    }
}

bool PassOrder::reaches(PassId from, PassId to) {
    ++search_;
    bool found = false;
    search(from, [&](PassId next) {
        found = next == to;
        if (found) return Visit::stop;
        // Positions are in topological order, so no path leads from a pass at a later position to `to`.
        if (position_[next] > position_[to] || stamp_[next] == search_) return Visit::skip;
        stamp_[next] = search_;
        return Visit::enter;
    });
    return found;
}

std::vector<uint8_t> PassOrder::reached_from(PassId from) const {
    std::vector<uint8_t> reached(out_.size(), 0);
    work_ += out_.size() / 16;
    search(from, [&](PassId next) {
        return std::exchange(reached[next], uint8_t{1}) == 0 ? Visit::enter : Visit::skip;
    });
    return reached;
}

}  // namespace weft
