#include "graph/rest/rest_state.h"

#include <algorithm>

namespace weft {

std::string wake_text(const FramePlan& plan, const Wake& wake) {
    switch (wake.reason) {
        case WakeReason::rests:
            return {};
        case WakeReason::first_run:
            return "the pass has not run with this plan and these shaders";
        case WakeReason::changing:
            return "an input may change in every frame";
        case WakeReason::input:
            return "a parameter, a constant of the frame or view, a draw list or an import has changed";
        case WakeReason::unit:
            break;
    }
    const auto pass = std::ranges::find(plan.graph.passes, wake.unit, &PassDecl::rest_unit);
    return "pass \"" + pass->name + "\" ran";
}

RestState::RestState(const FramePlan& plan) : units_(plan.graph.rest_unit_count) {
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.rest_unit == kNoId) continue;
        units_[pass.rest_unit].exists = true;
        add_sources(plan, pass);
    }
}

// Finds the units that write what the pass reads. If another pass writes it in every frame, the pass can
// never rest.
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
            // The content is from before the frame: any writer of this part or ring may have written it.
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
    if (unit.changing || !input) return {WakeReason::changing};
    if (*input != unit.input) return {WakeReason::input};
    for (const Source& source : unit.sources)
        if (units_[source.unit].version != source.seen) return {WakeReason::unit, source.unit};
    return {};
}

std::vector<Wake> RestState::choose(const std::vector<UnitInput>& inputs) const {
    std::vector<Wake> wakes(units_.size());
    for (size_t unit = 0; unit < units_.size(); ++unit) wakes[unit] = own_wake(units_[unit], inputs[unit]);
    // A unit that wakes also wakes the units that read its results in the same frame.
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t unit = 0; unit < units_.size(); ++unit) {
            if (wakes[unit].reason != WakeReason::rests || !units_[unit].exists) continue;
            const auto awake = std::ranges::find_if(units_[unit].sources, [&](const Source& source) {
                return !source.previous_frame && wakes[source.unit].reason != WakeReason::rests;
            });
            if (awake == units_[unit].sources.end()) continue;
            wakes[unit] = {WakeReason::unit, awake->unit};
            changed = true;
        }
    }
    return wakes;
}

void RestState::inherit(const RestState& old, const std::vector<uint32_t>& same) {
    for (uint32_t id = 0; id < units_.size(); ++id) {
        if (same[id] == kNoId) continue;
        const Unit& from = old.units_[same[id]];
        Unit& unit = units_[id];
        unit.has_run = from.has_run;
        unit.version = from.version;
        unit.input = from.input;
        for (Source& source : unit.sources) {
            const auto known = std::ranges::find_if(from.sources, [&](const Source& s) {
                return s.unit == same[source.unit] && s.previous_frame == source.previous_frame;
            });
            // No unit has this version, so the unit runs if it reads a unit that the older plan did not have.
            source.seen = known == from.sources.end() ? UINT64_MAX : known->seen;
        }
    }
}

void RestState::commit(const std::vector<UnitInput>& inputs, const std::vector<Wake>& chosen) {
    const auto runs = [&](uint32_t unit) { return chosen[unit].reason != WakeReason::rests; };
    for (uint32_t id = 0; id < units_.size(); ++id) {
        if (!runs(id)) continue;
        Unit& unit = units_[id];
        unit.has_run = true;
        unit.input = inputs[id].value_or(std::vector<std::byte>{});
        for (Source& source : unit.sources) {
            const uint64_t before = units_[source.unit].version;
            source.seen = before + (!source.previous_frame && runs(source.unit) ? 1 : 0);
        }
    }
    for (uint32_t id = 0; id < units_.size(); ++id)
        if (runs(id)) ++units_[id].version;
}

}  // namespace weft
