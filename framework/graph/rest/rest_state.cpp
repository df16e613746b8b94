#include "graph/rest/rest_state.h"

#include <algorithm>

namespace weft {

std::string wake_text(const FramePlan& plan, const Wake& wake) {
    switch (wake.reason) {
        case WakeReason::rests:
        case WakeReason::waits:
            return {};
        case WakeReason::first_run:
            return "the pass has not run with this plan and these shaders";
        case WakeReason::changing:
            return "an input may change in every frame";
        case WakeReason::input:
            return (wake.input.empty()
                        ? "a parameter, a constant of the frame or view, a draw list or an import"
                        : wake.input) +
                   " has changed";
        case WakeReason::settles:
            return "the round runs again to settle after a change";
        case WakeReason::turn:
            return "it is the turn of this round";
        case WakeReason::unit:
            break;
    }
    // The first pass of the unit, without culled passes.
    const auto is_of_unit = [&](PassId pass) { return plan.graph.passes[pass].rest_unit == wake.unit; };
    const auto pass = std::ranges::find_if(plan.schedule.order, is_of_unit);
    return "pass \"" + plan.graph.passes[*pass].name + "\" ran";
}

RestState::RestState(const FramePlan& plan) : units_(plan.graph.rest_unit_count) {
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.rest_unit == kNoId) continue;
        units_[pass.rest_unit].exists = true;
        add_sources(plan, pass);
        const GroupDecl* group = find_group(plan.graph, pass.rest_unit);
        if (group == nullptr) continue;
        if (groups_.empty() || groups_.back().name != group->name) groups_.push_back(*group);
        units_[pass.rest_unit].group = static_cast<uint32_t>(groups_.size() - 1);
    }
}

// Finds the units that write the content that the pass reads. If a pass without a unit writes a part of this
// content, the content may change in every frame, and the unit of the reading pass can never rest.
void RestState::add_sources(const FramePlan& plan, const PassDecl& pass) {
    Unit& unit = units_[pass.rest_unit];
    const auto add_writer = [&](PassId writer, bool previous_frame) {
        const uint32_t source = plan.graph.passes[writer].rest_unit;
        if (source == kNoId)
            unit.changing = true;
        else if (source != pass.rest_unit)
            add_source(pass.rest_unit, source, previous_frame);
    };
    for (const UseDecl& use : pass.uses) {
        if (!use.wakes) continue;
        for (const VersionSource& source : use.sources) {
            if (source.producer != kNoId) {
                add_writer(source.producer, false);
                continue;
            }
            // The content is from before the frame: any writer of this part, or of another copy in the ring
            // of a resource with history, may have written it.
            const ResourceId ring = plan.graph.resources[use.resource].ring;
            for (const PassId writer : plan.schedule.order)
                for (const UseDecl& written : plan.graph.passes[writer].uses)
                    if (writes(written.access) &&
                        (written.resource == use.resource || written.resource == ring) &&
                        overlaps(written.range, source.range))
                        add_writer(writer, true);
        }
    }
}

void RestState::add_source(uint32_t unit, uint32_t source, bool previous_frame) {
    std::vector<Source>& sources = units_[unit].sources;
    const bool known = std::ranges::any_of(
        sources, [&](const Source& s) { return s.unit == source && s.previous_frame == previous_frame; });
    if (!known) sources.push_back({source, previous_frame, 0});
}

Wake RestState::own_wake(const Unit& unit, const UnitInput& input) const {
    if (!unit.exists) return {};
    if (!unit.has_run) return {WakeReason::first_run};
    if (unit.group != kNoId && !groups_[unit.group].rests) return {WakeReason::turn};
    if (unit.changing || !input) return {WakeReason::changing};
    if (*input != unit.input) return {WakeReason::input};
    for (const Source& source : unit.sources)
        if (units_[source.unit].version != source.seen) return {WakeReason::unit, source.unit};
    return {unit.settles > 0 ? WakeReason::settles : WakeReason::rests};
}

// A unit that runs also wakes the units that read its results in the same frame. A reader can be a round that
// would run only to settle, that is, to run again after an earlier change. This round now sees a new change,
// so it begins to settle again. `decided`: for each group, 1 if it is known which of its rounds run.
void RestState::wake_readers(std::vector<Wake>& wakes, const std::vector<uint8_t>& decided) const {
    const auto runs = [&](const Source& source) {
        const uint32_t group = units_[source.unit].group;
        return !source.previous_frame && wakes[source.unit].runs() && (group == kNoId || decided[group] != 0);
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t id = 0; id < units_.size(); ++id) {
            const Unit& unit = units_[id];
            const WakeReason reason = wakes[id].reason;
            if ((reason != WakeReason::rests && reason != WakeReason::settles) || !unit.exists) continue;
            if (unit.group != kNoId && decided[unit.group] != 0) continue;
            const auto awake = std::ranges::find_if(unit.sources, runs);
            if (awake == unit.sources.end()) continue;
            wakes[id] = {WakeReason::unit, awake->unit};
            changed = true;
        }
    }
}

