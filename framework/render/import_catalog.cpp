#include "render/import_catalog.h"

#include "shared/light.glsl"

namespace weft::render {
namespace {

// One stream for what every pass reads, one for what only shading needs.
VertexFormat canonical_vertex_format() {
    return {{16, 24},
            {{"position", Format::rgba32f, 0, 0},
             {"normal", Format::rgba16_snorm, 1, 0},
             {"tangent", Format::rgba16_snorm, 1, 8},
             {"uv", Format::rg32f, 1, 16}}};
}

ImportDecl draw_list(const std::string& name, DrawVariant variant) {
    ImportDecl import;
    import.name = name;
    import.kind = ImportKind::draw_list;
    import.variants = {std::move(variant)};
    import.vertex_format = canonical_vertex_format();
    return import;
}

ImportDecl output(Extent3D extent) {
    ImportDecl import;
    import.name = "backbuffer";
    import.kind = ImportKind::output;
    ResourceDecl& image = import.resource;
    image.name = import.name;
    image.kind = ResourceKind::image;
    image.lifetime = ResourceLifetime::imported;
    image.format = Format::rgba8;
    image.extent = extent;
    image.usage = usage::kColorAttachment | usage::kStorage | usage::kSampled | usage::kTransferSrc |
                  usage::kTransferDst;
    // Between frames somebody copies it: that copy must be over before the next frame writes, and its content
    // is of no interest to that frame.
    const AccessState copied{stage::kCopy, access::kTransferRead, Layout::transfer_src};
    image.import = ImportState{{stage::kCopy, access::kTransferRead, Layout::undefined}, copied, 0};
    return import;
}

}  // namespace

ImportCatalog scene_imports(Extent3D output_extent) {
    ImportCatalog catalog;
    for (ImportDecl import :
         {draw_list("opaque", {"opaque", {{"MASKED", 0}}}), draw_list("masked", {"masked", {{"MASKED", 1}}}),
          draw_list("transparent", {"transparent", {{"MASKED", 0}}}), output(output_extent)}) {
        const std::string name = import.name;
        catalog.imports.emplace(name, std::move(import));
    }
    catalog.views = {"camera"};
    catalog.strides = {{"Light", sizeof(shared::Light)}};
    return catalog;
}

}  // namespace weft::render
