// Purpose: queries about passes and ports that several stages need.
#pragma once

#include <string>
#include <vector>

#include "weft/graph_desc.h"

namespace weft {

// Outputs, depth attachment and resolve targets.
[[nodiscard]] std::vector<const PortDesc*> written_ports(const PassDesc& desc);
// True if the port refers to the resource's content of this frame.
[[nodiscard]] bool names_this_frames(const PortDesc& port, const std::string& resource);
// The port by which a pass writes a resource; null: none.
[[nodiscard]] const PortDesc* output_of(const PassDesc& desc, const std::string& resource);
// The state with the name "" applies to every output without its own state.
[[nodiscard]] BlendState blend_of(const PassDesc& desc, const std::string& port);
[[nodiscard]] bool has_shader(PassKind kind);
// The extent of the first mip of the use's range.
[[nodiscard]] Extent3D use_extent(const std::vector<ResourceDecl>& resources, const UseDecl& use);

}  // namespace weft
