// Purpose: the compiler's front door: a resolved graph and the device's memory needs in, a frozen plan out.
#pragma once

#include <string>
#include <vector>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft {

struct CompileOptions {
    bool keep_all_passes = false;  // no culling
    uint64_t granularity_bytes = 64;
    std::vector<LogicalQueue> queues{LogicalQueue{}};  // the first one is a graphics queue
};

// How long one stage took, for benches.
struct StageTime {
    std::string stage;
    double us = 0;
};

// `count` logical queues for a device: graphics, then compute, transfer and a second compute queue, each in
// the family that can do the least besides. Families that the device lacks fall back to more capable ones.
[[nodiscard]] std::vector<LogicalQueue> logical_queues(const DeviceProfile& profile, uint32_t count);

// Runs cull to link. The checker shares no code with these stages and is not called here: callers prove the
// plan with check_plan() (weft/check/check_plan.h), as every test and every debug build does.
// `times` receives the time of every stage, in the order in which the stages run.
[[nodiscard]] FramePlan compile(const ResolvedGraph& graph, const MemoryNeeds& needs,
                                const CompileOptions& options, std::vector<StageTime>* times = nullptr);

// Needs from contents alone: exact bytes at `alignment_bytes`, every heap allowed. For tests and `weft plan`.
[[nodiscard]] MemoryNeeds content_needs(const ResolvedGraph& graph, uint64_t alignment_bytes = 16);

// Needs as a device of this profile would state them: padded rows, extra bytes, alignments, and the types of
// memory that may hold each resource. Attachments that nothing else uses go into lazily allocated memory
// where there is some.
[[nodiscard]] MemoryNeeds profile_needs(const ResolvedGraph& graph, const DeviceProfile& profile);

// The canonical hash of a plan: 32 hex digits.
[[nodiscard]] std::string plan_hash(const FramePlan& plan);
// The same without what a running plan can change between two frames: values of parameters and constants, and
// the state of pipelines. Plans of one structure have the same resources, passes, barriers and bindings.
[[nodiscard]] std::string structure_hash(FramePlan plan);

}  // namespace weft
