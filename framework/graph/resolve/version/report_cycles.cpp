// Reports dependency cycles. The message names the waiting passes, the reasons why they wait, and a place
// where the author can break the cycle.
#include <algorithm>
#include <deque>
#include <set>
#include <tuple>
#include <utility>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/version/pass_order.h"

namespace weft {
namespace {

class CycleReport {
 public:
    CycleReport(const Declared& declared, const VersionedGraph& graph, const PassOrder& order,
                Reporter& reporter)
        : declared_(declared),
          graph_(graph),
          order_(order),
          reporter_(reporter),
          done_(graph.passes.size(), 0) {}

    void run() {
        peel();
        for (PassId pass(0); pass < done_.size(); ++pass) {
            if (done_[pass]) continue;
            reporter_.spend(order_.arcs().size() + done_.size(), declared_.expansion.passes[pass].desc->loc);
            const std::vector<PassId> knot = knot_of(pass);
            if (knot.size() > 1) report(knot);
            done_[pass] = 1;
            for (const PassId member : knot) done_[member] = 1;
        }
    }

 private:
    // Marks as done all passes that are in no cycle and wait for no pass in a cycle. Works like a topological
    // sort: marks a pass as soon as all passes that it waits for are marked.
    void peel() {
        std::vector<uint32_t> waits_for(done_.size(), 0);
        for (const OrderArc& arc : order_.arcs()) ++waits_for[arc.to];
        std::vector<PassId> ready;
        for (PassId pass(0); pass < done_.size(); ++pass) {
            if (waits_for[pass] == 0) ready.push_back(pass);
        }
        while (!ready.empty()) {
            const PassId pass = ready.back();
            ready.pop_back();
            done_[pass] = 1;
            for (const uint32_t index : order_.arcs_out()[pass]) {
                const PassId next = order_.arcs()[index].to;
                if (--waits_for[next] == 0) ready.push_back(next);
            }
        }
    }

    // Returns the indices of the arcs on a shortest path from `from` to `to` through passes that are not
    // done, last arc first. Empty if there is no path.
    std::vector<uint32_t> way(PassId from, PassId to) const {
        std::vector<uint32_t> by(done_.size(), kNoId);
        std::deque<PassId> open{from};
        while (!open.empty() && by[to] == kNoId) {
            const PassId pass = open.front();
            open.pop_front();
            for (const uint32_t index : order_.arcs_out()[pass]) {
                const PassId next = order_.arcs()[index].to;
                if (done_[next] || by[next] != kNoId) continue;
                by[next] = index;
                open.push_back(next);
            }
        }
        std::vector<uint32_t> arcs;
        if (by[to] == kNoId) return arcs;
        PassId at = to;
        do {
            arcs.push_back(by[at]);
            at = order_.arcs()[by[at]].from;
        } while (at != from);
        return arcs;
    }

    // Returns the strongly connected component of `pass` among the passes that are not done: all passes that
    // wait for `pass` while `pass` waits for them.
    std::vector<PassId> knot_of(PassId pass) const {
        const std::vector<uint8_t> after = order_.reached_from(pass);
        PassOrder backwards(done_.size());
        for (OrderArc arc : order_.arcs()) {
            if (done_[arc.from] || done_[arc.to]) continue;
            std::swap(arc.from, arc.to);
            backwards.add(arc);
        }
        const std::vector<uint8_t> leads = backwards.reached_from(pass);
        std::vector<PassId> knot;
        for (PassId p(0); p < done_.size(); ++p) {
            if (!done_[p] && after[p] && leads[p]) knot.push_back(p);
        }
        return knot;
    }

    // Returns the arc with which the message begins: preferably an arc that an `@pass` in a reference would
    // remove, otherwise an arc from an `after`, otherwise any arc between passes of `knot`.
    const OrderArc* best_cut(const std::vector<PassId>& knot) const {
        const OrderArc* best = nullptr;
        const auto rank = [](const OrderArc& arc) {
            return arc.pinnable ? 0 : arc.kind == EdgeKind::after ? 1 : 2;
        };
        for (const OrderArc& arc : order_.arcs()) {
            if (!std::ranges::binary_search(knot, arc.from) || !std::ranges::binary_search(knot, arc.to))
                continue;
            const auto key = [&](const OrderArc& a) {
                return std::tuple(rank(a), a.to, a.from, a.kind, a.resource);
            };
            if (!best || key(arc) < key(*best)) best = &arc;
        }
        return best;
    }

    std::string reason(const OrderArc& arc) const {
        switch (arc.kind) {
            case EdgeKind::raw:
                return "reads " + declared_.resource_name(arc.resource);
            case EdgeKind::war:
                return "overwrites " + declared_.resource_name(arc.resource) + ", which " +
                       declared_.pass_name(arc.from) + " reads";
            case EdgeKind::waw:
                return "writes " + declared_.resource_name(arc.resource) + " after " +
                       declared_.pass_name(arc.from);
            case EdgeKind::after:
                return "runs after " + declared_.pass_name(arc.from);
        }
        return "";
    }

