#include "load/area_reads.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "shader/reflect/sampled_images.h"

namespace weft {
namespace {

// Returns true if a member of the pass's `Params` depends on the area of the port (the part of the image that
// the frame uses), or on the scale of any live size.
bool knows_area(const PassDecl& pass, uint32_t use) {
    return std::ranges::any_of(pass.params, [&](const ParamWrite& write) {
        const bool of_port = write.builtin == Builtin::area_size || write.builtin == Builtin::area_uv ||
                             write.builtin == Builtin::area_uv_most;
        return write.builtin == Builtin::live || (of_port && write.use == use);
    });
}

bool samples(const ShaderProgram& program, const std::string& port) {
    return std::ranges::any_of(program.modules, [&](const ShaderModule& module) {
        return shader::sampled_images(module.spirv).contains(port);
    });
}

Diagnostic warning_about(const SourceMap& sources, const PassDecl& pass, const UseDecl& use,
                         const std::string& image) {
    Diagnostic warning =
        sources.error(use.loc, "W237",
                      "pass \"" + pass.name + "\" samples \"" + use.port +
                          "\" as if the whole image had content, but \"" + image + "\" has a live size");
    warning.severity = Severity::warning;
    warning.help = {"add the members vec2 " + use.port + "Uv and vec2 " + use.port +
                        "UvMost to Params, and sample at area_uv(uv, params." + use.port + "Uv, params." +
                        use.port + "UvMost), a function of \"area.glsl\"",
                    "or read texels with texelFetch()"};
    return warning;
}

}  // namespace

void warn_area_reads(const SourceMap& sources, const ResolvedGraph& graph, const ShaderCatalog& shaders,
                     Diagnostics& warnings) {
    if (graph.live_values.empty()) return;
    std::set<std::tuple<uint32_t, uint32_t, uint32_t>> known;
    for (const PassDecl& pass : graph.passes) {
        const auto program = shaders.find(pass.shader);
        if (program == shaders.end()) continue;
        for (uint32_t i = 0; i < pass.uses.size(); ++i) {
            const UseDecl& use = pass.uses[i];
            const ResourceDecl& image = graph.resources[use.resource];
            if (image.area == kNoId || use.is_output || knows_area(pass, i)) continue;
            if (!samples(program->second, use.port)) continue;
            // All passes of a repeat come from one place in the file, so the warning is given once for this
            // place.
            if (known.emplace(use.loc.file, use.loc.line, use.loc.column).second)
                warnings.push_back(warning_about(sources, pass, use, image.name));
        }
    }
}

}  // namespace weft
