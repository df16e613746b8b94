// Purpose: the memory of a plan while it is executed: what is in every cell, who put it there, and to whom
// that has been made visible. Every copy of a persistent resource is a memory object of its own, named by the
// role that had it in frame 0; resources whose placements overlap destroy each other's content. An access
// that is not ordered after, or does not see, what happened before it leaves poison. Source: Vulkan 1.3
// specification, appendix "Memory Model" (availability, visibility, data races).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "null/null_executor.h"
#include "null/timeline.h"

namespace weft::null {

struct Visibility {
    uint32_t node = kNoNode;  // once this is done
    StageMask stages = stage::kNone;
    AccessMask access = access::kNone;
    bool any_stage = false;  // a semaphore, to all stages of this queue
    QueueIndex queue = 0;
};

// The last write of a cell and how far it has got.
struct WriteRecord {
    uint32_t node = kNoNode;  // kNoNode: before everything, seen by everybody
    QueueIndex queue = 0;
    StageMask stage = stage::kNone;
    AccessMask access = access::kNone;
    std::vector<uint32_t> available_by;
    std::vector<Visibility> visible;
};

// Between the release by one queue family and the acquisition by another.
struct Transfer {
    uint32_t node = kNoNode;
    uint32_t src_family = 0, dst_family = 0;
    Layout src_layout = Layout::undefined, dst_layout = Layout::undefined;
};

struct MemoryCell {
    CellValue value = kUndefinedValue;
    Layout layout = Layout::undefined;
    uint32_t family = kNoId;  // who owns it; kNoId: whoever comes first
    std::optional<Transfer> transfer;
    WriteRecord write;
    std::vector<uint32_t> readers;  // since that write
    // A conflict without order may fall out well, now or for whoever lost it: so that it shows in any order,
    // all that is written here stays poison for the rest of that frame.
    uint32_t conflict_frame = kNoId;
};

// Who touches a cell, and how.
struct Accessor {
    uint32_t node = kNoNode;
    StageMask stage = stage::kNone;  // one bit; none: sees whatever is available
    AccessMask access = access::kNone;
    Layout layout = Layout::undefined;  // that it needs
};

class Memory {
 public:
    Memory(const FramePlan& plan, const Timeline& timeline, uint64_t seed);

    // The memory object behind a resource in a frame.
    [[nodiscard]] ResourceId object_of(ResourceId resource, uint32_t frame) const;
    [[nodiscard]] CellValue peek(ResourceId object, uint32_t cell) const {
        return cells_[object][cell].value;
    }

    // What the accessor sees. Poison is reported, but stays with the reader.
    [[nodiscard]] CellValue read(ResourceId object, uint32_t cell, const Accessor& accessor);
    // `overwrites`: the accessor waits for readers too, though it changes nothing.
    [[nodiscard]] CellValue leave(ResourceId object, uint32_t cell, const Accessor& accessor,
                                  bool overwrites);
    void write(ResourceId object, uint32_t cell, const Accessor& accessor, CellValue value);
    void barrier(uint32_t node);
    void signal(uint32_t node);
    void wait(uint32_t node);
    // The owner of an import has it in its entry state; what was there before the first frame is its own.
    void enter(ResourceId import, bool first);
    // The owner's own access before the frame: a write that is still pending, or a read.
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
    std::vector<std::vector<MemoryCell>> cells_;        // by object, then cell
    std::vector<std::vector<ResourceId>> neighbours_;   // by object: whose bytes overlap
    std::vector<std::vector<ResourceId>> ring_copies_;  // by ring: its roles by age
    std::vector<std::string> faults_;
};

}  // namespace weft::null
