// Simulates the effects of barriers and semaphores on memory: availability, visibility, layouts, ownership.
#include "null/cells.h"
#include "null/memory_model.h"
#include "null/pass_values.h"

namespace weft::null {
namespace {

bool moves_family(const BarrierDecl& barrier) {
    return barrier.src_family != barrier.dst_family;
}

}  // namespace

// Applies a barrier to the last write of a cell, if the barrier is ordered after this write. The barrier
// makes the write available if the barrier and the write are on the same queue and the barrier's source
// includes the write's stage and access. If this barrier, an earlier barrier or a semaphore signal has made
// the write available, the write becomes visible to this barrier's destination.
void Memory::carry(MemoryCell& cell, uint32_t node, const BarrierDecl& barrier) {
    WriteRecord& write = cell.write;
    if (write.node == kNoNode || !is_before(write.node, node)) return;
    const QueueIndex queue = timeline_.nodes[node].queue;
    const bool flushes = write.queue == queue && (write.stage & barrier.src.stages) &&
                         (write.access & ~barrier.src.access) == 0;
    if (flushes) write.available_by.push_back(node);
    if (available(write, node))
        write.visible.push_back({node, barrier.dst.stages, barrier.dst.access, false, queue});
}

void Memory::barrier(uint32_t node) {
    const BarrierDecl& barrier = *timeline_.nodes[node].barrier;
    const uint32_t frame = timeline_.nodes[node].frame;
    const ResourceId object = object_of(barrier.resource, frame);
    const ResourceDecl& decl = plan_.graph.resources[object];
    for_each_cell(decl, barrier.range, [&](uint32_t cell, const SubresourceRange&) {
        carry(cells_[object][cell], node, barrier);
    });
    for (const ResourceId from : barrier.aliased_from) {
        const ResourceId owner = object_of(from, frame);
        for (uint32_t c = 0; c < cells_[owner].size(); ++c) {
            // True for cells in the barrier's own range, which the loop above has already processed.
            bool own = false;
            if (owner == object)
                for_each_cell(decl, barrier.range,
                              [&](uint32_t cell, const SubresourceRange&) { own = own || cell == c; });
            if (!own) carry(cells_[owner][c], node, barrier);
        }
    }
    const bool image = decl.kind == ResourceKind::image;
    const bool moves = moves_family(barrier) && exclusive(object);
    if (!moves && !(image && barrier.src.layout != barrier.dst.layout)) return;
    for_each_cell(decl, barrier.range,
                  [&](uint32_t cell, const SubresourceRange&) { transition(object, cell, node, barrier); });
}

const char* Memory::why_not_moved(ResourceId object, const MemoryCell& cell, uint32_t node,
                                  const BarrierDecl& barrier) const {
    const uint32_t family = family_of(node);
    const bool moves = moves_family(barrier) && exclusive(object);
    if (moves && family != barrier.src_family) {
        if (!cell.transfer) return "no queue family has released it";
        const Transfer& t = *cell.transfer;
        const bool pair = t.src_family == barrier.src_family && t.dst_family == barrier.dst_family &&
                          t.src_layout == barrier.src.layout && t.dst_layout == barrier.dst.layout &&
                          family == barrier.dst_family;
        if (!pair) return "its release and its acquisition do not match";
        return is_before(t.node, node) ? nullptr : "its release need not be over";
    }
    const char* why = why_not_overwritten(cell, node);
    if (why != nullptr || barrier.src.layout == Layout::undefined) return why;
    if (cell.transfer) return "it is on its way to another queue family";
    if (exclusive(object) && cell.family != kNoId && cell.family != family)
        return "another queue family owns it";
    return cell.layout == barrier.src.layout ? nullptr : "it is not in the layout that the barrier changes";
}

// Simulates a layout transition or ownership transfer. It acts like a write to the cell, after the barrier's
// source scope and before its destination scope. After a release, the write is not visible to any access.
void Memory::transition(ResourceId object, uint32_t index, uint32_t node, const BarrierDecl& barrier) {
    MemoryCell& cell = cells_[object][index];
    const QueueIndex queue = timeline_.nodes[node].queue;
    const bool moves = moves_family(barrier) && exclusive(object);
    const bool releases = moves && family_of(node) == barrier.src_family;
    const char* why = why_not_moved(object, cell, node, barrier);
    const char* taken = take_from_neighbours(object, node);
    if (why == nullptr) why = taken;
    if (why != nullptr) {
        cell.value = poison(why, node, object, index);
        cell.conflict_frame = timeline_.nodes[node].frame;
    } else if (barrier.src.layout == Layout::undefined) {
        cell.value = ValueHash().add("dropped").add(seed_).add(uint64_t{node}).add(uint64_t{index}).value();
    }
    cell.layout = barrier.dst.layout;
    if (exclusive(object)) cell.family = family_of(node);
    cell.transfer.reset();
    if (releases)
        cell.transfer =
            Transfer{node, barrier.src_family, barrier.dst_family, barrier.src.layout, barrier.dst.layout};
    cell.write = {node, queue, stage::kNone, access::kNone, {node}, {}};
    if (!releases) cell.write.visible.push_back({node, barrier.dst.stages, barrier.dst.access, false, queue});
    cell.readers.clear();
}

// Simulates a semaphore signal: all writes that are ordered before it become available.
void Memory::signal(uint32_t node) {
    for (std::vector<MemoryCell>& object : cells_)
        for (MemoryCell& cell : object)
            if (cell.write.node != kNoNode && is_before(cell.write.node, node))
                cell.write.available_by.push_back(node);
}

void Memory::wait(uint32_t node) {
    const QueueIndex queue = timeline_.nodes[node].queue;
    for (std::vector<MemoryCell>& object : cells_)
        for (MemoryCell& cell : object)
            if (cell.write.node != kNoNode && is_before(cell.write.node, node) && available(cell.write, node))
                cell.write.visible.push_back({node, stage::kAll, access::kAll, true, queue});
}

}  // namespace weft::null
