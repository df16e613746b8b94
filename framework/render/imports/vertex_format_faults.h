// Purpose: checks the vertex formats of the program's draw lists. Units: bytes.
#pragma once

#include <string>

#include "weft/imports.h"
#include "weft/result.h"
#include "weft/vulkan/device.h"

namespace weft::render {

// Returns an error W255 for each attribute of the draw list `list` that has no stream, does not fit into its
// stride, or has a format that the device cannot read from vertex buffers.
[[nodiscard]] Diagnostics vertex_format_faults(const vk::Device& device, const std::string& list,
                                               const VertexFormat& format);

}  // namespace weft::render
