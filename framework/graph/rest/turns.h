// Purpose: chooses the rounds of a group that run in a frame, and their order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "weft/declaration.h"

namespace weft {

// A round that is awake: it would run if it got a turn.
struct AwakeRound {
    uint32_t round = 0;
    bool has_run = false;  // True if the round has run since its outputs were created or cleared.
    uint64_t since = 0;    // The frame in which the round began to wait.
};

struct TurnChoice {
    std::vector<uint32_t> rounds;  // In the order in which they run.
    // Number of entries of the list that were ignored: rounds that do not exist, rounds that are in the list
    // already, and rounds that are awake, but come after GroupDecl::per_frame others.
    uint32_t dropped = 0;
};

// `awake` is sorted by round. `list` is the list of rounds that the program gives for this frame; null: the
// rounds run in turn, and the round that has waited longest comes first. Rounds that have never run come
// before all others. With a list, at most GroupDecl::warm_up of them run in addition to the list.
[[nodiscard]] TurnChoice choose_turns(const GroupDecl& group, std::span<const AwakeRound> awake,
                                      const std::vector<uint32_t>* list);

}  // namespace weft
