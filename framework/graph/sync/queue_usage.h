// Purpose: finds out which queues and queue families use a resource. This determines the sharing mode of the
// resource, and whether barriers transfer its ownership between queue families.
#pragma once

#include <span>

#include "graph/sync/accesses.h"
#include "weft/plan.h"

namespace weft {

// Describes the use of a resource by queues and queue families.
struct QueueUsage {
    bool several_queues = false;
    bool several_families = false;
    // True for a transient image that several queue families use, but only one family at a time. Between
    // these uses, barriers transfer the ownership of the image.
    bool exclusive = false;

    // True if several families use the resource without ownership transfers.
    [[nodiscard]] bool concurrent() const { return several_families && !exclusive; }
};

// Each element of `cells` has the accesses to one part of the resource, sorted by schedule position.
[[nodiscard]] QueueUsage queue_usage(const ResourceDecl& decl, const Schedule& order,
                                     std::span<const std::span<const AccessEvent>> cells);

}  // namespace weft
