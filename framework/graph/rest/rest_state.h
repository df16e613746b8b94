// Purpose: chooses for each frame which units run. A unit is a set of passes with "rest" that run together,
// or a round of a group. A unit that may rest does not run if nothing has changed since its last run: neither
// its own inputs (parameters, constants, imports) nor the versions of the parts that it reads from other
// units. If a group limits the number of rounds per frame, its rounds take turns. All of this is known before
// the frame is recorded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graph/rest/turns.h"
#include "graph/rest/unit_match.h"
#include "weft/plan.h"

namespace weft {

// The bytes of everything on which the result of a unit depends, except the results of other passes. nullopt:
// this input may change in every frame, so the unit always runs.
using UnitInput = std::optional<std::vector<std::byte>>;

// The reason why a unit runs, or does not run.
enum class WakeReason : uint8_t {
    rests,      // The unit does not run, because nothing has changed.
    waits,      // The unit does not run, because other rounds of its group have their turn.
    first_run,  // The unit has not run yet since the plan was made, or it was woken by wake().
    changing,   // Something that the unit reads may change in every frame.
    input,      // The unit's own inputs have changed.
    unit,       // A unit whose results this unit reads has run.
    settles,    // The unit runs again after a change: GroupDecl::settle.
    turn,       // The group has no "rest", and it is the round's turn.
};

struct Wake {
    WakeReason reason = WakeReason::rests;
    uint32_t unit = kNoId;  // For WakeReason::unit: the other unit.
    std::string input;      // For WakeReason::input: the input that has changed, if it is known.

    [[nodiscard]] bool runs() const { return reason != WakeReason::rests && reason != WakeReason::waits; }
};

// For each import of kind "turns": the rounds to run in a frame, in this order.
using TurnLists = std::map<std::string, std::vector<uint32_t>, std::less<>>;

// The units that run in a frame. A unit is a set of passes with "rest", or a round of a group.
struct UnitChoice {
    std::vector<Wake> wakes;  // Index: unit.
    // The rounds that run, as unit numbers, in the order in which they run. The rounds of one group are in
    // the right order; rounds of different groups have no order.
    std::vector<uint32_t> rounds;
    uint32_t dropped_turns = 0;  // Number of entries of lists that were ignored; see TurnChoice::dropped.
};

// Returns the reason as text, such as `pass "table" ran`. Returns an empty text if the unit does not run.
[[nodiscard]] std::string wake_text(const FramePlan& plan, const Wake& wake);

class RestState {
 public:
    explicit RestState(const FramePlan& plan);

    [[nodiscard]] uint32_t unit_count() const { return static_cast<uint32_t>(units_.size()); }
    // Returns for each unit 1 if choose() looks at its input. If a group may run only the rounds in the list
    // of turns of the frame, choose() does not look at the inputs of its other rounds.
    [[nodiscard]] std::vector<uint8_t> needs_input(const TurnLists& turns) const;
    // Chooses the units that run in the next frame. Index of `inputs`: unit.
    [[nodiscard]] UnitChoice choose(const std::vector<UnitInput>& inputs, const TurnLists& turns = {}) const;
    // Remembers the runs of the chosen frame. Call this after the frame was submitted, with the arguments and
    // the result of choose(). A frame that was not submitted changes nothing.
    void commit(const std::vector<UnitInput>& inputs, const UnitChoice& chosen);
    // Takes over the last runs of the units of an older plan. `matches`: for each unit, the units of the
    // older plan that match it.
    void inherit(const RestState& old, const std::vector<MatchedUnit>& matches);
    // Returns true if the unit has run since the resources that it writes were created or cleared.
    [[nodiscard]] bool has_result(uint32_t unit) const { return units_[unit].has_result; }
    // Returns the inputs of the unit's last run.
    [[nodiscard]] const std::vector<std::byte>& last_input(uint32_t unit) const { return units_[unit].input; }
    // Lets the unit run in the next frame.
    void wake(uint32_t unit) { units_[unit].has_run = false; }

 private:
    // A unit whose results the unit reads.
    struct Source {
        uint32_t unit = 0;
        // True: the reader runs before that unit in a frame, so it sees the result of the previous frame.
        bool previous_frame = false;
        uint64_t seen = 0;  // The version of `unit` that the last run of the reader saw.
    };
    struct Unit {
        bool exists = false;    // False if all passes of the unit were culled.
        bool changing = false;  // True if a pass of the unit reads content that changes in every frame.
        bool has_run = false;
        uint32_t group = kNoId;  // For a round: index into groups_.
        // True if the unit has run since the resources that it writes were created or cleared.
        bool has_result = false;
        uint32_t settles = 0;      // How many more times the unit must run after a change.
        uint64_t waits_since = 0;  // The frame in which the unit began to wait for its turn.
        bool waits = false;
        uint64_t version = 0;  // Number of runs.
        std::vector<std::byte> input;
        std::vector<Source> sources;
    };
    void add_sources(const FramePlan& plan, const PassDecl& pass);
    void add_source(uint32_t unit, uint32_t source, bool previous_frame);
    [[nodiscard]] Wake own_wake(const Unit& unit, const UnitInput& input) const;
    void wake_readers(std::vector<Wake>& wakes, const std::vector<uint8_t>& decided) const;
    void choose_rounds(const GroupDecl& group, const TurnLists& turns, UnitChoice& choice) const;
    void commit_unit(Unit& unit, const Wake& wake) const;

    std::vector<Unit> units_;
    std::vector<GroupDecl> groups_;  // In schedule order.
    uint64_t frame_ = 0;             // Number of frames that were committed.
};

}  // namespace weft
