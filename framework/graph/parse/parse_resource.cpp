#include <algorithm>
#include <filesystem>

#include "graph/diagnostics/located_text.h"
#include "graph/parse/parse_context.h"
#include "graph/parse/reference.h"
#include "weft/format.h"

namespace weft {
namespace {

// Reads the format of an image. In "rg16_snorm|rgba16f", the formats are alternatives: the first format that
// the device supports is used.
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
                          near.empty() ? "allowed formats are " + quoted_list(format_names()) : near);
        }
        begin = end + 1;
    }
}

void read_mips(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    resource.full_mips = node.kind == JsonKind::string && node.string == "full";
    if (!resource.full_mips) read_expression(context, node, resource.mips);
}

constexpr std::array kKinds{
    Choice<ImageKind>{"2d", ImageKind::d2}, Choice<ImageKind>{"array", ImageKind::d2_array},
    Choice<ImageKind>{"cube", ImageKind::cube}, Choice<ImageKind>{"cubeArray", ImageKind::cube_array},
    Choice<ImageKind>{"3d", ImageKind::d3}};

void read_kind(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    read_choice(context, node, kKinds, resource.image_kind);
}

// Reads "cube", which makes the resource a cube image of six square faces. The value is the side of a face in
// pixels.
void read_cube(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    if (read_expression(context, node, resource.size)) resource.image_kind = ImageKind::cube;
}

// Reads a count. A literal number must be whole and in the allowed range; the result of an expression is
// checked in resolve().
bool read_count(ParseContext& context, const JsonNode& node, int64_t least, int64_t most, Expr& out) {
    int64_t number = 0;
    if (node.kind == JsonKind::number && !read_integer(context, node, least, most, number)) return false;
    return read_expression(context, node, out);
}

void read_samples(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    if (node.kind == JsonKind::number && node.number != 1 && node.number != 2 && node.number != 4 &&
        node.number != 8)
        return context.error(node.loc, "W109", "found " + node.string + " samples", "write 1, 2, 4 or 8");
    read_expression(context, node, resource.samples);
}

void read_layers(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    read_expression(context, node, resource.layers);
}

constexpr std::array kOnResizes{Choice<OnResize>{"clear", OnResize::clear},
                                Choice<OnResize>{"resample", OnResize::resample},
                                Choice<OnResize>{"refill", OnResize::refill}};

void read_history(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    read_count(context, node, 0, kMaxHistory, resource.history);
}

void read_keep(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    if (node.kind == JsonKind::boolean) {
        resource.keep = node.boolean ? KeepMode::frames : KeepMode::none;
    } else if (node.kind != JsonKind::string) {
        wrong_type(context, node, "true, false or \"shared\"");
    } else if (node.string == "shared") {
        resource.keep = KeepMode::shared;
    } else {
        bad_choice(context, node, node.string, {"shared"});
    }
}

void read_element(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    resource.is_buffer = true;
    if (read_string(context, node, resource.element))
        check_identifier(context, "an element type", resource.element, node.loc);
}

// A path with ".." or an absolute path could lead to any file of the machine.
void read_file(ParseContext& context, const JsonNode& node, FileDesc& file) {
    std::string name;
    if (!read_string(context, node, name)) return;
    const std::filesystem::path path(name);
    if (name.empty() || path.is_absolute() || std::ranges::find(path, "..") != path.end())
        return context.error(node.loc, "W145",
                             "\"" + name + "\" is not a path inside the folder of the graph",
                             "write a path without \"..\", relative to the folder of this file or to the "
                             "shipped folders graphs/ and shaders/");
    file.name = std::move(name);
    file.loc = node.loc;
}

void read_file_name(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    read_file(context, node, resource.file);
}

void read_textures(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    if (node.kind != JsonKind::array) return wrong_type(context, node, "a list of files");
    if (node.items.empty())
        return context.error(node.loc, "W109", "the list of textures is empty",
                             "write the names of the files: [\"bark.png\", \"leaf.png\"]");
    if (!context.within(node.items.size(), context.limits().layers, node.loc, "textures in a table",
                        "graph.layers", "use fewer textures"))
        return;
    for (size_t i = 0; i < node.items.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        read_file(context, node.items[i], resource.textures.emplace_back());
    }
}

