// Purpose: the compiler: makes a plan from a resolved graph and the device's memory requirements.
#pragma once

#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft {

struct CompileOptions {
    bool keep_all_passes = false;  // disables culling
    uint64_t granularity_bytes = 64;
    std::vector<LogicalQueue> queues{LogicalQueue{}};  // the first one must be a graphics queue
};

// The time of one stage, for benchmarks.
struct StageTime {
    std::string stage;
    double us = 0;
};

// `count` logical queues for a device: graphics, then compute, transfer and a second compute queue. Each uses
// the family with the fewest other capabilities. If the device lacks such a family, a more capable one is
// used.
[[nodiscard]] std::vector<LogicalQueue> logical_queues(const DeviceProfile& profile, uint32_t count);

// The options for a device with this profile and `queue_count` logical queues.
[[nodiscard]] CompileOptions compile_options(const DeviceProfile& profile, uint32_t queue_count);

// Runs the stages from cull to link. The checker is not called here: callers check the plan with check_plan()
// (weft/check/check_plan.h), as every test and every debug build does. `times` gets the time of every stage,
// in the order in which the stages run.
[[nodiscard]] FramePlan compile(const ResolvedGraph& graph, const MemoryNeeds& needs,
                                const CompileOptions& options, std::vector<StageTime>* times = nullptr);

// Memory requirements from the contents alone: exact bytes at `alignment_bytes`, any heap. For tests and
// `weft plan`.
[[nodiscard]] MemoryNeeds content_needs(const ResolvedGraph& graph, uint64_t alignment_bytes = 16);

// Memory requirements of a device with this profile: padded rows, extra bytes, alignments, and the allowed
// memory types of each resource. Resources that are only attachments use lazily allocated memory if the
// profile has it.
[[nodiscard]] MemoryNeeds profile_needs(const ResolvedGraph& graph, const DeviceProfile& profile);

// The hash of a plan: 32 hexadecimal digits.
[[nodiscard]] std::string plan_hash(const FramePlan& plan);
// The hash without the parts that can change between two frames of a running plan: values of parameters and
// constants, and the state of pipelines. Plans with equal structure have the same resources, passes, barriers
// and bindings.
[[nodiscard]] std::string structure_hash(FramePlan plan);

}  // namespace weft
