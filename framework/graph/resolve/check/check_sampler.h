// Purpose: checks the sampler of one port against the shader and the device.
#pragma once

#include <string>

#include "graph/resolve/declared.h"
#include "graph/resolve/pass_reporter.h"

namespace weft {

// `desc` is the port as the author wrote it, and `port_text` names the port in messages. Errors: W172, W187.
void check_sampler(const DeviceProfile& profile, PassId pass, const PortDesc& desc,
                   const ShaderBinding& binding, const std::string& port_text, PassReporter& report);

}  // namespace weft
