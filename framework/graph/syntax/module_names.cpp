#include "graph/syntax/module_names.h"

#include <algorithm>

#include "graph/diagnostics/quoted_list.h"
#include "graph/syntax/include_item.h"
#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

constexpr uint32_t kNoModule = UINT32_MAX;
// The size of images without "size". A module without such a size of its own uses that of the graph.
constexpr std::string_view kRenderSize = "render";
// A list of views also declares the number of its views, for example "facesViews" for "faces".
constexpr std::string_view kNumberOfViews = "Views";

struct NamedSection {
    std::string_view key;
    NameKind kind;
    bool can_be_port;
};
constexpr std::array kNamedSections{
    NamedSection{"consts", NameKind::value, true}, NamedSection{"params", NameKind::value, true},
    NamedSection{"sizes", NameKind::value, true},  NamedSection{"resources", NameKind::resource, true},
    NamedSection{"views", NameKind::view, true},   NamedSection{"passes", NameKind::pass, false},
};

JsonNode* find_member(JsonNode& node, std::string_view key) {
    const auto it = std::ranges::find(node.members, key, &JsonMember::key);
    return it == node.members.end() ? nullptr : &it->value;
}

void add_prefix(JsonNode* section, const ModuleInstance& module) {
    if (section == nullptr) return;
    for (JsonMember& member : section->members) member.key = name_in_group(module.name, member.key);
}

void remove_ports(JsonNode* section, const ModuleInstance& module) {
    if (section == nullptr) return;
    std::erase_if(section->members,
                  [&](const JsonMember& member) { return module.with.contains(member.key); });
}

// Returns true for the key "frames". This key applies only if the file is run itself, not if it is
// included as a module.
bool is_number_of_frames(const JsonMember& member) {
    return member.key == "frames";
}

void qualify_sections(JsonNode& owner, const ModuleInstance& module) {
    std::erase_if(owner.members, is_number_of_frames);
    remove_ports(find_member(owner, "imports"), module);
    for (const NamedSection& section : kNamedSections) {
        JsonNode* node = find_member(owner, section.key);
        if (section.can_be_port) remove_ports(node, module);
        add_prefix(node, module);
    }
    add_prefix(find_member(owner, "groups"), module);
    add_prefix(find_member(owner, "debug"), module);
}

}  // namespace

void qualify_names(JsonNode& root, const ModuleInstance& module) {
    if (module.name.empty()) return;
    std::erase_if(root.members, [](const JsonMember& member) { return member.key == "tests"; });
    qualify_sections(root, module);
    JsonNode* tiers = find_member(root, "tiers");
    if (tiers == nullptr) return;
    for (JsonMember& tier : tiers->members) {
        if (JsonNode* patch = find_member(tier.value, "patch")) qualify_sections(*patch, module);
        JsonNode* values = find_member(tier.value, "set");
        remove_ports(values, module);
        add_prefix(values, module);
    }
}

ModuleNames::ModuleNames(const JsonDoc& merged)
    : modules_(merged.modules), module_of_file_(merged.module_of_file) {
    for (const NamedSection& section : kNamedSections) {
        const JsonNode* node = merged.root.find(section.key);
        if (node == nullptr) continue;
        for (const JsonMember& member : node->members) {
            declared_[static_cast<size_t>(section.kind)].insert(member.key);
            if (section.kind == NameKind::view)
                declared_[static_cast<size_t>(NameKind::value)].insert(member.key +
                                                                       std::string(kNumberOfViews));
        }
    }
    if (const JsonNode* imports = merged.root.find("imports"))
        for (const JsonMember& member : imports->members) imports_.insert(member.key);
    for (const ModuleInstance& module : modules_)
        if (!module.name.empty()) module_names_.insert(module.name);
}

bool ModuleNames::has(NameKind kind, std::string_view name) const {
    return declared_[static_cast<size_t>(kind)].contains(name);
}

uint32_t ModuleNames::module_at(SourceLoc place) const {
    return place.file < module_of_file_.size() ? module_of_file_[place.file] : 0;
}

uint32_t ModuleNames::child(uint32_t module, std::string_view name) const {
    const std::string full = name_in_group(modules_[module].name, name);
    const auto it = std::ranges::find(modules_, full, &ModuleInstance::name);
    return it == modules_.end() ? kNoModule : static_cast<uint32_t>(it - modules_.begin());
}

std::string ModuleNames::look_up(NameKind kind, uint32_t module, std::string_view name) const {
    if (const size_t end = name.find(kInGroup); end != std::string_view::npos)
        if (const uint32_t inner = child(module, name.substr(0, end)); inner != kNoModule)
            return look_up(kind, inner, name.substr(end + kInGroup.size()));
    if (module == 0) return std::string(name);
    const ModuleInstance& owner = modules_[module];
    if (const auto port = owner.with.find(std::string(name));
        port != owner.with.end() && kind != NameKind::pass)
        return look_up(kind, owner.parent, port->second.name);
    std::string full = name_in_group(owner.name, name);
    if (has(kind, full)) return full;
    if (kind == NameKind::value && name == kRenderSize) return look_up(kind, owner.parent, name);
    // The program may provide something with this name. All modules share such names, so they get no prefix.
    const bool is_shared =
        kind == NameKind::resource ? imports_.contains(name) : kind != NameKind::pass && !has(kind, name);
    return is_shared ? std::string(name) : full;
}

