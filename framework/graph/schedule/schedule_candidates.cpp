#include "graph/schedule/schedule_candidates.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>

namespace weft {
namespace {

// The dependency graph for one direction of the greedy algorithm: forwards or backwards in time. Backwards,
// the last user of a resource allocates its memory and the first user frees it, so one algorithm serves both
// directions.
struct Walk {
    const ScheduleProblem& problem;
    const Rows<PassId>& next;
    const Rows<PassId>& previous;
    std::vector<uint32_t> rank;
};

std::vector<uint32_t> row_sizes(const Rows<PassId>& rows) {
    std::vector<uint32_t> sizes(rows.offsets.size() - 1);
    for (uint32_t row = 0; row < sizes.size(); ++row) sizes[row] = static_cast<uint32_t>(rows[row].size());
    return sizes;
}

// Greedy list scheduling: it always takes the ready pass with the lowest score. The score of a pass is the
// number of bytes that it would allocate, minus the number of bytes that it would free. A score can only
// fall: when another pass allocates a resource of the pass, or when the pass becomes the last user of a
// resource. Each change pushes a new heap entry. Outdated entries are skipped when they reach the top.
class Greedy {
 public:
    explicit Greedy(const Walk& walk)
        : walk_(walk),
          waiting_(row_sizes(walk.previous)),
          users_left_(row_sizes(walk.problem.users)),
          user_sum_(walk.problem.size_bytes.size(), 0),
          score_(waiting_.size(), 0),
          ready_(waiting_.size(), 0) {
        const ScheduleProblem& problem = walk.problem;
        for (uint32_t resource = 0; resource < user_sum_.size(); ++resource)
            for (const PassId pass : problem.users[resource]) user_sum_[resource] += pass;
        for (PassId pass(0); pass < score_.size(); ++pass)
            for (const ResourceId r : problem.resources[pass])
                if (users_left_[r] > 1) score_[pass] += static_cast<int64_t>(problem.size_bytes[r]);
    }

    std::vector<PassId> run() {
        for (PassId pass(0); pass < waiting_.size(); ++pass)
            if (waiting_[pass] == 0 && !ready_[pass]) make_ready(pass);
        while (!heap_.empty()) {
            const auto [score, rank, pass] = heap_.top();
            heap_.pop();
            if (ready_[pass] != 1 || score != score_[pass]) continue;
            take(pass);
        }
        return std::move(order_);
    }

 private:
    using Entry = std::tuple<int64_t, uint32_t, PassId>;

    void push(PassId pass) { heap_.emplace(score_[pass], walk_.rank[pass], pass); }

    void make_ready(PassId first) {
        ready_[first] = 1;
        if (walk_.problem.live[first]) return push(first);
        // A culled pass costs nothing and is not added to the order. The passes that waited only for a culled
        // pass are now ready. A ready live pass is pushed; a ready culled pass is treated like `first`.
        std::vector<PassId> passed{first};
        while (!passed.empty()) {
            const PassId pass = passed.back();
            passed.pop_back();
            for (const PassId n : walk_.next[pass]) {
                if (--waiting_[n] != 0) continue;
                ready_[n] = 1;
                if (walk_.problem.live[n])
                    push(n);
                else
                    passed.push_back(n);
            }
        }
    }

    void fall(PassId pass, uint64_t bytes) {
        score_[pass] -= static_cast<int64_t>(bytes);
        if (ready_[pass] == 1) push(pass);
    }

    void take(PassId pass) {
        ready_[pass] = 2;
        order_.push_back(pass);
        const ScheduleProblem& problem = walk_.problem;
        for (const ResourceId r : problem.resources[pass]) {
            const std::span<const PassId> users = problem.users[r];
            const uint64_t bytes = problem.size_bytes[r];
            if (users_left_[r] == users.size())
                for (const PassId user : users)
                    if (user != pass) fall(user, bytes);
            user_sum_[r] -= pass;
            if (--users_left_[r] == 1) fall(static_cast<PassId>(user_sum_[r]), bytes);
        }
        for (const PassId n : walk_.next[pass])
            if (--waiting_[n] == 0) make_ready(n);
    }

    const Walk& walk_;
    // Index: PassId. Number of predecessors for which the pass still waits.
    std::vector<uint32_t> waiting_;
    // Index: ResourceId. Number of passes that use the resource and are not in the order yet.
    std::vector<uint32_t> users_left_;
    // Index: ResourceId. Sum of the ids of the passes that use the resource and are not in the order yet. If
    // only one such pass is left, the sum is the id of that pass.
    std::vector<uint64_t> user_sum_;
    // Index: PassId. Score of the pass: bytes that it would allocate, minus bytes that it would free.
    std::vector<int64_t> score_;
    // Index: PassId. 0: the pass still waits for a predecessor. 1: the pass is ready; if it is live, it is in
    // the heap. 2: the pass is in the order.
    std::vector<uint8_t> ready_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;
    std::vector<PassId> order_;
};

}  // namespace

std::vector<PassId> program_order(const ScheduleProblem& problem) {
    using Entry = std::pair<uint32_t, PassId>;
    std::vector<uint32_t> waiting = row_sizes(problem.predecessors);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
    for (PassId pass(0); pass < waiting.size(); ++pass)
        if (waiting[pass] == 0) heap.emplace(problem.rank[pass], pass);
    std::vector<PassId> order;
    while (!heap.empty()) {
        const PassId pass = heap.top().second;
        heap.pop();
        if (problem.live[pass]) order.push_back(pass);
        for (const PassId n : problem.successors[pass])
            if (--waiting[n] == 0) heap.emplace(problem.rank[n], n);
    }
    return order;
}

std::vector<PassId> forward_greedy_order(const ScheduleProblem& problem) {
    const Walk walk{problem, problem.successors, problem.predecessors, problem.rank};
    return Greedy(walk).run();
}

std::vector<PassId> backward_greedy_order(const ScheduleProblem& problem) {
    Walk walk{problem, problem.predecessors, problem.successors, problem.rank};
    for (uint32_t& rank : walk.rank) rank = static_cast<uint32_t>(walk.rank.size()) - 1 - rank;
    std::vector<PassId> order = Greedy(walk).run();
    std::reverse(order.begin(), order.end());
    return order;
}

uint64_t peak_live_bytes(const ScheduleProblem& problem, const std::vector<PassId>& order) {
    std::vector<uint32_t> left = row_sizes(problem.users);
    uint64_t bytes = 0, peak = 0;
    for (const PassId pass : order) {
        uint64_t freed = 0;
        for (const ResourceId r : problem.resources[pass]) {
            if (left[r] == problem.users[r].size()) bytes += problem.size_bytes[r];
            if (--left[r] == 0) freed += problem.size_bytes[r];
        }
        peak = std::max(peak, bytes);
        bytes -= freed;
    }
    return peak;
}

uint32_t barrier_batches(const ScheduleProblem& problem, const std::vector<PassId>& order) {
    std::vector<Position> position(problem.live.size(), Position(0));
    std::vector<uint8_t> touched(problem.size_bytes.size(), 0);
    uint32_t batches = 0, last_batch = 0;
    for (Position p(0); p < order.size(); ++p) {
        const PassId pass = order[p];
        position[pass] = p;
        bool needed = false;
        for (const ResourceId r : problem.resources[pass]) {
            needed = needed || !touched[r];
            touched[r] = 1;
        }
        for (const PassId n : problem.predecessors[pass])
            needed = needed || (problem.live[n] && position[n] >= last_batch);
        if (!needed) continue;
        ++batches;
        last_batch = p;
    }
    return batches;
}

}  // namespace weft
