#include "graph/rest/turns.h"

#include <algorithm>

namespace weft {
namespace {

// Collects the rounds that run, one by one, and counts the entries of the list that are ignored.
class Taker {
 public:
    Taker(const GroupDecl& group, std::span<const AwakeRound> awake)
        : group_(group), awake_(group.rounds, 0), listed_(group.rounds, 0) {
        for (const AwakeRound& round : awake) awake_[round.round] = 1;
    }

    void take(uint32_t round) {
        choice_.rounds.push_back(round);
        awake_[round] = 0;
    }

    // Chooses the rounds of the list that are awake, at most GroupDecl::per_frame rounds.
    void take_list(const std::vector<uint32_t>& list) {
        uint32_t taken = 0;
        for (const uint32_t round : list) {
            const bool counts = round < group_.rounds && listed_[round] == 0;
            if (!counts || (awake_[round] != 0 && taken >= group_.per_frame)) {
                ++choice_.dropped;
                continue;
            }
            listed_[round] = 1;
            if (awake_[round] == 0) continue;
            take(round);
            ++taken;
        }
    }

    [[nodiscard]] size_t count() const { return choice_.rounds.size(); }
    [[nodiscard]] TurnChoice choice() { return std::move(choice_); }

 private:
    const GroupDecl& group_;
    std::vector<uint8_t> awake_;   // Index: round. 1: the round is awake and not chosen yet.
    std::vector<uint8_t> listed_;  // Index: round. 1: the round is in the list.
    TurnChoice choice_;
};

}  // namespace

TurnChoice choose_turns(const GroupDecl& group, std::span<const AwakeRound> awake,
                        const std::vector<uint32_t>* list) {
    std::vector<AwakeRound> waiting(awake.begin(), awake.end());
    std::ranges::stable_sort(
        waiting, {}, [](const AwakeRound& r) { return std::pair(r.has_run, r.has_run ? r.since : 0); });
    const bool warms_up = !waiting.empty() && !waiting.front().has_run;
    const uint32_t in_turn = warms_up ? std::max(group.per_frame, group.warm_up) : group.per_frame;
    // If there is a list, a round that is not in it can be chosen only if it has never run.
    const uint32_t most = list == nullptr ? in_turn : group.warm_up;
    Taker taker(group, awake);
    for (const AwakeRound& round : waiting)
        if (taker.count() < most && (list == nullptr || !round.has_run)) taker.take(round.round);
    if (list != nullptr) taker.take_list(*list);
    return taker.choice();
}

}  // namespace weft