constexpr std::array kResourceKeys{
    KeyRule<ResourceDesc>{"format", read_formats},
    KeyRule<ResourceDesc>{"size", read_member<read_size, &ResourceDesc::size>},
    KeyRule<ResourceDesc>{"mips", read_mips},
    KeyRule<ResourceDesc>{"layers", read_layers},
    KeyRule<ResourceDesc>{"depth", read_layers},
    KeyRule<ResourceDesc>{"kind", read_kind},
    KeyRule<ResourceDesc>{"cube", read_cube},
    KeyRule<ResourceDesc>{"samples", read_samples},
    KeyRule<ResourceDesc>{"buffer", read_element},
    KeyRule<ResourceDesc>{"count", read_member<read_expression, &ResourceDesc::count>},
    KeyRule<ResourceDesc>{"clear", read_member<read_color, &ResourceDesc::clear>},
    KeyRule<ResourceDesc>{"preExposed", read_member<read_bool, &ResourceDesc::pre_exposed>},
    KeyRule<ResourceDesc>{"history", read_history},
    KeyRule<ResourceDesc>{"keep", read_keep},
    KeyRule<ResourceDesc>{"firstFrame", read_member<read_color, &ResourceDesc::first_frame>},
    KeyRule<ResourceDesc>{"onResize", [](ParseContext& c, const JsonNode& n,
                                         ResourceDesc& r) { read_choice(c, n, kOnResizes, r.on_resize); }},
    KeyRule<ResourceDesc>{"file", read_file_name},
    KeyRule<ResourceDesc>{"textures", read_textures},
};

void refuse(ParseContext& context, const JsonNode& node, std::string_view what,
            std::span<const std::string_view> keys) {
    for (const JsonMember& member : node.members) {
        for (const std::string_view key : keys) {
            if (member.key != key) continue;
            const PointerScope scope(context, key);
            context.error(
                member.key_loc, "W101", std::string(what) + " has no \"" + member.key + "\"",
                "remove the key: \"count\" is only for buffers; \"format\", \"size\" and other keys "
                "of texels are only for images");
        }
    }
}

constexpr std::array<std::string_view, 11> kImageKeys{"format", "size",       "mips",    "layers",
                                                      "depth",  "kind",       "cube",    "samples",
                                                      "clear",  "preExposed", "textures"};
constexpr std::array<std::string_view, 1> kBufferKeys{"count"};

std::vector<std::string> keys_but(std::span<const std::string_view> others) {
    std::vector<std::string> keys;
    for (const KeyRule<ResourceDesc>& rule : kResourceKeys)
        if (std::ranges::find(others, rule.key) == others.end()) keys.emplace_back(rule.key);
    return keys;
}

void check_kind(ParseContext& context, const JsonMember& member) {
    const JsonNode& node = member.value;
    if (node.find("buffer") != nullptr) {
        refuse(context, node, "a buffer", kImageKeys);
        if (node.find("count") == nullptr && node.find("file") == nullptr)
            missing_key(context, member.key_loc, "a buffer", "count",
                        "add the number of elements: \"count\": 64");
        return;
    }
    refuse(context, node, "an image", kBufferKeys);
    if (node.find("format") == nullptr)
        missing_key(context, member.key_loc, "a resource", "format",
                    "add \"format\" for an image, or \"buffer\" and \"count\" for a buffer");
}

const char* help_for_layers(ImageKind kind) {
    if (kind == ImageKind::d3) return "a 3D image has no layers: use \"depth\" instead";
    if (kind == ImageKind::cube)
        return "a cube always has six faces; for several cubes write \"kind\": \"cubeArray\"";
    return "write \"kind\": \"array\", or remove \"kind\"";
}

// Sets the kind of an image from its keys, and checks that all keys are allowed for this kind.
void settle_kind(ParseContext& context, const JsonNode& node, ResourceDesc& resource) {
    const auto complain = [&](std::string_view key, const std::string& message, const std::string& help) {
        const PointerScope scope(context, key);
        context.error(node.find(key)->loc, "W109", message, help);
    };
    const auto has = [&](std::string_view key) { return node.find(key) != nullptr; };
    for (const std::string_view key : {"size", "kind"})
        if (has("cube") && has(key))
            complain(key, "the key \"cube\" already determines the " + std::string(key),
                     "remove this key, or replace \"cube\" by \"kind\": \"cube\" and \"size\"");
    if (!has("kind") && !has("cube") && has("layers")) resource.image_kind = ImageKind::d2_array;
    const ImageKind kind = resource.image_kind;
    const bool layered = kind == ImageKind::d2_array || kind == ImageKind::cube_array;
    if (has("layers") && !layered)
        complain("layers", "this kind of image has no layers", help_for_layers(kind));
    if (has("depth") && kind != ImageKind::d3)
        complain("depth", "only 3D images have a depth", "add \"kind\": \"3d\", or remove \"depth\"");
    const JsonNode* samples = node.find("samples");
    if (samples == nullptr || samples->number == 1) return;
    if (kind != ImageKind::d2 && kind != ImageKind::d2_array)
        complain("samples", "cubes and 3D images can't be multisampled", "use a 2D image or an array");
    if (has("mips"))
        complain("mips", "multisampled images have one mip",
                 "remove \"mips\", or resolve into an image with mips");
}

