#include "graph/resolve/fault_text.h"

#include <algorithm>

namespace weft {
namespace {

// A list in a message shows at most this many names, because a longer list does not help the reader.
constexpr size_t kMostListed = 64;

}  // namespace

std::string quote(std::string_view name) {
    std::string text = "\"";
    text += name;
    return text += '"';
}

std::string quote_all(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < std::min(names.size(), kMostListed); ++i) {
        if (i > 0) text += ", ";
        text += quote(names[i]);
    }
    if (names.size() > kMostListed) text += " and " + std::to_string(names.size() - kMostListed) + " more";
    return text;
}

std::string range_of(const ResourceDecl& resource, const SubresourceRange& range) {
    const auto span = [](const char* what, uint32_t first, uint32_t count) {
        std::string written = ".";
        written.append(what).append("(").append(std::to_string(first));
        if (count > 1) written.append("..").append(std::to_string(first + count - 1));
        return written.append(")");
    };
    if (resource.kind == ResourceKind::buffer)
        return range == resource.whole() ? resource.name : resource.name + range_text(resource, range);
    std::string text = resource.name;
    if (range.mips != resource.mips) text += span("mip", range.mip, range.mips);
    if (range.layers != resource.layers) text += span("layer", range.layer, range.layers);
    return text;
}

std::string extent_text(const Extent3D& extent) {
    std::string text = std::to_string(extent.width);
    text.append("x").append(std::to_string(extent.height));
    if (extent.depth > 1) text.append("x").append(std::to_string(extent.depth));
    return text;
}

std::string add_port_text(std::string_view direction, std::string_view port) {
    return "add the port " + quote(port) + " to " + quote(direction) +
           " of the pass, with the name of a resource: " + quote(direction) + ": { " + quote(port) +
           ": \"NAME\" }";
}

void add_help(Diagnostic& diagnostic, std::string help) {
    if (!help.empty()) diagnostic.help.push_back(std::move(help));
}

void add_note(Diagnostic& diagnostic, const SourceMap& sources, SourceLoc loc, std::string message) {
    const Diagnostic place = sources.error(loc, "", "");
    if (place.line != 0)
        diagnostic.notes.push_back({place.file, place.line, place.column, std::move(message)});
}

}  // namespace weft
