// Finds the passes that a frame needs: passes with side effects, passes that write the output, and all passes
// whose results a needed pass reads. An `after` only orders two passes; it does not make a pass needed.
#include <algorithm>

#include "graph/resolve/cull.h"

namespace weft {
namespace {

bool is_root(const ResolvedGraph& graph, const PassDecl& pass) {
    if (pass.side_effect) return true;
    return std::any_of(pass.uses.begin(), pass.uses.end(), [&](const UseDecl& use) {
        return graph.output != kNoId && use.resource == graph.output && writes(use.access);
    });
}

void keep(PassId pass, LiveGraph& live, std::vector<PassId>& pending) {
    if (live.live_passes[pass]) return;
    live.live_passes[pass] = 1;
    pending.push_back(pass);
}

// Returns for each resource, indexed by ResourceId, the passes that write it.
std::vector<std::vector<PassId>> writers_by_resource(const ResolvedGraph& graph) {
    std::vector<std::vector<PassId>> writers(graph.resources.size());
    for (PassId id(0); id < graph.passes.size(); ++id)
        for (const UseDecl& use : graph.passes[id].uses)
            if (writes(use.access)) writers[use.resource].push_back(id);
    return writers;
}

// Keeps either all copies of a ring or none. The copies of a resource with history rotate from frame to
// frame, so each copy is used if one of them is.
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
    const std::vector<std::vector<PassId>> writers = writers_by_resource(graph);
    std::vector<PassId> pending;
    for (PassId id(0); id < graph.passes.size(); ++id)
        if (keep_all || is_root(graph, graph.passes[id])) keep(id, live, pending);
    while (!pending.empty()) {
        const PassDecl& pass = graph.passes[pending.back()];
        pending.pop_back();
        for (const UseDecl& use : pass.uses) {
            live.live_resources[use.resource] = 1;
            for (const VersionSource& source : use.sources) {
                if (source.producer != kNoId)
                    keep(source.producer, live, pending);
                else if (graph.resources[use.resource].ring != kNoId)
                    for (const PassId writer : writers[graph.resources[use.resource].ring])
                        keep(writer, live, pending);
            }
        }
    }
}

// Returns for each pass, indexed by PassId, the passes that read its outputs.
std::vector<std::vector<PassId>> readers_by_producer(const ResolvedGraph& graph) {
    std::vector<std::vector<PassId>> readers(graph.passes.size());
    for (PassId id(0); id < graph.passes.size(); ++id)
        for (const UseDecl& use : graph.passes[id].uses)
            for (const VersionSource& source : use.sources)
                if (source.producer != kNoId &&
                    (readers[source.producer].empty() || readers[source.producer].back() != id))
                    readers[source.producer].push_back(id);
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
    const std::vector<std::vector<PassId>> readers = readers_by_producer(graph);
    for (PassId id(0); id < graph.passes.size(); ++id) {
        if (live.live_passes[id]) continue;
        const std::string names = written_names(graph, graph.passes[id]);
        if (!readers[id].empty()) {
            live.reasons[id] = CullReason::upstream_culled;
            const std::string others = readers[id].size() > 1 ? " and others" : "";
            live.details[id] = names + " is read only by " + quoted(graph.passes[readers[id].front()].name) +
                               others +
                               (readers[id].size() > 1 ? ", which are culled too" : ", which is culled too");
            continue;
        }
        live.reasons[id] = CullReason::unused_output;
        live.details[id] =
            names.empty() ? "the pass writes nothing and has no side effect" : "no pass reads " + names;
    }
}

}  // namespace

LiveGraph cull(const ResolvedGraph& graph, bool keep_all) {
    LiveGraph live;
    live.live_passes.assign(graph.passes.size(), 0);
    live.live_resources.assign(graph.resources.size(), 0);
    live.reasons.assign(graph.passes.size(), CullReason::live);
    live.details.assign(graph.passes.size(), {});
    mark_live(graph, keep_all, live);
    mark_rings(graph, live);
    explain(graph, live);
    return live;
}

}  // namespace weft