// Checks the keys that concern content of earlier frames. "firstFrame" and "onResize" need "history" or
// "keep". A resource with "history" cannot be shared.
void check_persistence(ParseContext& context, const JsonNode& node, const ResourceDesc& resource) {
    const auto complain = [&](std::string_view key, const std::string& message, const std::string& help) {
        const PointerScope scope(context, key);
        context.error(node.find(key)->loc, "W109", message, help);
    };
    const JsonNode* history = node.find("history");
    if (history != nullptr && history->number != 0 && resource.keep == KeepMode::shared)
        complain("keep", "a resource with \"history\" cannot be shared by all tiers",
                 "write \"keep\": true: Weft then copies its content when the tier changes");
    const bool lasting = resource.keep != KeepMode::none || history != nullptr;
    for (const std::string_view key : {"firstFrame", "onResize"})
        if (!lasting && node.find(key) != nullptr)
            complain(key,
                     "\"" + std::string(key) +
                         "\" has no effect, because the resource keeps no content after the frame",
                     "remove this key, or keep the content with \"history\": 1 or \"keep\": true");
    if (resource.is_buffer && resource.on_resize == OnResize::resample)
        complain("onResize", "a buffer can't be resampled", "choose \"clear\" or \"refill\"");
}

// Reports keys that a table of textures must not have. The files of a table determine all properties of its
// textures except the format and the mips.
void check_table_keys(ParseContext& context, const JsonNode& node) {
    if (node.find("textures") == nullptr || node.find("buffer") != nullptr) return;
    for (const std::string_view key : {"size", "layers", "depth", "kind", "cube", "samples", "clear",
                                       "preExposed", "history", "keep", "firstFrame", "onResize", "file"}) {
        if (node.find(key) == nullptr) continue;
        const PointerScope scope(context, key);
        context.error(node.find(key)->loc, "W109", "a table of textures has no \"" + std::string(key) + "\"",
                      "remove this key: a table has only \"textures\", \"format\" and \"mips\"");
    }
}

// Reports keys that have no effect on a resource with a file, because its content comes from the file and
// never changes.
void check_file_keys(ParseContext& context, const JsonNode& node) {
    if (node.find("file") == nullptr) return;
    for (const std::string_view key :
         {"clear", "preExposed", "samples", "history", "keep", "firstFrame", "onResize"}) {
        if (node.find(key) == nullptr) continue;
        const PointerScope scope(context, key);
        context.error(node.find(key)->loc, "W109",
                      "\"" + std::string(key) + "\" has no effect, because the content comes from a file",
                      "remove this key, or remove \"file\"");
    }
}

}  // namespace

void list_resource_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "resource", kResourceKeys);
    static constexpr std::array<std::string_view, 2> kNotOfImages{"buffer", "count"};
    lists.push_back({"imageResource", true, keys_but(kNotOfImages), {"format"}, "resource"});
    lists.push_back({"bufferResource", true, keys_but(kImageKeys), {"buffer"}, "resource"});
    list_choices(lists, "imageKind", kKinds);
    list_choices(lists, "onResize", kOnResizes);
}

void parse_resources(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_parts(context, node, "a resource", [&](const JsonMember& member) {
        ResourceDesc resource;
        const std::string name = context.declared_name(member.key);
        resource.name = name;
        resource.loc = member.key_loc;
        if (context.group() != nullptr) resource.group = context.group()->name;
        if (!read_object(context, member.value, "a resource", kResourceKeys, resource)) return;
        check_kind(context, member);
        check_table_keys(context, member.value);
        const bool table = !resource.textures.empty();
        if (!table) settle_kind(context, member.value, resource);
        if (!table) check_file_keys(context, member.value);
        // In a group, parse_groups() reports all keys for content of earlier frames. So check_persistence()
        // is not needed there.
        if (!table && context.group() == nullptr) check_persistence(context, member.value, resource);
        graph.resources.emplace(name, std::move(resource));
    });
}

}  // namespace weft
