// Purpose: declares the compiler, which makes a plan from a resolved graph and the memory requirements of its
// resources.
#pragma once

#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft {

struct CompileOptions {
    bool keep_all_passes = false;     // True: no pass is culled.
    uint64_t granularity_bytes = 64;  // VkPhysicalDeviceLimits::bufferImageGranularity of the device.
    // The logical queues of the plan. The first queue must be a graphics queue.
    std::vector<LogicalQueue> queues{LogicalQueue{}};
    // Names of resources with `"keep": "shared"` that an older plan uses. If no pass of the new plan uses
    // such a resource, the new plan retains its memory and its content, so that a later plan can continue
    // with them.
    std::vector<std::string> retained;
};

// The time that one stage of the compiler took, in microseconds. Benchmarks report it.
struct StageTime {
    std::string stage;
    double us = 0;
};

// Returns the first `count` of these four logical queues for a device: graphics, compute, transfer, a second
// compute queue. QueueFamilyProfile::kind is the most capable kind of work of a family. Each queue uses a
// family with the same kind as the queue. If the device has no such family, the queue uses a more capable
// one.
[[nodiscard]] std::vector<LogicalQueue> logical_queues(const DeviceProfile& profile, uint32_t count);

// Returns the options for a plan on a device with this profile, with `queue_count` logical queues.
[[nodiscard]] CompileOptions compile_options(const DeviceProfile& profile, uint32_t queue_count);

// Runs the stages from cull() to link(). compile() does not check the plan: callers can do this with
// check_plan() (weft/check/check_plan.h). If `times` is not null, it gets the time of every stage, in the
// order in which the stages run.
// The plan contains the graph; move the graph into the call if it is not needed any more.
[[nodiscard]] FramePlan compile(ResolvedGraph graph, const MemoryNeeds& needs, const CompileOptions& options,
                                std::vector<StageTime>* times = nullptr);

// Returns memory requirements that depend on no device. Each resource has the exact size of its content and
// the alignment `alignment_bytes`, and may use any memory type.
[[nodiscard]] MemoryNeeds content_needs(const ResolvedGraph& graph, uint64_t alignment_bytes = 16);

// Returns the memory requirements on a device with this profile: sizes with padded rows and extra bytes,
// alignments, and the allowed memory types. Transient images that are only attachments get lazily allocated
// memory if the profile has a suitable memory type.
[[nodiscard]] MemoryNeeds profile_needs(const ResolvedGraph& graph, const DeviceProfile& profile);

// Returns the hash of a plan as 32 hexadecimal digits. The hash includes all members except places in files
// (SourceLoc, SourceMap) and ResolvedGraph::frames. compile() does not call plan_hash(), because that takes
// about as long as all stages together.
[[nodiscard]] std::string plan_hash(const FramePlan& plan);
// Returns the hash of everything in a plan that cannot change while the plan runs: resources, passes,
// barriers and bindings. The hash leaves out the values and costs (ParamCost) of parameters, the values of
// constants, the state of pipelines and PassDecl::flops, because a running executor can exchange these
// between two frames.
[[nodiscard]] std::string structure_hash(FramePlan plan);
// Returns the hash of the members that structure_hash() leaves out, except the costs of parameters. It
// depends only on the graph. Two plans with equal structure_hash() and equal values_hash() do the same work.
[[nodiscard]] std::string values_hash(const ResolvedGraph& graph);

}  // namespace weft
