// Purpose: defines a compiled frame, the plan. It contains all decisions about a frame: order, queues,
// barriers, memory and submissions. An executor only records and submits it. Units: bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft {

using QueueIndex = Id<struct QueueTable>;
// An index into Schedule::order.
using Position = Id<struct OrderTable>;
// The first queue of each plan, a graphics queue. It runs the prologue (the commands before the first frame)
// and the epilogue (the commands at the end of each frame).
inline constexpr QueueIndex kGraphicsQueue(0);

// A queue of a plan. The executor maps it to a device queue of the given family. Several logical queues may
// use one device queue.
struct LogicalQueue {
    QueueKind kind = QueueKind::graphics;  // The most capable kind of work that the queue supports.
    uint32_t family = 0;                   // Queue family: an index into DeviceProfile::queue_families.
    bool operator==(const LogicalQueue&) const = default;
};

enum class CullReason : uint8_t {
    live,             // The pass is not culled.
    unused_output,    // No pass reads the outputs of the pass.
    upstream_culled,  // Only culled passes read the outputs of the pass.
};

struct LiveGraph {
    std::vector<uint8_t> live_passes;  // By PassId: 1 if the pass is live (not culled), else 0.
    // By ResourceId: 1 if the resource is retained, or if a live pass uses the resource or another resource
    // of its ring (the copies of a resource with history), else 0.
    std::vector<uint8_t> live_resources;
    // By ResourceId: 1 if no live pass uses the resource, but the plan retains its memory and its content for
    // the plan of another tier (CompileOptions::retained), else 0.
    std::vector<uint8_t> retained;
    std::vector<CullReason> reasons;  // By PassId: the kind of reason why the pass is culled.
    // By PassId: the reason as text, such as "no pass reads \"ssao\""; empty for live passes.
    std::vector<std::string> details;
};

// One order of the passes that the scheduler compared with other orders, with its cost.
struct ScheduleCandidate {
    std::string name;  // The method that made the order: "program", "forward" or "backward".
    uint64_t peak_live_bytes = 0;
    uint32_t barrier_batches = 0;
    uint32_t queue_switches = 0;
};

// One vector clock for each schedule position, all in one array. clocks[p][q] is 1 + the latest position on
// queue q that is certain to run before position p in the same frame, or 0 if there is none.
struct ClockTable {
    uint32_t queue_count = 1;
    std::vector<uint32_t> values;

    [[nodiscard]] std::span<const uint32_t> operator[](Position position) const {
        return std::span(values).subspan(size_t{position} * queue_count, queue_count);
    }
    [[nodiscard]] std::span<uint32_t> operator[](Position position) {
        return std::span(values).subspan(size_t{position} * queue_count, queue_count);
    }
    [[nodiscard]] size_t size() const { return values.size() / queue_count; }
    bool operator==(const ClockTable&) const = default;
};

struct Schedule {
    std::vector<PassId> order;  // The live passes in the order in which they run.
    // By PassId: the position of the pass in `order`; kNoId if the pass is culled.
    std::vector<Position> position;
    std::vector<QueueIndex> queue;  // By position: the queue on which the pass runs.
    ClockTable clocks;
    std::vector<ScheduleCandidate> candidates;
    std::string chosen;
    std::vector<LogicalQueue> queues{LogicalQueue{}};
};

struct QueueSpan {
    QueueIndex queue = kGraphicsQueue;
    Position first = 0;
    Position last = 0;
};

// The first and the last schedule position at which a transient resource is used. If the resource is not
// live, first > last.
struct LifetimeSpan {
    Position first = 1;
    Position last = 0;
    // First and last position on each queue that uses the resource, in the order of the first use. Empty if
    // the plan has only one queue.
    std::vector<QueueSpan> queues;
};

struct Lifetimes {
    std::vector<LifetimeSpan> spans;  // By ResourceId: the lifetime of each resource.
};

struct MemoryNeed {
    uint64_t size_bytes = 0;
    uint64_t alignment_bytes = 1;
    // The memory types that the resource may use, one bit for each type, as in
    // VkMemoryRequirements::memoryTypeBits.
    uint32_t type_bits = UINT32_MAX;
};

