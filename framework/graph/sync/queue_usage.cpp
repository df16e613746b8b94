#include "graph/sync/queue_usage.h"

namespace weft {
namespace {

// Remembers whether different values were added.
class Values {
 public:
    void add(uint32_t value) {
        several_ = several_ || (first_ != kNoId && first_ != value);
        first_ = value;
    }
    [[nodiscard]] bool any() const { return first_ != kNoId; }
    [[nodiscard]] bool several() const { return several_; }

 private:
    uint32_t first_ = kNoId;
    bool several_ = false;
};

// Returns false if consecutive reads in the same layout run on different queue families. Such reads may run
// at the same time, so neither family can own the resource.
bool one_family_at_a_time(std::span<const AccessEvent> events, const std::vector<LogicalQueue>& queues) {
    for (size_t i = 1; i < events.size(); ++i) {
        const AccessEvent &a = events[i - 1], &b = events[i];
        const bool together = !a.writes && !b.writes && a.state.layout == b.state.layout;
        if (together && queues[a.queue].family != queues[b.queue].family) return false;
    }
    return true;
}

}  // namespace

QueueUsage queue_usage(const ResourceDecl& decl, const Schedule& order,
                       std::span<const std::span<const AccessEvent>> cells) {
    Values queues, families;
    bool in_turn = true;
    for (const std::span<const AccessEvent> events : cells) {
        for (const AccessEvent& event : events) {
            queues.add(event.queue);
            families.add(order.queues[event.queue].family);
        }
        in_turn = in_turn && one_family_at_a_time(events, order.queues);
    }
    // An import enters and leaves every frame on queue 0. The prologue, which initialises persistent
    // resources, also runs on queue 0.
    if (decl.lifetime == ResourceLifetime::persistent && queues.any())
        families.add(order.queues.front().family);
    if (decl.import && queues.any()) queues.add(kGraphicsQueue);
    if (decl.import) families.add(decl.import->family);
    QueueUsage usage;
    usage.several_queues = queues.several();
    usage.several_families = families.several();
    usage.exclusive = usage.several_families && in_turn && decl.kind == ResourceKind::image &&
                      decl.lifetime == ResourceLifetime::transient;
    return usage;
}

}  // namespace weft
