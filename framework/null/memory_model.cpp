#include "null/memory_model.h"

#include <algorithm>

#include "null/cells.h"
#include "null/pass_values.h"

namespace weft::null {
namespace {

constexpr size_t kMaxFaults = 8;

std::vector<std::vector<ResourceId>> find_neighbours(const FramePlan& plan) {
    std::vector<std::vector<ResourceId>> neighbours(plan.graph.resources.size());
    std::vector<Placement> placed = plan.memory.placements;
    std::sort(placed.begin(), placed.end(), [](const Placement& a, const Placement& b) {
        return a.heap != b.heap ? a.heap < b.heap : a.offset_bytes < b.offset_bytes;
    });
    for (size_t i = 0; i < placed.size(); ++i) {
        const uint64_t end = placed[i].offset_bytes + placed[i].size_bytes;
        for (size_t j = i + 1; j < placed.size(); ++j) {
            if (placed[j].heap != placed[i].heap || placed[j].offset_bytes >= end) break;
            if (placed[j].size_bytes == 0) continue;
            neighbours[placed[i].resource].push_back(placed[j].resource);
            neighbours[placed[j].resource].push_back(placed[i].resource);
        }
    }
    return neighbours;
}

}  // namespace

Memory::Memory(const FramePlan& plan, const Timeline& timeline, uint64_t seed)
    : plan_(plan), timeline_(timeline), seed_(seed), neighbours_(find_neighbours(plan)) {
    const std::vector<ResourceDecl>& resources = plan.graph.resources;
    ring_copies_.resize(resources.size());
    for (ResourceId id(0); id < resources.size(); ++id) {
        cells_.emplace_back(cell_count(resources[id]));
        if (resources[id].ring == kNoId) continue;
        std::vector<ResourceId>& copies = ring_copies_[resources[id].ring];
        copies.resize(size_t{resources[id].history} + 1, kNoId);
        copies[resources[id].age] = id;
    }
}

ResourceId Memory::object_of(ResourceId resource, uint32_t frame) const {
    const ResourceDecl& decl = plan_.graph.resources[resource];
    if (decl.ring == kNoId) return resource;
    const uint32_t copies = decl.history + 1;
    return ring_copies_[decl.ring][(frame % copies + copies - decl.age) % copies];
}

bool Memory::is_before(uint32_t first, uint32_t then) const {
    return first == kNoNode || timeline_.before[then].contains(first);
}

bool Memory::drawn_in_scope_of(const WriteRecord& write, uint32_t node) const {
    const uint32_t scope = timeline_.nodes[node].scope;
    return scope != kNoNode && timeline_.nodes[write.node].scope == scope && is_before(write.node, node);
}

bool Memory::available(const WriteRecord& write, uint32_t node) const {
    if (write.node == kNoNode || drawn_in_scope_of(write, node)) return true;
    return std::any_of(write.available_by.begin(), write.available_by.end(),
                       [&](uint32_t by) { return by == node || is_before(by, node); });
}

bool Memory::visible(const WriteRecord& write, const Accessor& accessor) const {
    if (write.node == kNoNode || drawn_in_scope_of(write, accessor.node)) return true;
    // An accessor without a stage comes after a semaphore wait, which makes every earlier write visible.
    if (accessor.stage == stage::kNone) return true;
    const QueueIndex queue = timeline_.nodes[accessor.node].queue;
    AccessMask seen = access::kNone;
    for (const Visibility& v : write.visible)
        if (v.queue == queue && (v.any_stage || (v.stages & accessor.stage)) &&
            is_before(v.node, accessor.node))
            seen |= v.access;
    const bool available_at_all = available(write, accessor.node);
    return available_at_all && (accessor.access & ~seen) == 0;
}

bool Memory::exclusive(ResourceId object) const {
    const ResourceDecl& decl = plan_.graph.resources[object];
    if (decl.import && decl.import->concurrent) return false;
    return object >= plan_.barriers.concurrent.size() || !plan_.barriers.concurrent[object];
}

uint32_t Memory::family_of(uint32_t node) const {
    const Node& at = timeline_.nodes[node];
    if (at.kind == NodeKind::import_leave && plan_.graph.resources[at.resource].import)
        return plan_.graph.resources[at.resource].import->family;
    return plan_.schedule.queues[at.queue].family;
}

// Returns null if the accessor may use the cell, because it has the right queue family and layout. Otherwise
// returns the reason.
const char* Memory::why_not_usable(ResourceId object, const MemoryCell& cell,
                                   const Accessor& accessor) const {
    if (cell.transfer) return "it is on its way to another queue family";
    if (exclusive(object) && cell.family != kNoId && cell.family != family_of(accessor.node))
        return "another queue family owns it";
    const bool image = plan_.graph.resources[object].kind == ResourceKind::image;
    return image && cell.layout != accessor.layout ? "it is in another layout" : nullptr;
}

const char* Memory::why_not_seen(const MemoryCell& cell, const Accessor& accessor) const {
    if (!is_before(cell.write.node, accessor.node)) return "its last write need not be over";
    return visible(cell.write, accessor) ? nullptr : "its last write is not visible there";
}

// Returns null if the memory of the cell may be overwritten: all accesses to the cell are ordered before the
// node, and the last write to the cell is available. Otherwise returns the reason why not.
const char* Memory::why_not_overwritten(const MemoryCell& cell, uint32_t node) const {
    if (!is_before(cell.write.node, node)) return "a write to the same memory need not be over";
    if (!available(cell.write, node)) return "a write to the same memory is not available";
    for (const uint32_t reader : cell.readers)
        if (reader != node && !is_before(reader, node)) return "somebody may still read the memory";
    return nullptr;
}

// Destroys the content of all other objects that overlap the object in memory. Returns null if the memory of
// all these objects may be overwritten. Otherwise returns the reason why not.
const char* Memory::take_from_neighbours(ResourceId object, uint32_t node) {
    const char* why = nullptr;
    for (const ResourceId other : neighbours_[object]) {
        for (uint32_t c = 0; c < cells_[other].size(); ++c) {
            MemoryCell& cell = cells_[other][c];
            if (why == nullptr) why = why_not_overwritten(cell, node);
            cell.value = ValueHash().add("overwritten").add(seed_).add(uint64_t{node}).value();
            cell.layout = Layout::undefined;
            cell.family = kNoId;
            cell.transfer.reset();
        }
    }
    return why;
}

CellValue Memory::read(ResourceId object, uint32_t index, const Accessor& accessor) {
    MemoryCell& cell = cells_[object][index];
    const char* why = why_not_usable(object, cell, accessor);
    if (why == nullptr) why = why_not_seen(cell, accessor);
    cell.readers.push_back(accessor.node);
    return why == nullptr ? cell.value : poison(why, accessor.node, object, index);
}

CellValue Memory::leave(ResourceId object, uint32_t index, const Accessor& accessor, bool overwrites) {
    const char* why = overwrites ? why_not_overwritten(cells_[object][index], accessor.node) : nullptr;
    const CellValue value = read(object, index, accessor);
    return why == nullptr ? value : poison(why, accessor.node, object, index);
}

void Memory::write(ResourceId object, uint32_t index, const Accessor& accessor, CellValue value) {
    MemoryCell& cell = cells_[object][index];
    const char* why = why_not_usable(object, cell, accessor);
    if (why == nullptr) why = why_not_seen(cell, accessor);
    if (why == nullptr) why = why_not_overwritten(cell, accessor.node);
    const char* taken = take_from_neighbours(object, accessor.node);
    if (why == nullptr) why = taken;
    const Node& node = timeline_.nodes[accessor.node];
    if (why == nullptr && cell.conflict_frame == node.frame) why = "its memory was taken without order";
    if (why != nullptr) cell.conflict_frame = node.frame;
    cell.value = why == nullptr ? value : poison(why, accessor.node, object, index);
    cell.layout = accessor.layout;
    if (exclusive(object)) cell.family = family_of(accessor.node);
    cell.transfer.reset();
    cell.write = {accessor.node, node.queue, accessor.stage, accessor.access & access::kAllWrites, {}, {}};
    cell.readers.clear();
}

void Memory::enter(ResourceId import, bool first) {
    const ResourceDecl& decl = plan_.graph.resources[import];
    const AccessState& entry = decl.import->entry;
    const bool dropped = decl.kind == ResourceKind::image && entry.layout == Layout::undefined;
    for_each_cell(decl, [&](uint32_t index, const SubresourceRange& range) {
        MemoryCell& cell = cells_[import][index];
        if (first) cell.value = import_value(decl, range);
        if (dropped) cell.value = kUndefinedValue;
        cell.layout = entry.layout;
        cell.family = exclusive(import) ? decl.import->family : kNoId;
        cell.transfer.reset();
        cell.write = {};
        cell.readers.clear();
    });
}

void Memory::access_outside(uint32_t node, ResourceId import) {
    const AccessMask written = plan_.graph.resources[import].import->entry.access & access::kAllWrites;
    const Node& at = timeline_.nodes[node];
    for (uint32_t c = 0; c < cells_[import].size(); ++c) {
        MemoryCell& cell = cells_[import][c];
        if (written == access::kNone) {
            cell.readers.push_back(node);
            continue;
        }
        const char* why = why_not_overwritten(cell, node);
        if (why != nullptr) cell.value = poison(why, node, import, c);
        cell.write = {node, at.queue, at.stage, written, {}, {}};
        cell.readers.clear();
    }
}

CellValue Memory::poison(const char* why, uint32_t node, ResourceId object, uint32_t index) {
    if (faults_.size() < kMaxFaults) {
        const Node& at = timeline_.nodes[node];
        std::string who = at.kind == NodeKind::barrier ? "a barrier" : "the owner";
        PassId pass = at.kind == NodeKind::barrier ? at.barrier->to : kNoId;
        if (at.instance != kNoNode) pass = plan_.schedule.order[timeline_.instances[at.instance].position];
        if (pass != kNoId)
            who = (at.kind == NodeKind::barrier ? "the barrier before \"" : "\"") +
                  plan_.graph.passes[pass].name + "\"";
        std::string where;
        for_each_cell(plan_.graph.resources[object], [&](uint32_t cell, const SubresourceRange& range) {
            if (cell == index) where = range_text(plan_.graph.resources[object], range);
        });
        faults_.push_back("frame " + std::to_string(at.frame) + ": " + who + " touches \"" +
                          plan_.graph.resources[object].name + "\"" + where + ", but " + why);
    }
    return ValueHash()
        .add(why)
        .add(seed_)
        .add(uint64_t{node})
        .add(uint64_t{object})
        .add(uint64_t{index})
        .value();
}

}  // namespace weft::null
