// Purpose: tells draw sources which attachments a pass draws to.
#pragma once

#include "weft/declaration.h"
#include "weft/vulkan/draw_source.h"

namespace weft::vk {

[[nodiscard]] DrawTargets draw_targets(const ResolvedGraph& graph, const PassDecl& pass);

}  // namespace weft::vk
