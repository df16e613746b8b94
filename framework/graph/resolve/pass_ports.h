// Purpose: small functions about passes and ports that several stages of resolve() need.
#pragma once

#include <string>
#include <vector>

#include "weft/graph_desc.h"

namespace weft {

// Returns all ports that a pass writes: outputs, the depth attachment and resolve targets.
[[nodiscard]] std::vector<const PortDesc*> written_ports(const PassDesc& desc);
// Returns true if the port refers to the resource in the current frame, not to its history.
[[nodiscard]] bool names_this_frames(const PortDesc& port, const std::string& resource);
// Returns the port through which a pass writes a resource, or null if the pass does not write it.
[[nodiscard]] const PortDesc* output_of(const PassDesc& desc, const std::string& resource);
// Returns the blend state of an output. If PassDesc::blend has no entry for the output, the entry with the
// empty name applies. Without that entry too, blending is disabled.
[[nodiscard]] BlendState blend_of(const PassDesc& desc, const std::string& port);
[[nodiscard]] bool has_shader(PassKind kind);
// Returns the extent of the first mip in the range of the use.
[[nodiscard]] Extent3D use_extent(const std::vector<ResourceDecl>& resources, const UseDecl& use);

}  // namespace weft
