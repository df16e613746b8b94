#include "graph/rest/turns.h"

#include <algorithm>

namespace weft {
namespace {

// Returns the entries of the list that count: the first valid ones, without duplicates.
std::vector<uint32_t> valid_entries(const GroupDecl& group, const std::vector<uint32_t>& list,
                                    uint32_t& dropped) {
    std::vector<uint8_t> listed(group.rounds, 0);
    std::vector<uint32_t> entries;
    for (const uint32_t round : list) {
        if (round >= group.rounds || listed[round] != 0 || entries.size() >= group.per_frame) {
            ++dropped;
            continue;
        }
        listed[round] = 1;
        entries.push_back(round);
    }
    return entries;
}

}  // namespace

TurnChoice choose_turns(const GroupDecl& group, std::span<const AwakeRound> awake,
                        const std::vector<uint32_t>* list) {
    TurnChoice choice;
    std::vector<AwakeRound> waiting(awake.begin(), awake.end());
    std::ranges::stable_sort(
        waiting, {}, [](const AwakeRound& r) { return std::pair(r.has_run, r.has_run ? r.since : 0); });
    const bool warms_up = !waiting.empty() && !waiting.front().has_run;
    const uint32_t most = warms_up ? std::max(group.per_frame, group.warm_up) : group.per_frame;
    std::vector<uint8_t> open(group.rounds, 0);  // Index: round. 1: it is awake and not chosen yet.
    for (const AwakeRound& round : awake) open[round.round] = 1;
    const auto take = [&](uint32_t round) {
        if (open[round] != 0) choice.rounds.push_back(round);
        open[round] = 0;
    };
    for (const AwakeRound& round : waiting) {
        if (choice.rounds.size() >= most) break;
        // With a list, only the rounds that have never run take turns of their own.
        const bool may_run = list == nullptr || (!round.has_run && choice.rounds.size() < group.warm_up);
        if (may_run) take(round.round);
    }
    if (list != nullptr)
        for (const uint32_t round : valid_entries(group, *list, choice.dropped)) take(round);
    return choice;
}

}  // namespace weft
