// Purpose: records a pass in C++: gathers the Vulkan objects of its ports, and calls its function `record`.
#pragma once

#include "vulkan/record/record.h"

namespace weft::vk {

// Creates the views of the ports of a C++ pass for frame `frame` of its period. Index: use; null for buffers
// and for images that are only copied. Error: V411.
[[nodiscard]] Result<std::vector<VkImageView>> make_port_views(const PassDecl& pass, ViewCache& views,
                                                               uint64_t frame);

// Returns the reason why a C++ pass cannot have this port. The text is empty if the pass can have the port.
[[nodiscard]] std::string port_fault(const FramePlan& plan, const UseDecl& use);

void record_custom(const RecordContext& context, Position position, const PassDecl& pass,
                   const PreparedPass& prepared);

}  // namespace weft::vk
