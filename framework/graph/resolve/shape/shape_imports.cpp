#include "graph/resolve/shape/shape_imports.h"

#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

std::vector<std::string> import_names(const ImportCatalog& catalog) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : catalog.imports) names.push_back(name);
    return names;
}

// Returns the import that the program offers under this name. Returns null after reporting an error.
const ImportDecl* find_offered(const ResolveInput& input, const ImportDesc& desc, Reporter& reporter) {
    const auto found = input.imports.imports.find(desc.name);
    if (found == input.imports.imports.end()) {
        Diagnostic& d =
            reporter.error(desc.loc, "W118", "the program does not offer the import " + quote(desc.name));
        const std::vector<std::string> names = import_names(input.imports);
        const std::string near = did_you_mean_text(desc.name, names);
        add_help(d, near.empty() ? "the program offers " + quote_all(names) : near);
        return nullptr;
    }
    const ImportDecl& import = found->second;
    if (desc.kind != import_kind_name(import.kind)) {
        Diagnostic& d =
            reporter.error(desc.loc, "W118",
                           "import " + quote(desc.name) + " is of kind " +
                               quote(import_kind_name(import.kind)) + ", not " + quote(desc.kind));
        add_help(d, "write " + quote(desc.name) + ": " + quote(import_kind_name(import.kind)));
        return nullptr;
    }
    return &import;
}

bool has_content(const ResourceDecl& decl) {
    return decl.kind == ResourceKind::buffer || !decl.import ||
           decl.import->entry.layout != Layout::undefined;
}

}  // namespace

bool is_draw_list(const ImportDesc& import) {
    return import.kind == import_kind_name(ImportKind::draw_list);
}

bool is_view_list(const ImportDesc& import) {
    return import.kind == import_kind_name(ImportKind::views);
}

bool is_turns(const ImportDesc& import) {
    return import.kind == "turns";
}

void shape_import(const ResolveInput& input, const ImportDesc& desc, ResourceId id, Shapes& shapes,
                  Reporter& reporter) {
    const ImportDecl* import = find_offered(input, desc, reporter);
    if (!import) {
        shapes.suspects.shapes[id] = shapes.suspects.writers[id] = 1;
        return;
    }
    ResourceDecl& decl = shapes.resources[id];
    decl = import->resource;
    decl.name = desc.name;
    decl.loc = desc.loc;
    decl.lifetime = ResourceLifetime::imported;
    if (!decl.import) decl.import = ImportState{};
    if (import->kind == ImportKind::output) decl.extent = input.request.size;
    if (const auto size = input.request.import_sizes.find(desc.name);
        size != input.request.import_sizes.end()) {
        decl.extent = size->second.extent;
        decl.size_bytes = size->second.size_bytes;
    }
    if (decl.kind == ResourceKind::image) {
        const FormatInfo& format = format_info(decl.format);
        decl.aspects = static_cast<AspectMask>((format.depth ? aspect::kDepth : 0) |
                                               (format.stencil ? aspect::kStencil : 0));
        if (decl.aspects == 0) decl.aspects = aspect::kColor;
    }
    shapes.origins[id].has_content = has_content(decl);
}

void check_list_imports(const ResolveInput& input, Reporter& reporter) {
    for (const auto& [name, import] : input.graph.imports) {
        if (is_draw_list(import) || is_view_list(import)) find_offered(input, import, reporter);
    }
}

}  // namespace weft