// The memory requirements of each resource; index: ResourceId. The size is 0 for imports, because the plan
// does not allocate their memory.
using MemoryNeeds = std::vector<MemoryNeed>;

struct Placement {
    ResourceId resource = kNoId;
    uint32_t heap = 0;
    uint64_t offset_bytes = 0;
    uint64_t size_bytes = 0;

    [[nodiscard]] uint64_t end_bytes() const { return offset_bytes + size_bytes; }
};

// The resource `to` takes over memory that the resource `from` used before. If `wrap` is true, `from` used
// the memory in the previous frame; then `from` and `to` may be the same resource.
struct AliasTransition {
    ResourceId from = kNoId;
    ResourceId to = kNoId;
    bool wrap = false;
    bool operator==(const AliasTransition&) const = default;
};

struct HeapPlan {
    uint64_t size_bytes = 0;
    uint32_t type_bits = UINT32_MAX;
    // True: the heap contains only buffers. Buffers and images get separate heaps if the device's
    // bufferImageGranularity is so large that padding between them would waste memory.
    bool buffers = false;
    bool persistent = false;  // True: the heap contains persistent resources, which share no memory.
    // True: the heap contains one resource with `"keep": "shared"`. It is the memory of this resource in all
    // plans that follow each other.
    bool shared = false;
};

struct MemoryPlan {
    std::vector<HeapPlan> heaps;
    // The places of all resources in the heaps, sorted by (heap, offset, resource). Transient resources may
    // overlap; persistent resources never do.
    std::vector<Placement> placements;
    // All takeovers of memory by transient resources, sorted by (to, from, wrap).
    std::vector<AliasTransition> alias_transitions;
    // Sum of the sizes of all live transient resources: the memory that they would need without sharing.
    uint64_t sum_bytes = 0;
    uint64_t peak_live_bytes = 0;
    Position peak_position = 0;
    uint64_t heap_bytes = 0;        // Total size of the heaps for transient resources.
    uint64_t persistent_bytes = 0;  // Total size of the heaps for persistent resources.
};

enum class LoadOp : uint8_t { load, clear, dont_care, none };
enum class StoreOp : uint8_t { store, dont_care, none };

struct AttachmentOps {
    uint32_t use = kNoId;  // The attachment's use: an index into PassDecl::uses.
    LoadOp load = LoadOp::load;
    StoreOp store = StoreOp::store;
};

enum class BarrierReason : uint8_t {
    raw,
    war,
    waw,
    layout,
    alias,  // Alias transition: the resource takes over memory that another resource used before.
    acquire_import,
    release_import,
    release_queue,  // First half of an ownership transfer: on the old queue family, after the last use there.
    // Second half of an ownership transfer: on the new queue family, before the first use there.
    acquire_queue,
    prologue,
};

// One dependency between accesses to a resource. For an image, it is an image barrier of `range`; for a
// buffer, a barrier of the whole buffer. An alias transition also needs a global VkMemoryBarrier2, because
// its source accesses belong to other resources. The stages are stages of the queue that records the barrier.
// Semaphores order accesses on different queues and make the data visible. A barrier for accesses on
// different queues only changes the layout or the owner.
struct BarrierDecl {
    ResourceId resource = kNoId;
    SubresourceRange range;
    AccessState src;  // The accesses to wait for. Layout `undefined`: the old content is discarded.
    AccessState dst;
    // Queue families of the old and the new owner. If they differ, the barrier is part of an ownership
    // transfer.
    uint32_t src_family = 0;
    uint32_t dst_family = 0;
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;  // The pass to wait for, if a single pass is the reason for the barrier; else kNoId.
    PassId to = kNoId;    // The pass before which the barrier is recorded; kNoId if it is not before a pass.
    bool from_previous_frame = false;  // True: the accesses to wait for are in the previous frame.
    // True: the pass of this step has a rest unit (passes that run together or not at all in a frame). The
    // barrier is recorded only in frames in which this pass runs.
    bool if_pass_runs = false;
    std::vector<ResourceId> aliased_from;  // For alias transitions: the resources whose memory is taken over.
};

