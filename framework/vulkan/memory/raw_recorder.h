// Purpose: the Recorder of the Vulkan executor. It also has the Vulkan objects for passes that record Vulkan
// commands of their own; raw_commands() returns them.
#pragma once

#include "weft/vulkan/raw_pass.h"

namespace weft::vk {

class RawRecorder : public Recorder {
 public:
    [[nodiscard]] virtual const RawCommands& raw() const = 0;
};

}  // namespace weft::vk
