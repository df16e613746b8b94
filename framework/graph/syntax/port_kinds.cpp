#include "graph/syntax/port_kinds.h"

#include <array>
#include <optional>

#include "graph/diagnostics/name_of_value.h"
#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

struct DeclaringSection {
    std::string_view key;
    NameKind kind;
};
constexpr std::array kDeclaringSections{
    DeclaringSection{"consts", NameKind::value}, DeclaringSection{"params", NameKind::value},
    DeclaringSection{"sizes", NameKind::value},  DeclaringSection{"resources", NameKind::resource},
    DeclaringSection{"views", NameKind::view},
};

void note_reference(const JsonDoc& merged, const JsonNode* reference, PortKinds& kinds) {
    if (reference == nullptr || reference->kind != JsonKind::string) return;
    const uint32_t file = reference->loc.file;
    const uint32_t module = file < merged.module_of_file.size() ? merged.module_of_file[file] : 0;
    // A name with the prefix "owner::" is a part of another module or of a group.
    const std::string_view name =
        std::string_view(reference->string).substr(0, reference->string.find_first_of("@[."));
    if (module == 0 || name.find(kInGroup) != std::string_view::npos) return;
    if (merged.modules[module].with.contains(std::string(name)))
        kinds[module].emplace(name, NameKind::resource);
}

void note_port(const JsonDoc& merged, const JsonNode& port, PortKinds& kinds) {
    for (const char* key : {"ref", "else"}) note_reference(merged, port.find(key), kinds);
}

// Returns the words for a kind in messages.
std::string kind_text(NameKind kind) {
    return name_of_value(kind, std::array{"a parameter, a constant or a size", "a resource or an import",
                                          "a list of views", "a pass"});
}

}  // namespace

void find_declared_kinds(const JsonNode& root, const ModuleInstance& module,
                         std::map<std::string, NameKind>& kinds) {
    for (const DeclaringSection& section : kDeclaringSections) {
        const JsonNode* node = root.find(section.key);
        if (node == nullptr) continue;
        for (const JsonMember& member : node->members)
            if (module.with.contains(member.key)) kinds.emplace(member.key, section.kind);
    }
}

void find_used_kinds(const JsonDoc& merged, PortKinds& kinds) {
    const JsonNode* passes = merged.root.find("passes");
    if (passes == nullptr) return;
    for (const JsonMember& pass : passes->members) {
        for (const char* side : {"in", "out"})
            if (const JsonNode* ports = pass.value.find(side))
                for (const JsonMember& port : ports->members) note_port(merged, port.value, kinds);
        if (const JsonNode* depth = pass.value.find("depth")) note_port(merged, *depth, kinds);
    }
}

void check_port_kinds(const JsonDoc& merged, const ModuleNames& names, const PortKinds& kinds,
                      Diagnostics& errors) {
    for (const auto& [module, ports] : kinds)
        for (const auto& [port, kind] : ports) {
            const ModuleInstance& owner = merged.modules[module];
            const PortTarget& target = owner.with.at(port);
            const std::optional<NameKind> found = names.kind_of(owner.parent, target.name, kind);
            if (!found || *found == kind || !owner.ports.contains(port)) continue;
            Diagnostic& d = errors.emplace_back(merged.sources.error(
                target.loc, "W240",
                "the port \"" + port + "\" of module \"" + owner.name + "\" needs " + kind_text(kind) +
                    ", but \"" + target.name + "\" is " + kind_text(*found)));
            d.help.push_back("name " + kind_text(kind));
        }
}

}  // namespace weft
