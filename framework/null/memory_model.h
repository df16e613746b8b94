// Purpose: the memory of a plan during execution: the content of every cell, the node that wrote it, and the
// accesses to which it is visible. Every copy of a persistent resource is a separate memory object, named
// after the resource it belonged to in frame 0. Resources whose placements overlap destroy each other's
// content. An access that is not ordered after an earlier conflicting access, or does not see its result,
// leaves poison. Source: Vulkan 1.3 specification, appendix "Memory Model" (availability, visibility, data
// races).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "null/null_executor.h"
#include "null/timeline.h"

namespace weft::null {

struct Visibility {
    uint32_t node = kNoNode;  // visible when this node has completed
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    bool any_stage = false;  // true for a semaphore: visible to all stages of this queue
    QueueIndex queue = 0;
};

// The last write of a cell, and where it is visible.
struct WriteRecord {
    uint32_t node = kNoNode;  // kNoNode: before all nodes, visible to all
    QueueIndex queue = 0;
    StageMask stage = stage::kNone;
    AccessMask access = access::kNone;
    std::vector<uint32_t> available_by;
    std::vector<Visibility> visible;
};

// State between the release by one queue family and the acquire by another.
struct Transfer {
    uint32_t node = kNoNode;
    uint32_t src_family = 0, dst_family = 0;
    Layout src_layout = Layout::undefined, dst_layout = Layout::undefined;
};

struct MemoryCell {
    CellValue value = kUndefinedValue;
    Layout layout = Layout::undefined;
    uint32_t family = kNoId;  // owning queue family; kNoId: the next family that uses it
    std::optional<Transfer> transfer;
    WriteRecord write;
    std::vector<uint32_t> readers;  // readers since that write
    // Frame of an unordered conflict. In one particular order a conflict may have no effect; to show it in
    // every order, all writes to this cell stay poison for the rest of that frame.
    uint32_t conflict_frame = kNoId;
};

// The node that accesses a cell, and its kind of access.
struct Accessor {
    uint32_t node = kNoNode;
    StageMask stage = stage::kNone;  // one bit; kNone: sees everything that is available
    AccessMask access = access::kNone;
    Layout layout = Layout::undefined;  // required layout
};

class Memory {
 public:
    Memory(const FramePlan& plan, const Timeline& timeline, uint64_t seed);

    // The memory object of a resource in a frame.
    [[nodiscard]] ResourceId object_of(ResourceId resource, uint32_t frame) const;
    [[nodiscard]] CellValue peek(ResourceId object, uint32_t cell) const {
        return cells_[object][cell].value;
    }

    // The value that the accessor sees. Poison is reported, but the cell keeps its value.
    [[nodiscard]] CellValue read(ResourceId object, uint32_t cell, const Accessor& accessor);
    // `overwrites`: the accessor must wait for readers, although it does not change the value.
    [[nodiscard]] CellValue leave(ResourceId object, uint32_t cell, const Accessor& accessor,
                                  bool overwrites);
    void write(ResourceId object, uint32_t cell, const Accessor& accessor, CellValue value);
    void barrier(uint32_t node);
    void signal(uint32_t node);
    void wait(uint32_t node);
    // Puts an import into its entry state. Before the first frame its content comes from its owner.
    void enter(ResourceId import, bool first);
    // An access by the import's owner before the frame: a pending write, or a read.
    void access_outside(uint32_t node, ResourceId import);

    [[nodiscard]] std::vector<std::string> take_faults() { return std::move(faults_); }

 private:
    [[nodiscard]] bool is_before(uint32_t first, uint32_t then) const;
    [[nodiscard]] bool drawn_in_scope_of(const WriteRecord& write, uint32_t node) const;
    [[nodiscard]] bool available(const WriteRecord& write, uint32_t node) const;
    [[nodiscard]] bool visible(const WriteRecord& write, const Accessor& accessor) const;
    [[nodiscard]] bool exclusive(ResourceId object) const;
    [[nodiscard]] uint32_t family_of(uint32_t node) const;
    [[nodiscard]] const char* why_not_usable(ResourceId object, const MemoryCell& cell,
                                             const Accessor& accessor) const;
    [[nodiscard]] const char* why_not_seen(const MemoryCell& cell, const Accessor& accessor) const;
    [[nodiscard]] const char* why_not_overwritten(const MemoryCell& cell, uint32_t node) const;
    [[nodiscard]] const char* take_from_neighbours(ResourceId object, uint32_t node);
    CellValue poison(const char* why, uint32_t node, ResourceId object, uint32_t cell);

    void carry(MemoryCell& cell, uint32_t node, const BarrierDecl& barrier);
    void transition(ResourceId object, uint32_t cell, uint32_t node, const BarrierDecl& barrier);
    [[nodiscard]] const char* why_not_moved(ResourceId object, const MemoryCell& cell, uint32_t node,
                                            const BarrierDecl& barrier) const;

    const FramePlan& plan_;
    const Timeline& timeline_;
    uint64_t seed_;
    std::vector<std::vector<MemoryCell>> cells_;        // indexed by object, then cell
    std::vector<std::vector<ResourceId>> neighbours_;   // indexed by object: the objects with overlapping
                                                        // memory
    std::vector<std::vector<ResourceId>> ring_copies_;  // indexed by ring: its resources, ordered by age
    std::vector<std::string> faults_;
};

}  // namespace weft::null
