// Purpose: what each access to a resource means for Vulkan.
#pragma once

#include "weft/access.h"
#include "weft/resource_usage.h"

namespace weft {

struct AccessRow {
    Access access = Access::none;
    // The pipeline stages of the access; kNone if they are the shader stages that use the resource.
    StageMask stages = stage::kNone;
    AccessMask mask = access::kNone;
    // The layout of an image during the access.
    Layout layout = Layout::undefined;
    // The usage flag that the resource needs.
    UsageMask usage = 0;
};

[[nodiscard]] const AccessRow& access_row(Access a);

}  // namespace weft
