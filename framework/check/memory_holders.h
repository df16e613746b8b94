// Purpose: tracks which resources use each byte of the heaps while the checker simulates a plan. Resources
// that share memory take it over from each other. A resource that takes over memory must wait only for the
// resources that use this memory now, because these have waited for all earlier users of the memory.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "weft/plan.h"

namespace weft::check {

class MemoryHolders {
 public:
    explicit MemoryHolders(const FramePlan& plan);

    // Makes `taker` the only holder of its memory. Returns the other resources that held a part of it. The
    // list is valid until the next call.
    std::span<const ResourceId> take_over(ResourceId taker);
    // Records a use of `resource`. If the resource does not hold all of its memory, it becomes an additional
    // holder of this memory. In a correct plan this happens only while no resource has written to this memory
    // yet.
    void use(ResourceId resource);
    // Returns the other resources for which `taker` must wait before it writes to its memory. These are the
    // other holders of this memory. If there are no other holders, these are the resources from which `taker`
    // took over the memory: `taker` must wait for them again, because it may write one part of its memory
    // later than another part. The list is valid until the next call.
    [[nodiscard]] std::span<const ResourceId> to_wait_for(ResourceId taker);

 private:
    // The first byte of a region: index of its heap, and offset in bytes.
    using Address = std::pair<uint32_t, uint64_t>;

    // A part of a heap that begins at its key in `regions_` and ends before `end_bytes`.
    struct Region {
        uint64_t end_bytes = 0;
        std::vector<ResourceId> holders;
    };
    using Regions = std::map<Address, Region>;

    // Cuts the region that contains `at` in two, so that one region begins at `at`.
    void cut(const Address& at);
    // Cuts the regions at both ends of `placement`.
    void cut(const Placement& placement);
    // Returns the first region that ends after the start of `placement`.
    [[nodiscard]] Regions::const_iterator first_in(const Placement& placement) const;
    // Sets `others_` to the other holders of the memory of `resource`, sorted.
    void find_others(ResourceId resource);
    template <class Visit>
    void for_each_placement(ResourceId resource, Visit visit) const;

    std::vector<Placement> placements_;  // All placements, sorted by resource.
    // The placements of resource r are the elements first_[r] to first_[r + 1] - 1 of `placements_`.
    std::vector<size_t> first_;
    Regions regions_;                 // Regions without a holder are left out.
    std::vector<uint8_t> holds_all_;  // Index: ResourceId. 1 if this resource is a holder of all its memory.
    // Index: ResourceId. The resources from which this resource last took over memory.
    std::vector<std::vector<ResourceId>> taken_from_;
    std::vector<ResourceId> others_;  // The result of the last find_others().
};

}  // namespace weft::check
