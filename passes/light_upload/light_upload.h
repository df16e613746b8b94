// Output port `lights`: a buffer of Light. Copies the program's light list, as far as the buffer has room, to
// the frame's upload memory and from there to the buffer. Errors: W160 when the buffer's element is not
// Light.
#pragma once

#include <array>

#include "weft/pass.h"

namespace weft::passes {

struct LightUpload {
    static constexpr std::string_view kType = "light_upload";
    static constexpr Out kLights{"lights", Access::copy_write};
    static constexpr std::array<PortDecl, 1> kPorts{kLights};
    static constexpr std::array<ParamDecl, 0> kParams{};

    static Status check(const PassDecl& pass, const ResolvedGraph& graph);
    static void prepare(const PassContext& context, const HostInputs& host, Uploads& uploads);
    static void record(const PassContext& context, Recorder& recorder);
};

}  // namespace weft::passes
