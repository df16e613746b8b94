#include "light_upload/light_upload.h"

#include <algorithm>

#include "shared/light.glsl"
#include "weft/light_list.h"

namespace weft::passes {

Status LightUpload::check(const PassDecl& pass, const ResolvedGraph& graph) {
    for (const UseDecl& use : pass.uses) {
        const ResourceDecl& buffer = graph.resources[use.resource];
        if (buffer.kind == ResourceKind::buffer && buffer.stride_bytes == sizeof(shared::Light)) continue;
        Diagnostic fault = graph.sources.error(
            use.loc, "W160",
            "pass \"" + pass.name + "\" writes the lights of the scene to \"" + buffer.name +
                "\", but this resource is not a buffer with elements of type Light");
        fault.help = {"declare the resource \"" + buffer.name +
                      "\" as { \"buffer\": \"Light\", \"count\": … }"};
        return fault;
    }
    return Unit{};
}

void LightUpload::prepare(const PassContext&, const HostInputs& host, Uploads& uploads) {
    const LightList* list = host.get<LightList>("lights");
    if (!list || list->bytes.empty()) return;
    const size_t room = uploads.capacity(kLights.name) / sizeof(shared::Light);
    uploads.put(kLights.name, list->bytes.first(std::min(room * sizeof(shared::Light), list->bytes.size())));
}

void LightUpload::record(const PassContext&, Recorder& recorder) {
    recorder.copy_upload(kLights.name);
}

}  // namespace weft::passes
