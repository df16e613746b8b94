#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/checks.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

// Reports the passes that write a resource with a file. Nothing would store the new content.
void check_writers(const Declared& declared, const FormattedGraph& graph, Reporter& reporter) {
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        for (const UseDecl& use : graph.passes[pass].uses) {
            const ResourceDecl& resource = graph.resources[use.resource];
            if (resource.file.empty() || !writes(use.access)) continue;
            Diagnostic& d =
                reporter.error(use.loc, "W146",
                               "pass " + quote(declared.pass_name(pass)) + " writes " + quote(resource.name) +
                                   ", whose content comes from the file " + quote(resource.file));
            add_help(d, "write another resource: content from a file can only be read");
        }
    }
}

void check_format(const ResourceDesc& desc, const ResourceDecl& decl, Reporter& reporter) {
    const FormatInfo& format = format_info(decl.format);
    if (format.depth || format.stencil) {
        add_help(reporter.error(desc.loc, "W146",
                                quote(desc.name) + " has the depth format " + quote(format.name) +
                                    ", which a file cannot fill"),
                 "use a colour format, for example \"r32f\"");
        return;
    }
    if (!desc.textures.empty()) return;
    const uint64_t wanted = content_bytes(decl);
    if (desc.file.width_px > 0 || desc.file.size_bytes == wanted) return;
    add_help(reporter.error(desc.file.loc, "W146",
                            "the file " + quote(desc.file.name) + " has " + bytes_text(desc.file.size_bytes) +
                                " of texels, but " + quote(desc.name) + " needs " + bytes_text(wanted)),
             "correct \"size\", \"format\", \"mips\" and \"layers\": the file contains all layers of each "
             "mip, without gaps, beginning with mip 0");
}

}  // namespace

void check_files(const Declared& declared, const FormattedGraph& graph, Reporter& reporter) {
    check_writers(declared, graph, reporter);
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDesc* desc = declared.shapes.origins[id].desc;
        if (!desc || desc->is_buffer || graph.suspects.shapes[id]) continue;
        if (desc->file.name.empty() && desc->textures.empty()) continue;
        check_format(*desc, graph.resources[id], reporter);
    }
}

}  // namespace weft