struct PassStep {
    PassId pass = kNoId;
    // Barriers before the pass. All are recorded with one vkCmdPipelineBarrier2.
    std::vector<BarrierDecl> barriers;
    // Barriers after the pass: releases to other queue families, and layout transitions for readers on
    // several queues. All are recorded with one vkCmdPipelineBarrier2.
    std::vector<BarrierDecl> after;
    // Load and store operations of the attachments: colours sorted by location, then depth.
    std::vector<AttachmentOps> attachments;
    // True: the pass draws inside the rendering scope (vkCmdBeginRendering) that the previous pass on its
    // queue began. A chain of such passes has one scope, with the load operations of the first pass and the
    // store operations of the last pass.
    bool merges_render_pass = false;
};

// The commands that run once before the first frame, on queue 0. They initialise the persistent resources
// that frames use, including all copies of each resource with history (ResourceDecl::history).
struct ProloguePlan {
    std::vector<BarrierDecl> before;  // Layout transitions from `undefined`, before the clears.
    std::vector<ResourceId> cleared;  // Resources to clear completely to ResourceDecl::first_frame.
    std::vector<BarrierDecl> after;   // Transitions to the layouts that the first frame expects.
};

struct BarrierPlan {
    // For each pass: its barriers and attachment operations. Index: the position of the pass.
    std::vector<PassStep> steps;
    // Transitions of imports to their exit states, and of persistent resources to ResourceDecl::between. They
    // are recorded at the end of the last batch of queue 0.
    std::vector<BarrierDecl> epilogue;
    ProloguePlan prologue;
    // By ResourceId: 1 if several queue families share the resource, so that it needs no ownership transfers;
    // else 0.
    std::vector<uint8_t> concurrent;
    uint32_t emitted = 0;  // Number of barriers that a frame records, without the prologue.
};

// The pass at position `to` must not start before the pass at position `from` completes, and the two passes
// run on different queues. If `previous_frame` is true, `from` is a position in the previous frame. The
// position after the last pass stands for the barriers at the end of the frame (BarrierPlan::epilogue).
struct QueueDependency {
    Position from = 0;
    Position to = 0;
    bool previous_frame = false;
    // The resource that is the reason for the dependency; kNoId if the reason is the key `after` of a pass in
    // the graph file.
    ResourceId resource = kNoId;
    bool operator==(const QueueDependency&) const = default;
};

// A wait for a batch of another queue. The waiting batch starts its first command only after the other batch
// is complete and all memory writes of that batch are visible.
struct QueueWait {
    // The batch to wait for: an index into SubmissionPlan::batches. It is on another queue.
    uint32_t batch = 0;
    bool previous_frame = false;
    uint32_t dependency = kNoId;  // The reason for the wait: an index into SubmissionPlan::dependencies.
};

// The passes of a queue between two waits or signals; they are one submission. If the plan has several
// batches, each queue has a timeline semaphore. A batch that completes sets the semaphore of its queue to
// frame × n + i + 1. n is the number of batches of a frame on this queue, i is the index of the batch among
// them, and `frame` counts from 0.
struct Batch {
    QueueIndex queue = kGraphicsQueue;
    std::vector<Position> positions;  // Positions of the passes, in schedule order. All run on `queue`.
    std::vector<QueueWait> waits;
    bool epilogue = false;  // True: the batch records BarrierPlan::epilogue after its passes.
};

struct SubmissionPlan {
    // Sorted by the first position of each batch. It is valid to submit the batches in this order.
    std::vector<Batch> batches;
    // The dependencies for which batches wait. QueueWait::dependency is an index into this list.
    std::vector<QueueDependency> dependencies;
};

// The state of a part of a persistent or imported resource at the start of every frame. For a persistent
// resource, only the layout in `state` is set. The reads of the program between frames are not in `state`,
// but in ResourceDecl::between.
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
};

}  // namespace weft
