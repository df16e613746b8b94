#include <map>

#include "graph/parse/expression.h"
#include "graph/parse/parse.h"
#include "graph/parse/parse_context.h"
#include "graph/syntax/module_names.h"

namespace weft {
namespace {

constexpr int64_t kFormatVersion = 1;
constexpr int64_t kMaxJitter = 64;

const std::vector<std::string>& import_kinds() {
    static const std::vector<std::string> kinds{"drawlist", "buffer", "image", "cube",
                                                "output",   "turns",  "views", "textures"};
    return kinds;
}

void read_version(ParseContext& context, const JsonNode& node, GraphDesc&) {
    double version = 0;
    if (!read_number(context, node, version) || version == static_cast<double>(kFormatVersion)) return;
    context.error(node.loc, "W109", "the graph format has no version " + node.string,
                  "write \"version\": 1, which is the only version that this program reads");
}

void read_import_kind(ParseContext& context, const JsonNode& node, ImportDesc& import) {
    if (!read_string(context, node, import.kind)) return;
    for (const std::string& kind : import_kinds())
        if (kind == import.kind) return;
    Diagnostic& error = context.error(node.loc, "W118", "unknown kind of import \"" + import.kind + "\"");
    const std::string near = did_you_mean_text(import.kind, import_kinds());
    if (!near.empty()) error.help.push_back(near);
    error.help.push_back("the kinds of imports are " + quoted_list(import_kinds()));
}

constexpr std::array kImportKeys{KeyRule<ImportDesc>{"kind", read_import_kind}};

void read_imports(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_named(context, node, "an import", [&](const JsonMember& member) {
        ImportDesc import{member.key, {}, member.key_loc};
        if (!read_object(context, member.value, "an import", kImportKeys, import)) return;
        if (member.value.find("kind") == nullptr)
            missing_key(context, member.key_loc, "an import", "kind",
                        "the kinds of imports are " + quoted_list(import_kinds()));
        graph.imports.emplace(member.key, std::move(import));
    });
}

void read_consts(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_parts(context, node, "a constant", [&](const JsonMember& member) {
        if (!check_value_count(context, graph, member.key_loc)) return;
        Expr value;
        if (read_expression(context, member.value, value)) graph.consts.emplace(member.key, std::move(value));
    });
}

// A size whose scale can change in each frame. In JSON, it is an object with the keys "size" and "scale".
struct LiveSizeDraft {
    Expr size;
    SizeScaleDesc scale;
};

constexpr std::array kLiveSizeKeys{
    KeyRule<LiveSizeDraft>{"size", read_member<read_size, &LiveSizeDraft::size>},
    KeyRule<LiveSizeDraft>{"scale", [](ParseContext& c, const JsonNode& n, LiveSizeDraft& d) {
                               d.scale.loc = n.loc;
                               std::string param;
                               if (read_string(c, n, param)) d.scale.param = c.param_name(param, n.loc);
                           }}};

void read_live_size(ParseContext& context, const JsonMember& member, GraphDesc& graph) {
    LiveSizeDraft draft;
    if (!read_object(context, member.value, "a live size", kLiveSizeKeys, draft)) return;
    constexpr std::array<std::array<const char*, 2>, 2> kNeeded{
        {{"size", "write the size at scale 1, for example \"size\": \"output\""},
         {"scale", "write the name of a parameter, or only the size: \"render\": \"output\""}}};
    for (const auto& [key, help] : kNeeded)
        if (member.value.find(key) == nullptr) missing_key(context, member.key_loc, "a live size", key, help);
    if (draft.size.empty() || draft.scale.param.empty()) return;
    graph.sizes.emplace(member.key, std::move(draft.size));
    graph.size_scales.emplace(member.key, std::move(draft.scale));
}

void read_sizes(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_parts(context, node, "a size", [&](const JsonMember& member) {
        if (!check_value_count(context, graph, member.key_loc)) return;
        if (member.value.kind == JsonKind::object) return read_live_size(context, member, graph);
        Expr size;
        if (read_size(context, member.value, size)) graph.sizes.emplace(member.key, std::move(size));
    });
}

void read_frames(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    int64_t frames = 1;
    if (node.kind == JsonKind::number && !read_integer(context, node, 1, kMaxFrames, frames)) return;
    read_expression(context, node, graph.frames);
}

void read_jitter(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    int64_t jitter = 0;
    if (read_integer(context, node, 0, kMaxJitter, jitter)) graph.jitter = static_cast<uint32_t>(jitter);
}

void read_text(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_string(context, node, graph.name);
}

// Checks only that the value is an object: either a section of the "patch" of a tier (quality level), or the
// "set" of a tier. The content is not parsed here: if the graph is loaded with this tier, merge() has already
// applied the content to the sections of the graph, and these are parsed.
void skip_object(ParseContext& context, const JsonNode& node, TierDesc&) {
    expect(context, node, JsonKind::object);
}

void skip_value(ParseContext&, const JsonNode&, TierDesc&) {}

// The sections that the patch of a tier may change. Sections that describe the file itself, such as "name"
// and "version", are not among them.
constexpr std::array kPatchKeys{
    KeyRule<TierDesc>{"imports", skip_object},   KeyRule<TierDesc>{"consts", skip_object},
    KeyRule<TierDesc>{"params", skip_object},    KeyRule<TierDesc>{"sizes", skip_object},
    KeyRule<TierDesc>{"resources", skip_object}, KeyRule<TierDesc>{"passes", skip_object},
    KeyRule<TierDesc>{"groups", skip_object},    KeyRule<TierDesc>{"debug", skip_object},
    KeyRule<TierDesc>{"views", skip_object},     KeyRule<TierDesc>{"jitter", skip_value},
    KeyRule<TierDesc>{"frames", skip_value}};

// Checks only which sections the patch of a tier has, not their content (see skip_object()).
void check_patch(ParseContext& context, const JsonNode& node, TierDesc& tier) {
    read_object(context, node, "a patch", kPatchKeys, tier);
}

constexpr std::array kTierKeys{KeyRule<TierDesc>{"set", skip_object},
                               KeyRule<TierDesc>{"patch", check_patch}};

void read_tiers(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    read_named(context, node, "a tier", [&](const JsonMember& member) {
        TierDesc tier{member.key, member.key_loc};
        if (read_object(context, member.value, "a tier", kTierKeys, tier))
            graph.tiers.push_back(std::move(tier));
    });
}

// Skips the keys "include" and "ports", because read_graph() has already read them.
void skip_read(ParseContext&, const JsonNode&, GraphDesc&) {}

// Skips the section "tests", because tests refer to names of other sections. parse() reads "tests" after all
// other sections.
void skip_tests(ParseContext&, const JsonNode&, GraphDesc&) {}

// Accepts any string for the key "$schema", which only text editors use.
void skip_schema(ParseContext& context, const JsonNode& node, GraphDesc&) {
    expect(context, node, JsonKind::string);
}

constexpr std::array kTopKeys{
    KeyRule<GraphDesc>{"$schema", skip_schema}, KeyRule<GraphDesc>{"version", read_version},
    KeyRule<GraphDesc>{"name", read_text},      KeyRule<GraphDesc>{"imports", read_imports},
    KeyRule<GraphDesc>{"consts", read_consts},  KeyRule<GraphDesc>{"params", parse_params},
    KeyRule<GraphDesc>{"sizes", read_sizes},    KeyRule<GraphDesc>{"resources", parse_resources},
    KeyRule<GraphDesc>{"passes", parse_passes}, KeyRule<GraphDesc>{"frames", read_frames},
    KeyRule<GraphDesc>{"include", skip_read},   KeyRule<GraphDesc>{"tiers", read_tiers},
    KeyRule<GraphDesc>{"debug", parse_debug},   KeyRule<GraphDesc>{"tests", skip_tests},
    KeyRule<GraphDesc>{"jitter", read_jitter},  KeyRule<GraphDesc>{"groups", parse_groups},
    KeyRule<GraphDesc>{"views", parse_views},   KeyRule<GraphDesc>{"ports", skip_read},
};

// Checks that no two entries of `sections` have the same name, even if they are in different sections. A
// reference or an expression gives only the name, not the section, so equal names would be ambiguous. If
// `in_expressions` is true, also reports reserved words of expressions.
void check_shared_names(ParseContext& context, const JsonNode& root,
                        std::span<const std::string_view> sections, bool in_expressions) {
    std::map<std::string, SourceLoc> first;
    for (const std::string_view section : sections) {
        const JsonNode* node = root.find(section);
        if (node == nullptr) continue;
        const PointerScope section_scope(context, section);
        for (const JsonMember& member : node->members) {
            const PointerScope scope(context, member.key);
            const ModuleNames* modules = context.modules();
            if (in_expressions &&
                is_reserved_word(modules == nullptr ? member.key : modules->own_part(member.key)))
                context.error(member.key_loc, "W109",
                              "\"" + member.key +
                                  "\" is a reserved word of expressions, so nothing else can have this name",
                              "choose another name");
            const auto [it, is_new] = first.emplace(member.key, member.key_loc);
            if (is_new) continue;
            Diagnostic& error =
                context.error(member.key_loc, "W109", "the name \"" + member.key + "\" is already used");
            error.help.emplace_back("choose another name, because references find both by name");
            error.notes.push_back({error.file, it->second.line, it->second.column, "first used here"});
        }
    }
}

void list_modules(const JsonDoc& document, const ModuleNames& names, GraphDesc& graph) {
    for (const ModuleInstance& module : document.modules) {
        if (module.name.empty()) continue;
        ModuleDesc& desc = graph.modules[module.name];
        desc.parent = document.modules[module.parent].name;
        for (const auto& [port, target] : module.with) desc.values[port] = names.target_value(module, target);
    }
}

// Returns the name of a file without its folder and extension: "deferred" for "graphs/deferred.json".
std::string stem(const std::string& path) {
    const size_t slash = path.find_last_of('/');
    const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
    return file.substr(0, file.find('.'));
}

}  // namespace

void list_graph_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "graph", kTopKeys);
    list_keys(lists, "import", kImportKeys);
    list_keys(lists, "liveSize", kLiveSizeKeys);
    lists.push_back({"importKind", false, import_kinds()});
    list_keys(lists, "tier", kTierKeys);
    list_keys(lists, "patch", kPatchKeys);
}

