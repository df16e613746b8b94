#include "graph/sync/queue_clocks.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "graph/model/rows.h"

namespace weft {
namespace {

// Computes the vector clock of each point in time. A point is a schedule position in a certain frame; the
// points of the second frame follow those of the first.
class ClockWalk {
 public:
    ClockWalk(size_t point_count, size_t queue_count) : last_(queue_count, kNoId) {
        clocks_.queue_count = static_cast<uint32_t>(queue_count);
        clocks_.values.assign(point_count * queue_count, 0);
    }

    // Starts the clock of a point: a copy of the clock of the previous point on the same queue, to which that
    // previous point is added.
    void enter(uint32_t point, QueueIndex queue) {
        if (last_[queue] != kNoId) {
            std::ranges::copy(at(last_[queue]), at(point).begin());
            at(point)[queue] = last_[queue] + 1;
        }
        last_[queue] = point;
    }
    // Returns true if `other`, a point on `queue`, is known to be complete before `point`.
    [[nodiscard]] bool knows(uint32_t point, uint32_t other, QueueIndex queue) const {
        return clocks_[Position(point)][queue] > other;
    }
    // Makes `point` wait for `other`, a point on `queue`, and for everything before `other`.
    void follow(uint32_t point, uint32_t other, QueueIndex queue) {
        const std::span<uint32_t> clock = at(point);
        for (size_t q = 0; q < clock.size(); ++q) clock[q] = std::max(clock[q], at(other)[q]);
        clock[queue] = std::max(clock[queue], other + 1);
    }
    [[nodiscard]] ClockTable take() { return std::move(clocks_); }

 private:
    [[nodiscard]] std::span<uint32_t> at(uint32_t point) { return clocks_[Position(point)]; }

    ClockTable clocks_;           // Index: point instead of position.
    std::vector<uint32_t> last_;  // Index: queue. The last point on the queue so far, or kNoId.
};

// Finds the necessary semaphore waits by going through two frames. Only the waits of the second frame are
// kept: all later frames need the same waits, because they also have a previous frame.
class WaitFinder {
 public:
    WaitFinder(const std::vector<QueueIndex>& queue, size_t queue_count,
               const std::vector<QueueDependency>& dependencies)
        : queue_(queue),
          stride_(static_cast<uint32_t>(queue.size())),
          into_(make_rows<QueueDependency>(queue.size(),
                                           [&](const auto& add) {
                                               for (const QueueDependency& d : dependencies) add(d.to, d);
                                           })),
          walk_(2 * queue.size(), queue_count) {}

    std::vector<Wait> find() {
        for (uint32_t frame = 0; frame < 2; ++frame)
            for (Position position(0); position < stride_; ++position) visit(frame, position);
        return std::move(waits_);
    }

 private:
    [[nodiscard]] uint32_t point_of(const QueueDependency& d, uint32_t frame) const {
        return (d.previous_frame ? frame - 1 : frame) * stride_ + d.from;
    }

    void visit(uint32_t frame, Position position) {
        const uint32_t point = frame * stride_ + position;
        walk_.enter(point, queue_[position]);
        std::vector<QueueDependency> wanted;
        for (const QueueDependency& d : into_[position])
            if ((frame > 0 || !d.previous_frame) && !walk_.knows(point, point_of(d, frame), queue_[d.from]))
                wanted.push_back(d);
        const auto implied = [&](const QueueDependency& d) {
            return std::any_of(wanted.begin(), wanted.end(), [&](const QueueDependency& by) {
                const uint32_t a = point_of(by, frame), b = point_of(d, frame);
                if (queue_[by.from] == queue_[d.from]) return a > b;
                return walk_.knows(a, b, queue_[d.from]);
            });
        };
        std::vector<QueueDependency> kept;
        std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(kept),
                     [&](const QueueDependency& d) { return !implied(d); });
        for (const QueueDependency& d : kept) {
            // Several resources may need the same wait. The wait of the first resource covers the others.
            if (walk_.knows(point, point_of(d, frame), queue_[d.from])) continue;
            walk_.follow(point, point_of(d, frame), queue_[d.from]);
            if (frame == 1) waits_.push_back({position, d});
        }
    }

    const std::vector<QueueIndex>& queue_;
    uint32_t stride_;             // Number of points in one frame.
    Rows<QueueDependency> into_;  // Index: position. The dependencies for which the position waits.
    ClockWalk walk_;
    std::vector<Wait> waits_;
};

}  // namespace

ClockTable frame_clocks(const std::vector<QueueIndex>& queue, size_t queue_count,
                        const std::vector<QueueDependency>& dependencies) {
    const Rows<uint32_t> followed = make_rows<uint32_t>(queue.size(), [&](const auto& add) {
        for (const QueueDependency& d : dependencies)
            if (!d.previous_frame && d.to < queue.size()) add(d.to, d.from);
    });
    ClockWalk walk(queue.size(), queue_count);
    for (Position position(0); position < queue.size(); ++position) {
        walk.enter(position, queue[position]);
        for (const uint32_t from : followed[position]) walk.follow(position, from, queue[from]);
    }
    return walk.take();
}

std::vector<Wait> minimal_waits(const std::vector<QueueIndex>& queue, size_t queue_count,
                                const std::vector<QueueDependency>& dependencies) {
    if (dependencies.empty()) return {};
    return WaitFinder(queue, queue_count, dependencies).find();
}

}  // namespace weft
