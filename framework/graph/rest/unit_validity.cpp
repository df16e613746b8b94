#include "graph/rest/unit_validity.h"

#include <algorithm>

namespace weft {
namespace {

constexpr uint32_t kBits = 32;

// Returns true if an earlier pass of the unit itself has written all of the part that the use reads. Then the
// part has content whenever the pass runs.
bool is_own_version(const FramePlan& plan, const UseDecl& use, const SubresourceRange& range, uint32_t unit) {
    return std::ranges::any_of(use.sources, [&](const VersionSource& source) {
        return source.producer != kNoId && plan.graph.passes[source.producer].rest_unit == unit &&
               contains(source.range, range);
    });
}

}  // namespace

UnitValidity::UnitValidity(const FramePlan& plan)
    : groups_(plan.graph.groups),
      position_of_(plan.schedule.position),
      unit_end_(plan.graph.rest_unit_count, Position(0)),
      had_result_(unit_end_.size(), 0),
      runs_(unit_end_.size(), 0),
      turn_(unit_end_.size(), 0) {
    for (const PassDecl& pass : plan.graph.passes) unit_of_.push_back(pass.rest_unit);
    for (Position position(0); position < plan.schedule.order.size(); ++position) {
        const uint32_t unit = unit_of_[plan.schedule.order[position]];
        if (unit != kNoId) unit_end_[unit] = position;
    }
    for (const PassId pass : plan.schedule.order)
        for (const ParamWrite& write : plan.graph.passes[pass].params)
            if (write.builtin == Builtin::unit_valid || write.builtin == Builtin::unit_bits)
                add(plan, pass, write);
}

void UnitValidity::add(const FramePlan& plan, PassId reader, const ParamWrite& write) {
    const UseDecl& use = plan.graph.passes[reader].uses[write.use];
    const bool by_layer = write.builtin == Builtin::unit_bits;
    std::vector<Writer>& writers = writers_[{reader, write.offset_bytes}];
    std::vector<uint32_t>& complete = complete_[{reader, write.offset_bytes}];
    complete.assign(write.components, 0);
    const uint32_t parts = by_layer ? use.range.layers : 1;
    for (uint32_t part = 0; part < parts && part < kBits * write.components; ++part) {
        complete[part / kBits] |= 1u << part % kBits;
        SubresourceRange range = use.range;
        if (by_layer) range.layer += part, range.layers = 1;
        for (const PassId pass : plan.schedule.order)
            for (const UseDecl& written : plan.graph.passes[pass].uses) {
                const uint32_t unit = unit_of_[pass];
                const bool found = unit != kNoId && writes(written.access) &&
                                   written.resource == use.resource && overlaps(written.range, range);
                if (found && !(unit == unit_of_[reader] && is_own_version(plan, use, range, unit)))
                    writers.push_back({unit, part / kBits, part % kBits});
            }
    }
}

void UnitValidity::begin_frame(const RestState& state, const UnitChoice& choice) {
    for (uint32_t unit = 0; unit < runs_.size(); ++unit) {
        had_result_[unit] = state.has_result(unit) ? 1 : 0;
        runs_[unit] = choice.wakes[unit].runs() ? 1 : 0;
    }
    for (uint32_t turn = 0; turn < choice.rounds.size(); ++turn) turn_[choice.rounds[turn]] = turn;
}

// Returns true if the unit has a result when the reader runs: from an earlier frame, or because the unit runs
// before the reader in this frame.
bool UnitValidity::has_result(PassId reader, uint32_t unit) const {
    if (had_result_[unit] != 0) return true;
    if (runs_[unit] == 0) return false;
    const uint32_t own = unit_of_[reader];
    const bool turns = std::ranges::any_of(groups_, [&](const GroupDecl& group) {
        return own != kNoId && group.has_unit(own) && group.has_unit(unit);
    });
    return turns ? turn_[unit] < turn_[own] : unit_end_[unit] < position_of_[reader];
}

uint32_t UnitValidity::value(PassId pass, const ParamWrite& write, uint32_t component) const {
    const Member member{pass, write.offset_bytes};
    const auto complete = complete_.find(member);
    if (complete == complete_.end()) return 0;
    uint32_t bits = complete->second[component];
    for (const Writer& writer : writers_.at(member))
        if (writer.component == component && !has_result(pass, writer.unit)) bits &= ~(1u << writer.bit);
    return bits;
}

}  // namespace weft
