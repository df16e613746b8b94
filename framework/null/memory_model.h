// Purpose: simulates the memory of a plan during execution: the content of every cell, the node that wrote
// it, and the accesses to which it is visible. A node is a barrier, a semaphore operation or a part of a pass
// (see NodeKind). A persistent resource can have several copies (a ring); age k is the content of k frames
// ago. Each copy is a separate memory object. If the resource of age 0 first uses a copy in frame k, the
// number of this object is the ResourceId of the resource of age k. Resources whose placements overlap
// destroy each other's content. If an access is not ordered after an earlier conflicting access, or does not
// see its result, the value becomes poison (a unique wrong value). Source: Vulkan 1.3 specification, appendix
// "Memory Model" (availability, visibility, data races).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "null/null_executor.h"
#include "null/timeline.h"

namespace weft::null {

struct Visibility {
    uint32_t node = kNoNode;  // The write is visible after this node has completed.
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    bool any_stage = false;  // True for a semaphore wait: all stages of the queue see the write.
    QueueIndex queue = kGraphicsQueue;
};

// The last write of a cell, and the accesses to which it is visible.
struct WriteRecord {
    uint32_t node = kNoNode;  // The writing node. kNoNode: a write before all nodes, visible to all.
    QueueIndex queue = kGraphicsQueue;
    StageMask stage = stage::kNone;
    AccessMask access = access::kNone;
    std::vector<uint32_t> available_by;  // The nodes that made the write available.
    std::vector<Visibility> visible;
};

// State of a cell between its release by one queue family and its acquire by another.
struct Transfer {
    uint32_t node = kNoNode;
    uint32_t src_family = 0, dst_family = 0;
    Layout src_layout = Layout::undefined, dst_layout = Layout::undefined;
};

struct MemoryCell {
    CellValue value = kUndefinedValue;
    Layout layout = Layout::undefined;
    uint32_t family = kNoId;  // Queue family that owns the cell; kNoId: the next user becomes the owner.
    std::optional<Transfer> transfer;
    WriteRecord write;
    std::vector<uint32_t> readers;  // Nodes that read the cell since the last write.
    // Frame in which the cell had an unordered conflict, or kNoId. In some execution orders the conflict has
    // no effect. To show the error in every order, all writes to this cell in the rest of that frame become
    // poison.
    uint32_t conflict_frame = kNoId;
};

// Describes an access: the node that accesses a cell, with the stage, access type and layout.
struct Accessor {
    uint32_t node = kNoNode;
    // The stage of the access. kNone means that the access follows a semaphore wait, so that every earlier
    // write is visible to it.
    StageMask stage = stage::kNone;
    AccessMask access = access::kNone;
    Layout layout = Layout::undefined;  // Layout that the image must have for the access.
};

class Memory {
 public:
    Memory(const FramePlan& plan, const Timeline& timeline, uint64_t seed);

    // Returns the memory object that the resource uses in a frame.
    [[nodiscard]] ResourceId object_of(ResourceId resource, uint32_t frame) const;
    [[nodiscard]] CellValue peek(ResourceId object, uint32_t cell) const {
        return cells_[object][cell].value;
    }

    // Returns the value that the accessor sees. An invalid access gives poison and a fault message, but the
    // cell keeps its value.
    [[nodiscard]] CellValue read(ResourceId object, uint32_t cell, const Accessor& accessor);
    // Reads an import, or a persistent resource, after the frame. `overwrites` is true if the owner may write
    // the import next. Then all reads of the import must be ordered before this access, too.
    [[nodiscard]] CellValue leave(ResourceId object, uint32_t cell, const Accessor& accessor,
                                  bool overwrites);
    void write(ResourceId object, uint32_t cell, const Accessor& accessor, CellValue value);
    void barrier(uint32_t node);
    void signal(uint32_t node);
    void wait(uint32_t node);
    // Puts an import into its entry state. `first` is true in the first frame, where the import gets the
    // content of its owner.
    void enter(ResourceId import, bool first);
    // Simulates an access to the import by its owner before the frame: a pending write, or a read.
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
    // The state of each cell, indexed by memory object, then by cell.
    std::vector<std::vector<MemoryCell>> cells_;
    // Index: memory object. Value: the other objects that overlap this object in memory.
    std::vector<std::vector<ResourceId>> neighbours_;
    // The copies of each persistent resource. Index: the ResourceId of the resource of age 0, then the age.
    // Value: the ResourceId of the copy of this age.
    std::vector<std::vector<ResourceId>> ring_copies_;
    std::vector<std::string> faults_;
};

}  // namespace weft::null
