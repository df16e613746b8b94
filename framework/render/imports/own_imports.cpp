#include "weft/render/own_imports.h"

namespace weft::render {
namespace {

ImportDecl import_decl(ImportKind import_kind, ResourceKind kind, UsageMask usage, AccessState between) {
    ImportDecl import;
    import.kind = import_kind;
    ResourceDecl& decl = import.resource;
    decl.kind = kind;
    decl.lifetime = ResourceLifetime::imported;
    decl.usage = usage;
    decl.import = ImportState{between, between, 0, false};
    return import;
}

}  // namespace

OwnImport own_image(VkImage image, Format format, Extent3D extent, UsageMask usage, AccessState between) {
    OwnImport own{import_decl(ImportKind::image, ResourceKind::image, usage, between), {}};
    own.decl.resource.format = format;
    own.decl.resource.extent = extent;
    own.object.image = image;
    return own;
}

OwnImport own_buffer(VkBuffer buffer, uint64_t size_bytes, uint32_t stride_bytes, UsageMask usage,
                     AccessState between) {
    OwnImport own{import_decl(ImportKind::buffer, ResourceKind::buffer, usage, between), {}};
    own.decl.resource.size_bytes = size_bytes;
    own.decl.resource.stride_bytes = stride_bytes;
    own.object.buffer = buffer;
    return own;
}

}  // namespace weft::render
