// Checks that the passes of each group can run without interruption.
#include <algorithm>

#include "graph/model/rows.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/version/group_rounds.h"

namespace weft {
namespace {

class GroupOrder {
 public:
    GroupOrder(const Declared& declared, VersionedGraph& graph, Reporter& reporter)
        : declared_(declared),
          report_(declared.shapes, declared.expansion, graph.suspects, reporter),
          after_(make_rows<PassId>(graph.passes.size(),
                                   [&](const auto& add) {
                                       for (const EdgeDecl& edge : graph.edges) add(edge.from, edge.to);
                                   })),
          before_(make_rows<PassId>(graph.passes.size(), [&](const auto& add) {
              for (const EdgeDecl& edge : graph.edges) add(edge.to, edge.from);
          })) {}

    void run() {
        for (uint32_t group = 0; group < declared_.expansion.groups.size(); ++group) {
            const std::vector<PassId> later = reached(group, after_), earlier = reached(group, before_);
            for (PassId pass(0); pass < later.size(); ++pass)
                if (later[pass] != kNoId && earlier[pass] != kNoId && group_of(pass) != group)
                    return report(group, pass, later[pass], earlier[pass]);
        }
    }

 private:
    [[nodiscard]] uint32_t group_of(PassId pass) const { return declared_.expansion.passes[pass].group; }

    // Returns, for each pass p, a pass of the group from which a path of edges in `next` leads to p; kNoId if
    // there is no such path. If a path reaches one pass of another group, it reaches all passes of that
    // group.
    [[nodiscard]] std::vector<PassId> reached(uint32_t group, const Rows<PassId>& next) const {
        std::vector<PassId> from(declared_.expansion.passes.size(), kNoId);
        std::vector<PassId> open;
        for (PassId pass(0); pass < from.size(); ++pass)
            if (group_of(pass) == group) from[pass] = pass, open.push_back(pass);
        std::vector<uint8_t> entered(declared_.expansion.groups.size(), 0);
        const auto reach = [&](PassId pass, PassId start) {
            if (from[pass] != kNoId) return;
            from[pass] = start;
            open.push_back(pass);
        };
        while (!open.empty()) {
            const PassId pass = open.back();
            open.pop_back();
            for (const PassId to : next[pass]) reach(to, from[pass]);
            const uint32_t other = group_of(pass);
            if (other == kNoId || other == group || std::exchange(entered[other], 1) != 0) continue;
            for (PassId member(0); member < from.size(); ++member)
                if (group_of(member) == other) reach(member, from[pass]);
        }
        return from;
    }

    void report(uint32_t group, PassId pass, PassId first, PassId last) {
        const PassDraft& draft = declared_.expansion.passes[pass];
        const std::string name = quote(declared_.expansion.groups[group].name);
        Diagnostic& d = report_.error(
            pass, draft.desc->loc, "W190",
            "pass " + quote(draft.decl.name) + " must run after pass " + quote(declared_.pass_name(first)) +
                " and before pass " + quote(declared_.pass_name(last)) + " of group " + name +
                ", but the passes of a group run without other passes between them");
        add_help(d, "move the pass into the group, or divide the group into two groups");
        add_help(d, "or let pass " + quote(declared_.author_name(last)) +
                        " read the content of the frame before: give the resource \"history\": 1, and write "
                        "[-1] after its name");
    }

    const Declared& declared_;
    PassReporter report_;
    Rows<PassId> after_, before_;  // For each pass: the passes directly after it, and directly before it.
};

}  // namespace

void check_group_order(const Declared& declared, VersionedGraph& graph, Reporter& reporter) {
    if (!declared.expansion.groups.empty()) GroupOrder(declared, graph, reporter).run();
}

}  // namespace weft
