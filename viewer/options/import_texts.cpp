#include "viewer/options/import_texts.h"

#include <algorithm>
#include <array>

#include "viewer/options/arguments.h"
#include "viewer/options/numbers.h"

namespace weft::viewer {
namespace {

constexpr uint64_t kMostViews = 128;
constexpr uint64_t kMostTextures = 65'536;
constexpr uint64_t kMostBytes = uint64_t{1} << 32;
constexpr std::array kKinds{"drawlist", "views", "textures", "image", "buffer"};

// The parts of the text of an import. For "props=drawlist:position,normal", they are "props", "drawlist" and
// "position,normal".
struct ImportText {
    std::string name, kind, rest;
};

ImportText split(const std::string& text) {
    const size_t equals = text.find('='), colon = text.find(':', equals);
    if (equals == std::string::npos || colon == std::string::npos) return {};
    return {text.substr(0, equals), text.substr(equals + 1, colon - equals - 1), text.substr(colon + 1)};
}

std::vector<std::string> attribute_names(const std::string& list) {
    std::vector<std::string> names{""};
    for (const char c : list) {
        if (c == ',')
            names.emplace_back();
        else
            names.back() += c;
    }
    return names;
}

std::string image_fault(const std::string& rest) {
    const size_t colon = rest.find(':');
    if (colon == std::string::npos) return "an image needs its format and its size: image:rgba8:256x256";
    const std::string format = rest.substr(0, colon);
    if (!format_from_name(format)) {
        const std::string near = did_you_mean_text(format, format_names());
        return "\"" + format + "\" is not a format of images" + (near.empty() ? "" : ": " + near);
    }
    return size_fault(rest.substr(colon + 1));
}

std::string rest_fault(const ImportText& import) {
    if (import.kind == "views") return whole_number_fault(import.rest, 1, kMostViews);
    if (import.kind == "textures") return whole_number_fault(import.rest, 1, kMostTextures);
    if (import.kind == "buffer") return whole_number_fault(import.rest, 1, kMostBytes);
    if (import.kind == "image") return image_fault(import.rest);
    if (std::ranges::count(attribute_names(import.rest), "") > 0)
        return "a draw list needs the names of its vertex attributes: drawlist:position,normal";
    return "";
}

void set_resource(const ImportText& text, ImportDecl& import) {
    ResourceDecl& resource = import.resource;
    resource.name = text.name;
    resource.lifetime = ResourceLifetime::imported;
    // The state that is assumed for the import between frames: the most common one. The check of a graph does
    // not depend on this state.
    AccessState between{stage::kFragmentShader | stage::kComputeShader, access::kSampledRead,
                        Layout::shader_read_only};
    if (import.kind == ImportKind::image) {
        const size_t colon = text.rest.find(':');
        resource.kind = ResourceKind::image;
        resource.format = format_from_name(text.rest.substr(0, colon)).value_or(Format::rgba8);
        resource.extent = parse_size(text.rest.substr(colon + 1));
        resource.usage = usage::kSampled | usage::kStorage | usage::kColorAttachment | usage::kTransferSrc |
                         usage::kTransferDst;
    } else {
        resource.kind = ResourceKind::buffer;
        resource.size_bytes = whole_number(text.rest).value_or(1);
        resource.usage = usage::kStorage | usage::kTransferSrc | usage::kTransferDst | usage::kIndirect;
        between = {stage::kComputeShader, access::kStorageRead, Layout::undefined};
    }
    resource.import = ImportState{between, between, 0};
}

ImportDecl parse_import(const ImportText& text) {
    if (text.kind == "textures")
        return texture_table(text.name, static_cast<uint32_t>(whole_number(text.rest).value_or(1)));
    ImportDecl import;
    import.name = text.name;
    if (text.kind == "drawlist") {
        import.kind = ImportKind::draw_list;
        import.variants = {DrawVariant {}};
        for (const std::string& name : attribute_names(text.rest))
            import.vertex_format.attributes.push_back({.name = name});
    } else if (text.kind == "views") {
        import.kind = ImportKind::views;
        import.views = static_cast<uint32_t>(whole_number(text.rest).value_or(1));
    } else {
        import.kind = text.kind == "image" ? ImportKind::image : ImportKind::buffer;
        set_resource(text, import);
    }
    return import;
}

}  // namespace

std::string import_fault(const std::string& text) {
    const ImportText import = split(text);
    if (import.name.empty() || std::ranges::find(kKinds, import.kind) == kKinds.end())
        return "\"" + text +
               "\" is not an import; wanted NAME=KIND:VALUE, where KIND is drawlist, views, textures, image "
               "or buffer";
    return rest_fault(import);
}

std::map<std::string, ImportDecl, std::less<>> parse_imports(const std::vector<std::string>& texts) {
    std::map<std::string, ImportDecl, std::less<>> imports;
    for (const std::string& text : texts) {
        const ImportText import = split(text);
        imports.insert_or_assign(import.name, parse_import(import));
    }
    return imports;
}

void add_imports(const std::map<std::string, ImportDecl, std::less<>>& imports, ImportCatalog& catalog) {
    for (const auto& [name, import] : imports) {
        catalog.imports.insert_or_assign(name, import);
        if (import.kind == ImportKind::draw_list) catalog.bindings.clear();
    }
}

}  // namespace weft::viewer
