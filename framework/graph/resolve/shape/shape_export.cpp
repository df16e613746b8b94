#include "graph/resolve/shape/shape_export.h"

#include "graph/resolve/fault_text.h"

namespace weft {

bool shape_export(const ResourceDesc& desc, const ExportUse& use, ResourceDecl& decl, Reporter& reporter) {
    const char* content = !desc.file.name.empty()  ? "\"file\""
                          : !desc.textures.empty() ? "\"textures\""
                                                   : nullptr;
    if (content != nullptr) {
        add_help(reporter.error(desc.loc, "W243",
                                "the program exports " + quote(desc.name) + ", which has " + content +
                                    ": Weft fills it only once, before the first frame"),
                 "copy it to another resource with a pass of type \"copy\", and export that resource");
        return false;
    }
    const bool kept = decl.lifetime == ResourceLifetime::persistent;
    const bool only_reads = reads(use.access) && !writes(use.access) && use.access != Access::present;
    if (kept && !only_reads) {
        add_help(reporter.error(desc.loc, "W243",
                                "the program exports " + quote(desc.name) +
                                    ", which keeps its content from frame to frame, with an access that does "
                                    "not only read"),
                 "export it with an access that only reads, for example Access::sampled_read; or copy it to "
                 "another resource with a pass of type \"copy\", and export that resource");
        return false;
    }
    decl.usage |= usage_of(use.access);
    if (kept) return true;
    decl.lifetime = ResourceLifetime::imported;
    decl.import = ImportState{{}, {}, 0, true};
    return true;
}

void set_export_states(const GraphRequest& request, std::vector<ResourceDecl>& resources) {
    if (request.exports.empty()) return;
    for (ResourceDecl& decl : resources) {
        const auto found = request.exports.find(decl.name);
        if (found == request.exports.end()) continue;
        const AspectMask aspects = decl.kind == ResourceKind::buffer ? aspect::kNone : decl.aspects;
        const AccessState used = access_state(found->second.access, found->second.stages, aspects);
        if (decl.lifetime == ResourceLifetime::persistent) {
            decl.between = used;
        } else if (decl.import) {
            // After a frame, the program may use the content until the next frame begins. The next frame
            // discards this content.
            decl.import->exit = decl.import->entry = used;
            decl.import->entry.layout = Layout::undefined;
        }
    }
}

}  // namespace weft
