#include "graph/resolve/shape/shape_export.h"

#include "graph/resolve/fault_text.h"

namespace weft {

bool shape_export(const ResourceDesc& desc, const ExportUse& use, ResourceDecl& decl, Reporter& reporter) {
    const char* kept = decl.history > 0                                ? "\"history\""
                       : !desc.file.name.empty()                       ? "\"file\""
                       : !desc.textures.empty()                        ? "\"textures\""
                       : decl.lifetime == ResourceLifetime::persistent ? "\"keep\", or its group keeps it"
                                                                       : nullptr;
    if (kept == nullptr) {
        decl.lifetime = ResourceLifetime::imported;
        decl.import = ImportState{{}, {}, 0, true};
        decl.usage |= usage_of(use.access);
        return true;
    }
    add_help(reporter.error(desc.loc, "W243",
                            "the program exports " + quote(desc.name) +
                                ", which lives longer than a frame: it has " + kept),
             "copy it to another resource with a pass of type \"copy\", and export that resource");
    return false;
}

}  // namespace weft
