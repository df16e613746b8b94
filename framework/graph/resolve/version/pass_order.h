// Purpose: the known order of passes while versions are found. Private to version(). An arc means that `to`
// runs after `from`, and contains the reason for the message about a cycle.
#pragma once

#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct OrderArc {
    PassId from = kNoId;
    PassId to = kNoId;
    EdgeKind kind = EdgeKind::raw;
    ResourceId resource = kNoId;
    SourceLoc loc;
    bool pinnable = false;  // `to` reads a resource of several writers without naming a version
};

class PassOrder {
 public:
    explicit PassOrder(size_t pass_count)
        : out_(pass_count), position_(pass_count, 0), stamp_(pass_count, 0) {}

    void add(const OrderArc& arc);
    // Finds positions; false when there is a cycle. Everything below needs a successful call after the last
    // add().
    [[nodiscard]] bool sort();
    [[nodiscard]] uint32_t position(PassId pass) const { return position_[pass]; }
    [[nodiscard]] bool reaches(PassId from, PassId to);
    // By pass: 1 where it runs after `from`.
    [[nodiscard]] std::vector<uint8_t> reached_from(PassId from) const;

    // The number of arcs visited so far.
    [[nodiscard]] uint64_t work() const { return work_; }
    [[nodiscard]] const std::vector<OrderArc>& arcs() const { return arcs_; }
    [[nodiscard]] const std::vector<std::vector<uint32_t>>& arcs_out() const { return out_; }

 private:
    std::vector<OrderArc> arcs_;
    std::vector<std::vector<uint32_t>> out_;  // by pass: indices into arcs_
    std::vector<uint32_t> position_;
    std::vector<uint32_t> stamp_;
    uint32_t search_ = 0;
    mutable uint64_t work_ = 0;
};

// Reports every set of passes that wait for each other. Errors: W150.
void report_cycles(const Declared& declared, const VersionedGraph& graph, const PassOrder& order,
                   Reporter& reporter);

}  // namespace weft
