// Finds the passes that a frame needs: passes with side effects, passes that write the output or a resource
// that the program reads between frames, and all passes whose results a needed pass reads. An `after` only
// orders two passes; it does not make a pass needed.
#include <algorithm>

#include "graph/model/rows.h"
#include "graph/resolve/cull.h"

namespace weft {
namespace {

bool is_root(const ResolvedGraph& graph, const PassDecl& pass) {
    if (pass.side_effect) return true;
    return std::any_of(pass.uses.begin(), pass.uses.end(), [&](const UseDecl& use) {
        if (!writes(use.access)) return false;
        return (graph.output != kNoId && use.resource == graph.output) ||
               graph.resources[use.resource].between.has_value();
    });
}

void keep(PassId pass, LiveGraph& live, std::vector<PassId>& pending) {
    if (live.live_passes[pass]) return;
    live.live_passes[pass] = 1;
    pending.push_back(pass);
}

// A ring is the set of copies of a resource with history; age 0 is the copy of the current frame. Returns,
// for each resource of age 0 in a ring, the passes that write this resource. Index: ResourceId.
Rows<PassId> ring_writers(const ResolvedGraph& graph) {
    return make_rows<PassId>(graph.resources.size(), [&](const auto& add) {
        for (PassId id(0); id < graph.passes.size(); ++id)
            for (const UseDecl& use : graph.passes[id].uses)
                if (writes(use.access) && graph.resources[use.resource].ring == use.resource)
                    add(use.resource, id);
    });
}

// A ring is the set of copies of a resource with history. Keeps either all copies of a ring or none: the
// copies rotate from frame to frame, so if one copy is used, each copy is used.
void mark_rings(const ResolvedGraph& graph, LiveGraph& live) {
    std::vector<uint8_t> used(graph.resources.size(), 0);
    for (ResourceId id(0); id < graph.resources.size(); ++id)
        if (graph.resources[id].ring != kNoId && live.live_resources[id]) used[graph.resources[id].ring] = 1;
    for (ResourceId id(0); id < graph.resources.size(); ++id)
        if (graph.resources[id].ring != kNoId) live.live_resources[id] = used[graph.resources[id].ring];
}

// Marks the passes and resources that the frame needs. If a pass reads content from before the frame, the
// writers of that resource are needed too, because they write the content in the previous frame.
void mark_live(const ResolvedGraph& graph, bool keep_all, LiveGraph& live) {
    const Rows<PassId> writers = ring_writers(graph);
    const bool has_switches = !graph.switches.empty();
    std::vector<PassId> pending;
    pending.reserve(graph.passes.size());
    for (PassId id(0); id < graph.passes.size(); ++id)
        if (keep_all || is_root(graph, graph.passes[id])) keep(id, live, pending);
    const auto keep_writer = [&](ResourceId resource, const VersionSource& version) {
        if (version.producer != kNoId) return keep(version.producer, live, pending);
        if (graph.resources[resource].ring == kNoId) return;
        for (const PassId writer : writers[graph.resources[resource].ring]) keep(writer, live, pending);
    };
    while (!pending.empty()) {
        const PassDecl& pass = graph.passes[pending.back()];
        pending.pop_back();
        for (const UseDecl& use : pass.uses) {
            live.live_resources[use.resource] = 1;
            for (const VersionSource& source : use.sources) keep_writer(use.resource, source);
            if (!has_switches) continue;
            // While the pass is switched off, the readers of its output see the versions in `passes_on`
            // instead. So the passes that write these versions stay live, too.
            for (const VersionSource& version : use.passes_on) keep_writer(use.resource, version);
        }
    }
}

void mark_retained(const ResolvedGraph& graph, std::span<const std::string> names, LiveGraph& live) {
    live.retained.assign(graph.resources.size(), 0);
    for (const std::string& name : names) {
        const ResourceId id = find_resource(graph, name);
        if (id == kNoId || live.live_resources[id] || !graph.resources[id].shared) continue;
        live.live_resources[id] = live.retained[id] = 1;
    }
}

// The passes that read the outputs of a pass: the first of them, and whether there are several.
struct Readers {
    PassId first = kNoId;
    bool several = false;
};

// Returns the readers of each pass, indexed by PassId.
std::vector<Readers> readers_by_producer(const ResolvedGraph& graph) {
    std::vector<Readers> readers(graph.passes.size());
    for (PassId id(0); id < graph.passes.size(); ++id)
        for (const UseDecl& use : graph.passes[id].uses)
            for (const VersionSource& source : use.sources) {
                if (source.producer == kNoId) continue;
                Readers& found = readers[source.producer];
                if (found.first == kNoId)
                    found.first = id;
                else if (found.first != id)
                    found.several = true;
            }
    return readers;
}

std::string quoted(const std::string& name) {
    return "\"" + name + "\"";
}

std::string written_names(const ResolvedGraph& graph, const PassDecl& pass) {
    std::vector<ResourceId> written;
    for (const UseDecl& use : pass.uses)
        if (writes(use.access) && std::find(written.begin(), written.end(), use.resource) == written.end())
            written.push_back(use.resource);
    std::string names;
    for (const ResourceId id : written)
        names += (names.empty() ? "" : ", ") + quoted(graph.resources[id].name);
    return names;
}

void explain(const ResolvedGraph& graph, LiveGraph& live) {
    if (std::ranges::find(live.live_passes, 0) == live.live_passes.end()) return;
    const std::vector<Readers> readers = readers_by_producer(graph);
    for (PassId id(0); id < graph.passes.size(); ++id) {
        if (live.live_passes[id]) continue;
        const std::string names = written_names(graph, graph.passes[id]);
        if (readers[id].first != kNoId) {
            live.reasons[id] = CullReason::upstream_culled;
            live.details[id] =
                names + " is read only by " + quoted(graph.passes[readers[id].first].name) +
                (readers[id].several ? " and others, which are culled too" : ", which is culled too");
            continue;
        }
        live.reasons[id] = CullReason::unused_output;
        live.details[id] =
            names.empty() ? "the pass writes nothing and has no side effect" : "no pass reads " + names;
    }
}

}  // namespace

LiveGraph cull(const ResolvedGraph& graph, bool keep_all, std::span<const std::string> retained) {
    LiveGraph live;
    live.live_passes.assign(graph.passes.size(), 0);
    live.live_resources.assign(graph.resources.size(), 0);
    live.reasons.assign(graph.passes.size(), CullReason::live);
    live.details.assign(graph.passes.size(), {});
    mark_live(graph, keep_all, live);
    mark_rings(graph, live);
    mark_retained(graph, retained, live);
    explain(graph, live);
    return live;
}

}  // namespace weft
