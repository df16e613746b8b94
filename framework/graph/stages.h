// Purpose: the compiler's table of contents. Each stage is a free function that consumes what earlier stages
// made and returns something immutable; there is no way back.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/barrier_history.h"
#include "graph/json_doc.h"
#include "graph/scopes.h"
#include "weft/declaration.h"
#include "weft/device_profile.h"
#include "weft/graph_desc.h"
#include "weft/imports.h"
#include "weft/limits.h"
#include "weft/pass.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/shader_interface.h"

namespace weft {

// --- what is written
// ----------------------------------------------------------------------------------------------
struct GraphReading {
    std::string include_root = {};  // where included files are looked for as well; empty: nowhere
    GraphLimits limits = {};
};
// The file and all that it includes. Errors: as read_json(); W126 an include that isn't there or lies
// outside, W127 files that include each other.
[[nodiscard]] Result<JsonDoc> read_graph(const std::string& path, const FileReader& reader,
                                         const GraphReading& reading = {});

// --- what did the author ask for
// ------------------------------------------------------------------------------- Shorthand becomes objects,
// so that a patch adds to a thing instead of replacing it. Then, as RFC 7396 says, each file goes over those
// that it includes, and the tier over them all: null removes, objects are merged, anything else replaces.
// Errors: W128 null where there is nothing to remove, W129 no such tier, W131 a tier sets no parameter.
[[nodiscard]] Result<JsonDoc> merge(JsonDoc document, const std::string& tier = {});
// The tiers' names, in the order written; of files that don't say what tiers are, none.
[[nodiscard]] std::vector<std::string> tier_names(const JsonDoc& document);
[[nodiscard]] Result<GraphDesc> parse(const JsonDoc& document, const GraphLimits& limits = {});

// --- what does it mean
// -----------------------------------------------------------------------------------------
struct ResolveInput {
    const GraphDesc& graph;
    const PassCatalog& passes;
    const ShaderCatalog& shaders;
    const ImportCatalog& imports;
    const DeviceProfile& profile;
    std::map<std::string, double> params;  // overrides, by name
    Extent3D output_extent{1280, 720, 1};
    std::vector<std::string> observed;  // references ("name@pass.mip(e)") that must be produced as well
    GraphLimits limits = {};
    // Of images with alternatives, by name: the first ones are not to be used, though the device has them.
    std::map<std::string, size_t> skipped_formats = {};
};
// Values that parameters may not have, defaults among them, and names that the graph doesn't know: W120.
[[nodiscard]] Diagnostics param_faults(const GraphDesc& graph, const std::map<std::string, double>& params);
// Warnings go to `warnings`.
[[nodiscard]] Result<ResolvedGraph> resolve(const ResolveInput& input, Diagnostics& warnings);

// --- what survives, in which order, where, when
// ----------------------------------------------------------------
[[nodiscard]] LiveGraph cull(const ResolvedGraph& graph, bool keep_all = false);
// `needs` weighs the candidates' memory. W150 on a cycle is resolve()'s: here the edges are acyclic.
[[nodiscard]] Schedule schedule(const ResolvedGraph& graph, const LiveGraph& live, const MemoryNeeds& needs,
                                const std::vector<LogicalQueue>& queues = {LogicalQueue{}});
// Load and store operations come first: they count as accesses.
[[nodiscard]] std::vector<std::vector<AttachmentOps>> attachment_ops(const ResolvedGraph& graph,
                                                                     const LiveGraph& live,
                                                                     const Schedule& order);
// What synchronisation follows from the accesses alone, before memory is shared.
struct SyncTable {
    std::vector<ResourceHistory> histories;  // by ResourceId
    std::vector<QueueDependency> dependencies;
    std::vector<uint8_t> concurrent;  // by ResourceId
    ScopeTable scopes;                // those candidates that no barrier divides
};
[[nodiscard]] SyncTable synchronize(const ResolvedGraph& graph, const Schedule& order,
                                    const std::vector<std::vector<AttachmentOps>>& attachments,
                                    ScopeTable candidates);
// The schedule with its clocks, by what the queues wait for.
[[nodiscard]] Schedule add_clocks(Schedule order, const std::vector<QueueDependency>& dependencies);
[[nodiscard]] Lifetimes lifetimes(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order);
[[nodiscard]] MemoryPlan alias(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order,
                               const Lifetimes& spans, const MemoryNeeds& needs, uint64_t granularity_bytes);

// --- what has to be waited for, and who submits what
// -----------------------------------------------------------
// Memory that is handed over from another queue adds to `dependencies`.
[[nodiscard]] BarrierPlan barriers(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                                   const MemoryPlan& memory,
                                   std::vector<std::vector<AttachmentOps>> attachments,
                                   std::vector<QueueDependency>& dependencies);
[[nodiscard]] SubmissionPlan submissions(const Schedule& order,
                                         const std::vector<QueueDependency>& dependencies);
[[nodiscard]] FramePlan link(ResolvedGraph graph, LiveGraph live, Schedule order, const SyncTable& sync,
                             Lifetimes spans, MemoryPlan memory, BarrierPlan barriers,
                             SubmissionPlan submissions);

}  // namespace weft