    // Returns the name of a pass outside the cycle that writes the resource, so that the help can suggest to
    // read its version with `@pass`. Returns an empty text if there is none.
    std::string writer_outside(const std::vector<PassId>& knot, ResourceId resource) const {
        for (const WriteRank rank : {WriteRank::fresh, WriteRank::resumes, WriteRank::in_place}) {
            for (PassId pass(0); pass < graph_.passes.size(); ++pass) {
                if (std::ranges::binary_search(knot, pass)) continue;
                const std::vector<UseDecl>& uses = graph_.passes[pass].uses;
                for (size_t i = 0; i < uses.size(); ++i) {
                    if (uses[i].resource == resource && writes(uses[i].access) &&
                        graph_.passes[pass].ports[i].rank == rank) {
                        return declared_.author_name(pass);
                    }
                }
            }
        }
        return "";
    }

    bool writes_resource(PassId pass, ResourceId resource) const {
        return std::ranges::any_of(graph_.passes[pass].uses, [&](const UseDecl& use) {
            return use.resource == resource && writes(use.access);
        });
    }

    // Returns true if the pass belongs to a repeat of several passes and writes the resource. If the pass
    // also reads the resource, it probably reads the result of an earlier pass of the same repeat.
    bool reads_own_repeat(PassId pass, ResourceId resource) const {
        const auto& instances = declared_.expansion.instances;
        const auto own = instances.find(declared_.author_name(pass));
        return own != instances.end() && own->second.size() > 1 && writes_resource(pass, resource);
    }

    std::string remedy(const OrderArc& cut, const std::vector<PassId>& knot) const {
        const std::string to = quote(declared_.author_name(cut.to));
        if (cut.kind == EdgeKind::after)
            return "remove \"after\" from " + to + ", or one of the reads in the cycle";
        const std::string& resource = declared_.resource_name(cut.resource);
        const std::string writer = !cut.pinnable ? ""
                                   : reads_own_repeat(cut.to, cut.resource)
                                       ? declared_.author_name(cut.to)
                                       : writer_outside(knot, cut.resource);
        if (writer.empty()) {
            return "let one of these passes read another resource, or another version: name@pass";
        }
        return quote(resource) + " has several writers; select one of its versions in pass " + to + ": " +
               quote(resource + "@" + writer);
    }

    // Returns a read in the cycle by a pass of a group that reads the result of another pass of the same
    // group. With "wakes": false at the port, this read would not order the two passes. Returns null if there
    // is no such read.
    const OrderArc* read_in_group(const std::vector<PassId>& knot) const {
        const auto draft = [&](PassId pass) -> const PassDraft& { return declared_.expansion.passes[pass]; };
        const auto found = std::ranges::find_if(order_.arcs(), [&](const OrderArc& arc) {
            if (arc.kind != EdgeKind::raw || !std::ranges::binary_search(knot, arc.from) ||
                !std::ranges::binary_search(knot, arc.to))
                return false;
            const ResourceDesc* resource = declared_.shapes.origins[arc.resource].desc;
            const bool local = resource != nullptr && !resource->group.empty();
            return !local && draft(arc.to).group != kNoId && draft(arc.to).group == draft(arc.from).group;
        });
        return found == order_.arcs().end() ? nullptr : &*found;
    }

    void report(const std::vector<PassId>& knot) {
        const OrderArc* cut = best_cut(knot);
        if (!cut) return;
        // The rounds of a group often have the same cycle. It is reported once.
        const auto desc = [&](PassId pass) { return declared_.expansion.passes[pass].desc; };
        const bool in_group = declared_.expansion.passes[cut->to].group != kNoId;
        if (in_group && !reported_.insert({desc(cut->from), desc(cut->to), cut->resource}).second) return;
        std::string text = declared_.pass_name(cut->to) + " (" + reason(*cut) + ")";
        std::vector<Note> notes;
        constexpr size_t kMostTold = 16;
        size_t told = 0;
        // The message names each pass before the pass that it waits for, which is at the start of the arc. So
        // the message needs the arcs in the order of way(): the last arc first.
        for (const uint32_t index : way(cut->to, cut->from)) {
            const OrderArc& arc = order_.arcs()[index];
            if (++told > kMostTold) continue;
            text += " -> " + declared_.pass_name(arc.to) + " (" + reason(arc) + ")";
            const Diagnostic place = reporter_.sources().error(arc.loc, "", "");
            if (place.line != 0) notes.push_back({place.file, place.line, place.column, reason(arc)});
        }
        if (told > kMostTold) text += " -> … " + std::to_string(told - kMostTold) + " more …";
        text += " -> " + declared_.pass_name(cut->to);
        Diagnostic& d = reporter_.error(cut->loc, "W150", "dependency cycle: " + text);
        d.notes = std::move(notes);
        const OrderArc* read = read_in_group(knot);
        if (read == nullptr) return add_help(d, remedy(*cut, knot));
        const std::string resource = quote(declared_.resource_name(read->resource));
        add_help(d, "if pass " + quote(declared_.author_name(read->to)) + " needs only the content of " +
                        resource +
                        " from earlier rounds, add \"wakes\": false to the port that reads it: { \"ref\": " +
                        resource + ", \"wakes\": false }");
    }

    const Declared& declared_;
    const VersionedGraph& graph_;
    const PassOrder& order_;
    Reporter& reporter_;
    std::vector<uint8_t> done_;
    std::set<std::tuple<const PassDesc*, const PassDesc*, ResourceId>> reported_;
};

}  // namespace

void report_cycles(const Declared& declared, const VersionedGraph& graph, const PassOrder& order,
                   Reporter& reporter) {
    CycleReport(declared, graph, order, reporter).run();
}

}  // namespace weft
