#include <algorithm>

#include "graph/located_text.h"
#include "graph/parse_context.h"
#include "weft/format.h"

namespace weft {
namespace {

// "normal: rg16_snorm|rgba16f": the first that the device can do.
void read_formats(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    std::string text;
    if (!read_string(context, node, text)) return;
    size_t begin = 0;
    while (begin <= text.size()) {
        const size_t end = std::min(text.find('|', begin), text.size());
        const std::string name = text.substr(begin, end - begin);
        resource.formats.push_back(name);
        if (!format_from_name(name)) {
            const SourceLoc loc = LocatedText{node.string, node.loc}.at(begin, name.size());
            const std::string near = did_you_mean_text(name, format_names());
            context.error(loc, "W116", "unknown format \"" + name + "\"",
                          near.empty() ? "formats are " + quoted_list(format_names()) : near);
        }
        begin = end + 1;
    }
}

void read_mips(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    resource.full_mips = node.kind == JsonKind::string && node.string == "full";
    if (!resource.full_mips) read_expression(context, node, resource.mips);
}

void read_layers(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    if (read_expression(context, node, resource.layers)) resource.image_kind = ImageKind::d2_array;
}

void read_element(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    resource.is_buffer = true;
    if (read_string(context, node, resource.element))
        check_identifier(context, "an element type", resource.element, node.loc);
}

constexpr std::array kResourceKeys{
    KeyRule<ResourceDesc>{"format", read_formats},
    KeyRule<ResourceDesc>{
        "size", [](ParseContext& c, const JsonNode& n, ResourceDesc& r) { read_size(c, n, r.size); }},
    KeyRule<ResourceDesc>{"mips", read_mips},
    KeyRule<ResourceDesc>{"layers", read_layers},
    KeyRule<ResourceDesc>{"buffer", read_element},
    KeyRule<ResourceDesc>{
        "count", [](ParseContext& c, const JsonNode& n, ResourceDesc& r) { read_expression(c, n, r.count); }},
    KeyRule<ResourceDesc>{
        "clear", [](ParseContext& c, const JsonNode& n, ResourceDesc& r) { read_color(c, n, r.clear); }},
    KeyRule<ResourceDesc>{"preExposed", [](ParseContext& c, const JsonNode& n,
                                           ResourceDesc& r) { read_bool(c, n, r.pre_exposed); }},
};

void refuse(ParseContext& context, const JsonNode& node, std::string_view what,
            std::span<const std::string_view> keys) {
    for (const JsonMember& member : node.members) {
        for (const std::string_view key : keys) {
            if (member.key != key) continue;
            const PointerScope scope(context, key);
            context.error(member.key_loc, "W101", std::string(what) + " has no \"" + member.key + "\"",
                          "remove it: buffers have \"buffer\" and \"count\", images all the other keys");
        }
    }
}

void check_kind(ParseContext& context, const JsonMember& member) {
    static constexpr std::array<std::string_view, 6> kImageKeys{"format", "size",  "mips",
                                                                "layers", "clear", "preExposed"};
    static constexpr std::array<std::string_view, 1> kBufferKeys{"count"};
    const JsonNode& node = member.value;
    if (node.find("buffer") != nullptr) {
        refuse(context, node, "a buffer", kImageKeys);
        if (node.find("count") == nullptr)
            missing_key(context, member.key_loc, "a buffer", "count", "say how many elements it holds");
        return;
    }
    refuse(context, node, "an image", kBufferKeys);
    if (node.find("format") == nullptr)
        missing_key(context, member.key_loc, "a resource", "format",
                    "an image needs \"format\", a buffer \"buffer\" and \"count\"");
}

}  // namespace

void parse_resources(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_named(context, node, "a resource", [&](const JsonMember& member) {
        ResourceDesc resource;
        resource.name = member.key;
        resource.loc = member.key_loc;
        if (!read_object(context, member.value, "a resource", kResourceKeys, resource)) return;
        check_kind(context, member);
        graph.resources.emplace(member.key, std::move(resource));
    });
}

}  // namespace weft
