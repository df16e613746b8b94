#include "viewer/commands/verify_rest.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "viewer/commands/session_setup.h"

namespace weft::viewer {
namespace {

// A rest unit is a set of passes with "rest" that run together, or a round of a group. Returns true if the
// rest unit of the pass may have other results than if it ran in every frame. Only the keys of the unit
// itself are examined. The result is true for a port with "wakes": false, and for a group whose rounds take
// turns, do not rest, or run again after a change (`settle`).
bool may_differ(const FramePlan& plan, const PassDecl& pass) {
    const GroupDecl* group = find_group(plan.graph, pass.rest_unit);
    if (group != nullptr && (!group->rests || group->is_limited() || group->settle > 0)) return true;
    return std::ranges::any_of(pass.uses, [](const UseDecl& use) { return !use.wakes; });
}

// Returns for each rest unit 1 if it may have other results than if it ran in every frame, and 0 otherwise.
// The reason is in the unit itself (see may_differ()), or in another unit whose results this unit reads
// directly or indirectly.
std::vector<uint8_t> find_different(const FramePlan& plan) {
    std::vector<uint8_t> differs(plan.graph.rest_unit_count, 0);
    for (const PassDecl& pass : plan.graph.passes)
        if (pass.rest_unit != kNoId && may_differ(plan, pass)) differs[pass.rest_unit] = 1;
    for (bool changed = true; changed;) {
        changed = false;
        for (const PassDecl& pass : plan.graph.passes)
            for (const UseDecl& use : pass.uses)
                for (const VersionSource& source : use.sources) {
                    if (pass.rest_unit == kNoId || differs[pass.rest_unit] != 0 || source.producer == kNoId)
                        continue;
                    const uint32_t from = plan.graph.passes[source.producer].rest_unit;
                    if (from == kNoId || differs[from] == 0) continue;
                    differs[pass.rest_unit] = 1;
                    changed = true;
                }
    }
    return differs;
}

// A rest unit is a pass with "rest", or a round of a group. Returns the names of all resources that are
// written by rest units, in the order of the plan. Resources of units for which find_different() returns 1
// are left out. Transient resources of groups are left out, too, because they have content only while a round
// runs.
std::vector<std::string> rested_resources(const FramePlan& plan) {
    const std::vector<uint8_t> different = find_different(plan);
    std::vector<std::string> names;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.rest_unit == kNoId || different[pass.rest_unit] != 0) continue;
        const bool in_group = find_group(plan.graph, pass.rest_unit) != nullptr;
        for (const UseDecl& use : pass.uses) {
            const ResourceDecl& resource = plan.graph.resources[use.resource];
            if (in_group && resource.lifetime == ResourceLifetime::transient) continue;
            if (writes(use.access) && std::ranges::find(names, resource.name) == names.end())
                names.push_back(resource.name);
        }
    }
    return names;
}

// Returns the passes with "rest" that write the resource, for messages.
std::string writers_of(const FramePlan& plan, const std::string& resource) {
    std::string names;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        const bool found = std::ranges::any_of(pass.uses, [&](const UseDecl& use) {
            return writes(use.access) && plan.graph.resources[use.resource].name == resource;
        });
        if (found) names += (names.empty() ? "\"" : ", \"") + pass.name + "\"";
    }
    return names;
}

Status render_one(OpenSession& open, const RenderOptions& options, uint32_t frame) {
    open.frame.delta_time_s = options.fixed_dt_s;
    open.frame.time_s = frame * options.fixed_dt_s;
    if (Status done = open.session->render_frame(open.frame); !done) return done;
    return open.session->finish();
}

Diagnostic difference(const FramePlan& plan, const vk::ReadbackData& found, const vk::ReadbackData& wanted,
                      uint32_t frame) {
    const std::string resource = found.pass.substr(found.pass.find(':') + 1);
    const auto place = std::ranges::mismatch(found.bytes, wanted.bytes);
    const ResourceId id = find_resource(plan.graph, resource);
    Diagnostic d = plan.graph.sources.error(id == kNoId ? SourceLoc{} : plan.graph.resources[id].loc, "W189",
                                            "in frame " + std::to_string(frame) + ", \"" + resource +
                                                "\" differs from a run in which no pass rests, from byte " +
                                                std::to_string(place.in1 - found.bytes.begin()) +
                                                " on; it is written by pass " + writers_of(plan, resource));
    d.help = {"let the shader write every texel of its outputs, with values that depend only on its inputs",
              "or remove \"rest\" from the pass"};
    return d;
}

}  // namespace

Status verify_rest(const RenderOptions& options, const FramePlan& plan, uint32_t frames) {
    const std::vector<std::string> names = rested_resources(plan);
    if (names.empty()) {
        std::fputs(
            plan.graph.rest_unit_count == 0
                ? "weft: nothing to verify: no pass of this graph has \"rest\"\n"
                : "weft: nothing to verify: all passes with \"rest\" depend on a port with \"wakes\": false "
                  "or on a group whose rounds take turns, so their results may differ from those of a run "
                  "in which all of them run\n",
            stderr);
        return Unit{};
    }
    RenderOptions resting = options, running = options;
    for (RenderOptions* o : {&resting, &running}) {
        o->resource.clear();
        o->request.debug.clear();
        o->request.observed = names;
        o->quiet = true;
    }
    running.request.rests = false;
    Result<OpenSession> a = open_session(resting), b = open_session(running);
    if (!a) return a.take_errors();
    if (!b) return b.take_errors();
    uint32_t rested = 0, all = 0;
    for (uint32_t frame = 0; frame < frames; ++frame) {
        if (Status done = render_one(*a, options, frame); !done) return done;
        if (Status done = render_one(*b, options, frame); !done) return done;
        const std::vector<vk::ReadbackData> found = a->session->take_readbacks(),
                                            wanted = b->session->take_readbacks();
        // The first difference in the order of the plan is the cause of all others.
        for (const std::string& name : names) {
            const auto is_of = [&](const vk::ReadbackData& data) { return data.pass == "observe:" + name; };
            const auto x = std::ranges::find_if(found, is_of), y = std::ranges::find_if(wanted, is_of);
            if (x != found.end() && y != wanted.end() && x->bytes != y->bytes)
                return difference(plan, *x, *y, frame);
        }
        for (const vk::FrameTiming& timing : a->session->take_timings())
            for (const vk::PassTiming& pass : timing.passes) {
                rested += pass.rested ? 1 : 0;
                all += pass.rested || !pass.woken_by.empty() ? 1 : 0;
            }
    }
    if (rested == 0)
        std::fputs(
            "weft: no pass rested in these frames, so nothing was verified; render more frames (--frames), "
            "and see weft explain FILE rest PASS\n",
            stderr);
    else
        std::fprintf(stderr,
                     "weft: verified %u frames: passes with \"rest\" rested %u of %u times, and all "
                     "resources that they write (%zu) had the same bytes as if these passes had always run\n",
                     frames, rested, all, names.size());
    return Unit{};
}

}  // namespace weft::viewer
