// Purpose: the format of the image to which a graph writes its picture, and its state after each frame.
#pragma once

#include "weft/access.h"
#include "weft/format.h"
#include "weft/resource_usage.h"

namespace weft {

// The format decides whether the last pass or the device encodes the colours. With a UNORM format, the last
// pass writes encoded values. With an sRGB format, the last pass must write linear values, and the device
// encodes them. With rgba16f, the last pass must write linear values, too; the program or the display encodes
// them. Expressions of a graph can read the number `outputIsLinear`: 1 if the last pass must write linear
// values, else 0.
struct OutputFormat {
    Format format = Format::rgba8;
    // transfer_src: the program may copy or blit the image. shader_read_only: fragment and compute shaders of
    // the program may sample the image. color_attachment: the program may draw to the image. present: the
    // program may present the image, after a semaphore that the frame signals (vk::FrameSubmit::signals). The
    // next frame waits for these uses, and discards the content. For another use, record a barrier before the
    // use, and a barrier back to this layout after the use.
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
