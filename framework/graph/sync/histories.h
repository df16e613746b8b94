// Purpose: stores the histories of all resources: the barriers of each resource in one frame, its last uses,
// and its layouts at the start of a frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/sync/single_queue_tracker.h"
#include "weft/plan.h"

namespace weft {

// A barrier that follows from the accesses to one resource. barriers() makes a BarrierDecl from it.
struct TrackedBarrier {
    SubresourceRange range;
    AccessState src;
    AccessState dst;
    uint32_t src_family = 0;
    uint32_t dst_family = 0;
    BarrierReason reason = BarrierReason::raw;
    PassId from = kNoId;
    bool from_previous_frame = false;
};

struct PlacedBarrier {
    // Schedule position at which the barrier is recorded; kEpiloguePosition means the end of the frame.
    Position position = 0;
    bool after = false;  // True if the barrier is recorded after the pass at `position`, not before.
    TrackedBarrier barrier;
};

// The history of one resource.
struct ResourceHistory {
    std::vector<PlacedBarrier> barriers;  // The barriers with their positions in the schedule.
    std::vector<LastUse> last_uses;       // The last use on each queue, merged over all subresources.
    // For persistent resources: the layout of each range at the start of a frame. The member `resource`
    // of these entries is not set.
    std::vector<BoundaryState> entry;
};

// The histories of all resources in three arrays. A resource without history has three empty lists.
class HistoryTable {
 public:
    struct Row {
        std::span<const PlacedBarrier> barriers;
        std::span<const LastUse> last_uses;
        std::span<const BoundaryState> entry;
    };

    explicit HistoryTable(size_t resource_count = 0) : places_(resource_count) {}

    // Stores the history of a resource. The old history of the resource, if any, is ignored from then on.
    void set(ResourceId resource, const ResourceHistory& history) {
        Place& place = places_[resource];
        place.barriers = append(barriers_, history.barriers);
        place.last_uses = append(last_uses_, history.last_uses);
        place.entry = append(entries_, history.entry);
    }
    [[nodiscard]] Row operator[](ResourceId resource) const {
        const Place& place = places_[resource];
        return {part(barriers_, place.barriers), part(last_uses_, place.last_uses),
                part(entries_, place.entry)};
    }
    [[nodiscard]] size_t size() const { return places_.size(); }
    // Returns the barriers of all resources, including those of replaced histories.
    [[nodiscard]] std::span<const PlacedBarrier> barriers() const { return barriers_; }
    // Reserves memory for this many barriers.
    void reserve(size_t barrier_count) {
        barriers_.reserve(barrier_count);
        last_uses_.reserve(places_.size());
    }

 private:
    struct Part {
        uint32_t first = 0, count = 0;
    };
    struct Place {
        Part barriers, last_uses, entry;
    };

    template <class T>
    static Part append(std::vector<T>& all, const std::vector<T>& items) {
        const Part part{static_cast<uint32_t>(all.size()), static_cast<uint32_t>(items.size())};
        all.insert(all.end(), items.begin(), items.end());
        return part;
    }
    template <class T>
    static std::span<const T> part(const std::vector<T>& all, Part part) {
        return std::span(all).subspan(part.first, part.count);
    }

    std::vector<Place> places_;  // Index: ResourceId.
    std::vector<PlacedBarrier> barriers_;
    std::vector<LastUse> last_uses_;
    std::vector<BoundaryState> entries_;
};

}  // namespace weft