std::string ModuleNames::full_name(NameKind kind, std::string_view name, SourceLoc place) const {
    return look_up(kind, module_at(place), name);
}

std::string ModuleNames::import_name(std::string_view name, SourceLoc place) const {
    const ModuleInstance* module = &modules_[module_at(place)];
    std::string found(name);
    for (auto port = module->with.find(found); port != module->with.end(); port = module->with.find(found)) {
        found = port->second.name;
        module = &modules_[module->parent];
    }
    return found;
}

std::string_view ModuleNames::module_of(std::string_view full) const {
    for (size_t end = full.rfind(kInGroup); end != std::string_view::npos && end > 0;
         end = full.rfind(kInGroup, end - 1))
        if (module_names_.contains(full.substr(0, end))) return full.substr(0, end);
    return {};
}

std::string_view ModuleNames::own_part(std::string_view full) const {
    const std::string_view module = module_of(full);
    return module.empty() ? full : full.substr(module.size() + kInGroup.size());
}

std::string ModuleNames::target_value(const ModuleInstance& module, const PortTarget& target) const {
    return look_up(NameKind::value, module.parent, target.name);
}

bool ModuleNames::is_declared(uint32_t module, std::string_view name) const {
    if (name == "output" || name == "camera" || imports_.contains(name)) return true;
    for (const NameKind kind : {NameKind::value, NameKind::resource, NameKind::view})
        if (has(kind, look_up(kind, module, name))) return true;
    return imports_.contains(look_up(NameKind::resource, module, name));
}

std::optional<NameKind> ModuleNames::kind_of(uint32_t module, std::string_view name, NameKind wanted) const {
    if (name == "output" || name == "camera") return std::nullopt;
    if (imports_.contains(look_up(NameKind::resource, module, name))) return std::nullopt;
    for (const NameKind kind : {wanted, NameKind::value, NameKind::resource, NameKind::view})
        if (has(kind, look_up(kind, module, name))) return kind;
    return std::nullopt;
}

Diagnostic ModuleNames::without_target(const JsonDoc& merged, uint32_t module, const std::string& port,
                                       const ModulePort& desc) const {
    const ModuleInstance& owner = modules_[module];
    Diagnostic d = merged.sources.error(owner.as_loc, "W240",
                                        "the port \"" + port + "\" of module \"" + owner.name +
                                            "\" has no target, and the module does not declare it");
    d.help.push_back("name a part of this graph for it: \"with\": { \"" + port + "\": \"…\" }" +
                     (desc.description.empty() ? "" : "; the port means: " + desc.description));
    if (desc.loc.file < merged.sources.files.size())
        d.notes.push_back({merged.sources.files[desc.loc.file].path, desc.loc.line, desc.loc.column,
                           "the port is listed here"});
    return d;
}

Diagnostic ModuleNames::unknown_target(const JsonDoc& merged, uint32_t module,
                                       const PortTarget& target) const {
    std::vector<std::string> known(imports_.begin(), imports_.end());
    for (const NameKind kind : {NameKind::value, NameKind::resource, NameKind::view})
        for (const std::string& name : declared_[static_cast<size_t>(kind)])
            if (module_of(name) == modules_[module].name) known.emplace_back(own_part(name));
    Diagnostic d = merged.sources.error(
        target.loc, "W240", "the file that includes the module has no \"" + target.name + "\" for this port");
    if (!target.name.empty() && target.name.find_first_not_of("+-.0123456789") == std::string::npos) {
        d.help.emplace_back(kNumberHelp);
        return d;
    }
    const std::string near = did_you_mean_text(target.name, known);
    d.help.push_back(near.empty() ? "name a resource, import, parameter, constant, size or list of views"
                                  : near);
    return d;
}

void ModuleNames::check(const JsonDoc& merged, Diagnostics& errors) const {
    const JsonNode* groups = merged.root.find("groups");
    for (uint32_t module = 1; module < modules_.size(); ++module) {
        const ModuleInstance& owner = modules_[module];
        if (groups != nullptr && groups->find(owner.name) != nullptr) {
            errors.push_back(merged.sources.error(
                owner.as_loc, "W239", "the name \"" + owner.name + "\" is already the name of a group"));
            errors.back().help.emplace_back("choose another name for the module");
        }
        for (const auto& [port, desc] : owner.ports) {
            const auto target = owner.with.find(port);
            if (target == owner.with.end()) {
                if (!is_declared(module, port)) errors.push_back(without_target(merged, module, port, desc));
            } else if (!is_declared(owner.parent, target->second.name)) {
                errors.push_back(unknown_target(merged, owner.parent, target->second));
            }
        }
    }
}

}  // namespace weft
