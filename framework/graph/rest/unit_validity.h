// Purpose: tells shaders whether the content of a resource that units write exists. A unit is a set of passes
// with "rest" that run together, or a round of a group. The content exists if each unit that writes it has
// run since the resource was made or cleared. The values are those of the builtins `unit_valid` and
// `unit_bits` of Params.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "graph/rest/rest_state.h"

namespace weft {

class UnitValidity {
 public:
    explicit UnitValidity(const FramePlan& plan);

    // Remembers which units have results at the start of the frame, and which units run in this frame.
    void begin_frame(const RestState& state, const UnitChoice& choice);
    // Returns the value of one component of a member of Params at the time when the pass runs. The value of
    // `unit_bits` has one bit for each layer of the port: component 0 is for layers 0 to 31.
    [[nodiscard]] uint32_t value(PassId pass, const ParamWrite& write, uint32_t component) const;

 private:
    // A unit that writes a part of what the port reads, and the place of the bit that stands for this part.
    struct Writer {
        uint32_t unit = 0;
        uint32_t component = 0;
        uint32_t bit = 0;
    };
    // Key: a pass, and the offset of the member in its Params.
    using Member = std::pair<PassId, uint32_t>;

    void add(const FramePlan& plan, PassId reader, const ParamWrite& write);
    [[nodiscard]] bool has_result(PassId reader, uint32_t unit) const;

    std::map<Member, std::vector<Writer>> writers_;
    std::map<Member, std::vector<uint32_t>> complete_;  // The values if all units have results.
    std::vector<GroupDecl> groups_;
    std::vector<uint32_t> unit_of_;      // Index: PassId.
    std::vector<Position> position_of_;  // Index: PassId.
    std::vector<Position> unit_end_;     // Index: unit. The position of its last pass.
    // State of the frame. Index: unit.
    std::vector<uint8_t> had_result_, runs_;
    std::vector<uint32_t> turn_;  // For a round that runs: its place in UnitChoice::rounds.
};

}  // namespace weft
