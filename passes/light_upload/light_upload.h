// The pass type light_upload copies the list of lights from the program to a buffer of Light, which is bound
// to the output port `lights`. The list is first written to the upload memory of the frame. Lights that do
// not fit into the buffer are left out. Error W160: the elements of the buffer are not of type Light.
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
