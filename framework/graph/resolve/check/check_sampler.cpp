#include "graph/resolve/check/check_sampler.h"

#include <cmath>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/fault_text.h"

namespace weft {

void check_sampler(const DeviceProfile& profile, PassId pass, const PortDesc& desc,
                   const ShaderBinding& binding, const std::string& port_text, PassReporter& report) {
    if (!desc.sampler) return;
    const SamplerDecl& sampler = *desc.sampler;
    const SamplerLocs& locs = desc.sampler_locs;
    const auto error = [&](SourceLoc loc, const char* code, const std::string& message,
                           const std::string& help) {
        add_help(report.error(pass, loc.line != 0 ? loc : desc.loc, code, message), help);
    };
    if (sampler.compare && !binding.shadow)
        error(locs.compare, "W172",
              port_text + " has \"compare\", but the shader does not compare its texels",
              "declare a sampler2DShadow in the shader, or remove \"compare\"");
    if (sampler.reduction != SamplerReduction::average && binding.shadow)
        error(locs.reduction, "W172",
              port_text + " has a \"reduction\", but is a shadow sampler, which compares depths",
              "declare a plain sampler2D in the shader, or remove \"reduction\"");
    if (sampler.anisotropy > profile.max_sampler_anisotropy)
        error(locs.anisotropy, "W187",
              port_text + " has \"anisotropy\": " + number_text(double{sampler.anisotropy}) +
                  ", but the device supports " +
                  (profile.max_sampler_anisotropy > 1
                       ? "at most " + number_text(double{profile.max_sampler_anisotropy})
                       : "no anisotropic filtering (samplerAnisotropy)"),
              profile.max_sampler_anisotropy > 1 ? "use a smaller number" : "remove \"anisotropy\"");
    if (std::abs(sampler.lod_bias) > profile.max_sampler_lod_bias) {
        const std::string most = number_text(double{profile.max_sampler_lod_bias});
        error(locs.lod_bias, "W187",
              port_text + " has \"lodBias\": " + number_text(double{sampler.lod_bias}) +
                  ", but the device supports only -" + most + " to " + most + " (maxSamplerLodBias)",
              "use a number nearer to 0, or select other mips: \"x.mip(1..4)\"");
    }
}

}  // namespace weft