void RestState::choose_rounds(const GroupDecl& group, const TurnLists& turns, UnitChoice& choice) const {
    std::vector<AwakeRound> awake;
    for (uint32_t round = 0; round < group.rounds; ++round) {
        const Unit& unit = units_[group.first_unit + round];
        if (choice.wakes[group.first_unit + round].runs())
            awake.push_back({round, unit.has_result, unit.waits ? unit.waits_since : frame_});
    }
    const auto list = turns.find(group.turns);
    TurnChoice chosen =
        choose_turns(group, awake, list == turns.end() || group.turns.empty() ? nullptr : &list->second);
    choice.dropped_turns += chosen.dropped;
    std::vector<uint8_t> runs(group.rounds, 0);
    for (const uint32_t round : chosen.rounds) {
        runs[round] = 1;
        choice.rounds.push_back(group.first_unit + round);
    }
    for (const AwakeRound& round : awake)
        if (runs[round.round] == 0) choice.wakes[group.first_unit + round.round] = {WakeReason::waits};
}

std::vector<uint8_t> RestState::needs_input(const TurnLists& turns) const {
    std::vector<uint8_t> needs(units_.size(), 1);
    for (const GroupDecl& group : groups_) {
        const auto list = turns.find(group.turns);
        if (group.turns.empty() || list == turns.end() || group.warm_up > 0) continue;
        std::fill_n(needs.begin() + group.first_unit, group.rounds, uint8_t{0});
        for (const uint32_t round : list->second)
            if (round < group.rounds) needs[group.first_unit + round] = 1;
    }
    return needs;
}

UnitChoice RestState::choose(const std::vector<UnitInput>& inputs, const TurnLists& turns) const {
    UnitChoice choice;
    choice.wakes.resize(units_.size());
    const std::vector<uint8_t> needs = needs_input(turns);
    for (size_t unit = 0; unit < units_.size(); ++unit)
        if (needs[unit] != 0) choice.wakes[unit] = own_wake(units_[unit], inputs[unit]);
    std::vector<uint8_t> decided(groups_.size(), 0);
    wake_readers(choice.wakes, decided);
    for (size_t group = 0; group < groups_.size(); ++group) {
        choose_rounds(groups_[group], turns, choice);
        decided[group] = 1;
        wake_readers(choice.wakes, decided);
    }
    return choice;
}

void RestState::inherit(const RestState& old, const std::vector<MatchedUnit>& matches) {
    frame_ = old.frame_;
    for (uint32_t id = 0; id < units_.size(); ++id) {
        const MatchedUnit& match = matches[id];
        if (match.kept == kNoId) continue;
        Unit& unit = units_[id];
        unit.has_result = old.units_[match.kept].has_result;
        unit.waits = old.units_[match.kept].waits;
        unit.waits_since = old.units_[match.kept].waits_since;
        if (match.same == kNoId) continue;
        const Unit& from = old.units_[match.same];
        unit.has_run = from.has_run;
        unit.settles = from.settles;
        unit.version = from.version;
        unit.input = from.input;
        for (Source& source : unit.sources) {
            const auto known = std::ranges::find_if(from.sources, [&](const Source& s) {
                return s.unit == matches[source.unit].same && s.previous_frame == source.previous_frame;
            });
            // If the old unit has no matching source, `seen` gets a value that no version has. So the unit
            // runs.
            source.seen = known == from.sources.end() ? UINT64_MAX : known->seen;
        }
    }
}

// Remembers whether the unit waits for a turn, and how often it must run again after a change
// (GroupDecl::settle).
void RestState::commit_unit(Unit& unit, const Wake& wake) const {
    const bool waits = wake.reason == WakeReason::waits;
    // A round of a group without "rest" begins to wait when it has run.
    const bool waits_again = unit.group != kNoId && !groups_[unit.group].rests && wake.runs();
    if (waits_again || (waits && !unit.waits)) unit.waits_since = frame_ + (waits ? 0 : 1);
    unit.waits = waits || waits_again;
    if (!wake.runs()) return;
    unit.has_run = unit.has_result = true;
    if (wake.reason == WakeReason::settles)
        --unit.settles;
    else if (unit.group != kNoId)
        unit.settles = groups_[unit.group].settle;
}

void RestState::commit(const std::vector<UnitInput>& inputs, const UnitChoice& chosen) {
    const auto runs = [&](uint32_t unit) { return chosen.wakes[unit].runs(); };
    for (uint32_t id = 0; id < units_.size(); ++id) {
        Unit& unit = units_[id];
        commit_unit(unit, chosen.wakes[id]);
        if (!runs(id)) continue;
        unit.input = inputs[id].value_or(std::vector<std::byte>{});
        for (Source& source : unit.sources) {
            const uint64_t before = units_[source.unit].version;
            source.seen = before + (!source.previous_frame && runs(source.unit) ? 1 : 0);
        }
    }
    for (uint32_t id = 0; id < units_.size(); ++id)
        if (runs(id)) ++units_[id].version;
    ++frame_;
}

}  // namespace weft
