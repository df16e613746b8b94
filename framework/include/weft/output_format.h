// Purpose: the format of the image to which a graph writes its picture, and its state after each frame.
#pragma once

#include "weft/access.h"
#include "weft/format.h"
#include "weft/resource_usage.h"

namespace weft {

// The format decides who encodes the colours. With a UNORM format, the last pass writes encoded values. With
// an sRGB format, the device encodes what the pass writes; rgba16f is not encoded. So for these formats the
// last pass must write linear values. Expressions of a graph find out with the number `outputIsLinear`: 1 if
// the last pass must write linear values, else 0.
struct OutputFormat {
    Format format = Format::rgba8;
    // transfer_src: the program may copy or blit the image. shader_read_only: its fragment and compute
    // shaders may sample it. color_attachment: it may draw to it. present: it may present it, after a
    // semaphore that the frame signals (vk::FrameSubmit::signals). The next frame waits for these uses, and
    // discards the content. For another use, record a barrier before it, and a barrier back after it.
    Layout final_layout = Layout::transfer_src;
    // The usage flags with which the image was created; 0: all that the device supports for the format. For
    // an image of a swapchain, these are the flags of the swapchain.
    UsageMask usage = 0;
    bool operator==(const OutputFormat&) const = default;
};

// Returns true if the last pass must write linear values.
[[nodiscard]] inline bool is_linear(const OutputFormat& output) {
    return format_info(output.format).srgb || output.format == Format::rgba16f;
}

}  // namespace weft
