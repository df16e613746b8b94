// Purpose: chooses in each frame which rest units run. A unit rests if everything is equal to its last run:
// its own inputs (parameters, constants, imports) and the versions of the parts that other units wrote. All
// of this is known before the frame is recorded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// The bytes of everything outside other passes that the result of a unit depends on. nullopt: it may change
// in every frame, so the unit always runs.
using UnitInput = std::optional<std::vector<std::byte>>;

// The reason why a unit runs.
enum class WakeReason : uint8_t {
    rests,      // The unit does not run.
    first_run,  // The unit has not run yet since the plan was made, or it was woken by wake().
    changing,   // Something that the unit reads may change in every frame.
    input,      // The unit's own inputs have changed.
    unit,       // A unit whose results this unit reads has run.
};

struct Wake {
    WakeReason reason = WakeReason::rests;
    uint32_t unit = kNoId;  // For WakeReason::unit: the other unit.
};

// Returns the reason as text, such as `pass "table" ran`. Returns an empty text if the unit rests.
[[nodiscard]] std::string wake_text(const FramePlan& plan, const Wake& wake);

class RestState {
 public:
    explicit RestState(const FramePlan& plan);

    [[nodiscard]] uint32_t unit_count() const { return static_cast<uint32_t>(units_.size()); }
    // Chooses the units that run in the next frame. Index of `inputs` and of the result: unit.
    [[nodiscard]] std::vector<Wake> choose(const std::vector<UnitInput>& inputs) const;
    // Remembers the runs of the chosen frame. Call this after the frame was submitted, with the arguments and
    // the result of choose(). A frame that was not submitted changes nothing.
    void commit(const std::vector<UnitInput>& inputs, const std::vector<Wake>& chosen);
    // Takes over the last runs of the units of an older plan. `same`: for each unit, the unit of the older
    // plan that computes the same, or kNoId; see unit_match.h.
    void inherit(const RestState& old, const std::vector<uint32_t>& same);
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
        uint64_t version = 0;  // Number of runs.
        std::vector<std::byte> input;
        std::vector<Source> sources;
    };
    void add_sources(const FramePlan& plan, const PassDecl& pass);
    void add_source(uint32_t unit, uint32_t source, bool previous_frame);
    [[nodiscard]] Wake own_wake(const Unit& unit, const UnitInput& input) const;

    std::vector<Unit> units_;
};

}  // namespace weft
