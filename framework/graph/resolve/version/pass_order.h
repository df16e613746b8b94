// Purpose: stores the arcs that are known so far between passes, while version() searches for the order of
// all passes. Private to version(). An arc says that pass `to` runs after pass `from`, and why, so that a
// message about a cycle can give the reasons.
#pragma once

#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct OrderArc : EdgeDecl {
    // True if pass `to` reads a resource with several writers, and its reference contains no `@pass` that
    // selects one of them. Adding an `@pass` can then break a cycle.
    bool pinnable = false;
};

class PassOrder {
 public:
    explicit PassOrder(size_t pass_count)
        : out_(pass_count), position_(pass_count, 0), stamp_(pass_count, 0) {}

    void add(const OrderArc& arc);
    // Sorts the passes topologically. Returns false if there is a cycle. The functions position() and
    // reaches() need a successful call of sort() after the last add().
    [[nodiscard]] bool sort();
    [[nodiscard]] uint32_t position(PassId pass) const { return position_[pass]; }
    // Returns true if a path of arcs leads from `from` to `to`, so that `to` must run after `from`.
    [[nodiscard]] bool reaches(PassId from, PassId to);
    // Returns for each pass, indexed by PassId, 1 if it runs after `from`, else 0.
    [[nodiscard]] std::vector<uint8_t> reached_from(PassId from) const;

    // Returns a measure of the work done so far: about the number of passes and arcs visited.
    [[nodiscard]] uint64_t work() const { return work_; }
    [[nodiscard]] const std::vector<OrderArc>& arcs() const { return arcs_; }
    [[nodiscard]] const std::vector<std::vector<uint32_t>>& arcs_out() const { return out_; }

 private:
    enum class Visit : uint8_t { enter, skip, stop };
    // Follows arcs, beginning at `from`. Calls visit(pass) for the pass at the end of each arc. If `visit`
    // returns `enter`, also follows the arcs of that pass; `skip` does not follow them; `stop` ends the
    // search.
    template <class Visitor>
    void search(PassId from, const Visitor& visit) const;

    std::vector<OrderArc> arcs_;
    // Indices into arcs_ of the arcs that start at each pass, indexed by PassId.
    std::vector<std::vector<uint32_t>> out_;
    std::vector<uint32_t> position_;  // Index: PassId. Position of the pass in the topological order.
    std::vector<uint32_t> stamp_;     // Index: PassId. The last search (search_) that visited the pass.
    uint32_t search_ = 0;             // Number of calls of reaches() so far.
    mutable uint64_t work_ = 0;
};

// Reports each set of passes that wait for each other. Errors: W150.
void report_cycles(const Declared& declared, const VersionedGraph& graph, const PassOrder& order,
                   Reporter& reporter);

}  // namespace weft