bool check_value_count(ParseContext& context, const GraphDesc& graph, SourceLoc loc) {
    return context.within(graph.consts.size() + graph.params.size() + graph.sizes.size() + 1,
                          context.limits().constants, loc, "parameters, constants and sizes",
                          "graph.constants", "remove parameters, constants and sizes that nothing uses");
}

Result<GraphDesc> parse(const JsonDoc& document, const GraphLimits& limits) {
    static constexpr std::array<std::string_view, 3> kExpressionNames{"consts", "params", "sizes"};
    static constexpr std::array<std::string_view, 2> kReferenceNames{"imports", "resources"};
    static constexpr std::array<std::string_view, 2> kViewNames{"imports", "views"};
    GraphDesc graph;
    graph.sources = document.sources;
    if (!graph.sources.files.empty()) graph.name = stem(graph.sources.files.front().path);
    ParseContext context(document.sources, limits);
    const JsonNode& root = document.root;
    const ModuleNames modules(document);
    if (!document.modules.empty()) {
        context.set_modules(&modules);
        list_modules(document, modules, graph);
    }
    if (read_object(context, root, "a graph", kTopKeys, graph)) {
        if (root.find("version") == nullptr)
            missing_key(context, root.loc, "a graph", "version", "write \"version\": 1 first");
        if (root.find("passes") == nullptr)
            missing_key(context, root.loc, "a graph", "passes", "write \"passes\": { … }");
        check_shared_names(context, root, kExpressionNames, true);
        check_indices(context, graph);
        check_shared_names(context, root, kReferenceNames, false);
        check_shared_names(context, root, kViewNames, false);
        check_groups(context, root, graph);
        if (const JsonNode* tests = root.find("tests")) {
            const PointerScope scope(context, "tests");
            parse_tests(context, *tests, graph);
        }
    }
    if (context.has_errors()) return context.take_errors();
    return graph;
}

}  // namespace weft
