// Purpose: a compiled frame. Everything an executor does is written here; it decides nothing itself.
// Units: bytes. Positions count in schedule order. Barriers at position p are recorded before the pass at p.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

using QueueIndex = uint32_t;

enum class CullReason : uint8_t { live, unused_output, upstream_culled };

struct LiveGraph {
    std::vector<uint8_t> live_passes;     // by PassId
    std::vector<uint8_t> live_resources;  // by ResourceId
    std::vector<CullReason> reasons;      // by PassId
    std::vector<std::string> details;     // by PassId: "nobody reads \"ssao\"", empty when live
};

// One candidate order and what it would have cost.
struct ScheduleCandidate {
    std::string name;  // "program", "forward", "backward"
    uint64_t peak_live_bytes = 0;
    uint32_t barrier_batches = 0;
    uint32_t queue_switches = 0;
};

struct Schedule {
    std::vector<PassId> order;       // live passes only
    std::vector<uint32_t> position;  // by PassId; kNoId when culled
    std::vector<QueueIndex> queue;   // by position
    std::vector<std::vector<uint32_t>>
        clocks;  // by position: per queue, 1 + the latest position known to precede
    std::vector<ScheduleCandidate> candidates;
    std::string chosen;
    uint32_t queue_count = 1;
};

// First and last schedule position that touches a transient. Not live: first > last.
struct LifetimeSpan {
    uint32_t first = 1;
    uint32_t last = 0;
};

struct Lifetimes {
    std::vector<LifetimeSpan> spans;  // by ResourceId
};

struct MemoryNeed {
    uint64_t size_bytes = 0;
    uint64_t alignment_bytes = 1;
    uint32_t type_bits = UINT32_MAX;  // heaps it may live in
};

// By ResourceId. Zero size for what needs no placement (imports).
using MemoryNeeds = std::vector<MemoryNeed>;

struct Placement {
    ResourceId resource = kNoId;
    uint32_t heap = 0;
    uint64_t offset_bytes = 0;
    uint64_t size_bytes = 0;
};

// `to` takes over memory that `from` held. With `wrap`, from's owner was in the frame before.
struct HandOver {
    ResourceId from = kNoId;
    ResourceId to = kNoId;
    bool wrap = false;
    bool operator==(const HandOver&) const = default;
};

struct HeapPlan {
    uint64_t size_bytes = 0;
    uint32_t type_bits = UINT32_MAX;
    bool buffers = false;  // granularity keeps buffers and images apart where it must
};

struct MemoryPlan {
    std::vector<HeapPlan> heaps;
    std::vector<Placement>
        placements;  // transients by (heap, offset, resource); persistent ones too, never shared
    std::vector<HandOver> hand_overs;  // sorted
    uint64_t sum_bytes = 0;            // if nothing were shared
    uint64_t peak_live_bytes = 0;
    uint32_t peak_position = 0;
    uint64_t heap_bytes = 0;
};

enum class LoadOp : uint8_t { load, clear, dont_care, none };
enum class StoreOp : uint8_t { store, dont_care, none };

struct AttachmentOps {
    uint32_t use = kNoId;  // index into the pass's uses
    LoadOp load = LoadOp::load;
    StoreOp store = StoreOp::store;
};

enum class BarrierReason : uint8_t { raw, war, waw, layout, hand_over, acquire_import, release_import };

// One dependency. Images: a transition of `range`; buffers: a memory dependency.
struct BarrierDecl {
    ResourceId resource = kNoId;
    SubresourceRange range;
    AccessState src;  // layout undefined: the content is dropped
    AccessState dst;
    uint32_t src_family = 0;
    uint32_t dst_family = 0;  // differs from src_family in an ownership transfer
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;  // the pass waited for, where one single pass explains it
    PassId to = kNoId;
    bool from_previous_frame = false;
    std::vector<ResourceId> hand_over_from;  // whose memory is taken over
};

struct PassStep {
    PassId pass = kNoId;
    std::vector<BarrierDecl> barriers;       // one vkCmdPipelineBarrier2 before the pass
    std::vector<AttachmentOps> attachments;  // colours by location, then depth
};

struct BarrierPlan {
    std::vector<PassStep> steps;        // by position
    std::vector<BarrierDecl> epilogue;  // imports into their exit states
    std::vector<BarrierDecl> prologue;  // run once: persistent resources into their boundary states
    uint32_t emitted = 0;
};

struct QueueWait {
    QueueIndex queue = 0;
    uint32_t batch = 0;  // wait for this batch of that queue
    StageMask stages = 0;
    bool previous_frame = false;
};

struct Batch {
    QueueIndex queue = 0;
    uint32_t first = 0;  // positions [first, first + count) in schedule order, all on `queue`
    uint32_t count = 0;
    std::vector<QueueWait> waits;
    bool signals = true;
    bool epilogue = false;  // records BarrierPlan::epilogue after its passes
};

struct SubmissionPlan {
    std::vector<Batch> batches;
};

// How every persistent or imported resource is left between two frames, per range.
struct BoundaryState {
    ResourceId resource = kNoId;
    SubresourceRange range;
    AccessState state;
    uint32_t family = 0;
};

struct FramePlan {
    ResolvedGraph graph;
    LiveGraph live;
    Schedule schedule;
    Lifetimes lifetimes;
    MemoryPlan memory;
    BarrierPlan barriers;
    SubmissionPlan submissions;
    std::vector<BoundaryState> boundary;
    std::string hash;  // 32 hex digits over everything above but provenance
};

}  // namespace weft
