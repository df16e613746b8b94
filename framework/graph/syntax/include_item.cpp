#include "graph/syntax/include_item.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include "graph/diagnostics/quoted_list.h"

namespace weft {
namespace {

bool is_name(std::string_view text) {
    const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
           std::ranges::all_of(text, fits);
}

class ItemReader {
 public:
    ItemReader(const SourceMap& sources, Diagnostics& errors) : sources_(sources), errors_(errors) {}

    std::optional<IncludeItem> read(const JsonNode& node) {
        const size_t before = errors_.size();
        IncludeItem item;
        if (node.kind == JsonKind::object)
            read_object(node, item);
        else
            read_file(node, item);
        if (errors_.size() > before) return std::nullopt;
        return item;
    }

    std::map<std::string, ModulePort> read_ports(const JsonNode& node) {
        std::map<std::string, ModulePort> ports;
        if (node.kind != JsonKind::array && node.kind != JsonKind::object)
            wrong_type(node, "a list of names", "write [\"depth\"], or { \"depth\": \"a description\" }");
        for (const JsonNode& item : node.items)
            if (expect_string(item, "a name")) add_port(item.string, {{}, item.loc}, ports);
        for (const JsonMember& member : node.members)
            if (expect_string(member.value, "a description in a string"))
                add_port(member.key, {member.value.string, member.key_loc}, ports);
        return ports;
    }

 private:
    void fail(SourceLoc loc, std::string code, std::string message, std::string help) {
        errors_.push_back(sources_.error(loc, std::move(code), std::move(message)));
        errors_.back().help.push_back(std::move(help));
    }

    void wrong_type(const JsonNode& node, const std::string& wanted, std::string help) {
        fail(node.loc, "W102", std::string("found ") + json_kind_name(node.kind) + ", wanted " + wanted,
             std::move(help));
    }

    bool expect_string(const JsonNode& node, const std::string& wanted) {
        if (node.kind == JsonKind::string) return true;
        wrong_type(node, wanted, "write it in double quotes");
        return false;
    }

    void add_port(const std::string& name, ModulePort port, std::map<std::string, ModulePort>& ports) {
        if (is_name(name))
            ports.emplace(name, std::move(port));
        else
            fail(port.loc, "W109", "\"" + name + "\" is not a valid name for a port",
                 "use only letters, digits and _, and begin with a letter or _");
    }

    void read_object(const JsonNode& node, IncludeItem& item) {
        for (const JsonMember& member : node.members) {
            if (member.key == "file")
                read_file(member.value, item);
            else if (member.key == "as")
                read_as(member.value, item);
            else if (member.key == "with")
                read_with(member.value, item);
            else
                unknown_key(member);
        }
        for (const char* key : {"file", "as"})
            if (node.find(key) == nullptr)
                fail(node.loc, "W108", std::string("an include needs the key \"") + key + "\"",
                     "write { \"file\": \"modules/file.json\", \"as\": \"name\" }, or only the name of the "
                     "file in double quotes");
    }

    void unknown_key(const JsonMember& member) {
        const std::string near = did_you_mean_text(member.key, include_keys());
        fail(member.key_loc, "W101", "unknown key \"" + member.key + "\" in an include",
             near.empty() ? "allowed keys are " + quoted_list(include_keys()) : near);
    }

    void read_file(const JsonNode& node, IncludeItem& item) {
        if (node.kind != JsonKind::string)
            return wrong_type(node, "the name of a file", "write the name of the file in double quotes");
        const std::filesystem::path name(node.string);
        const bool climbs = std::ranges::find(name, "..") != name.end();
        if (node.string.empty() || !name.is_relative() || climbs)
            return fail(node.loc, "W126",
                        "\"" + node.string + "\" is not a path inside the folder of the graph",
                        "write a path without \"..\", relative to the folder of this file, to a folder of "
                        "--graph-path or to the shipped graphs folder");
        item.file = node.string;
        item.loc = node.loc;
    }

    void read_as(const JsonNode& node, IncludeItem& item) {
        if (!expect_string(node, "a name for the module")) return;
        item.as = node.string;
        item.as_loc = node.loc;
        if (!is_name(item.as))
            fail(node.loc, "W239", "\"" + node.string + "\" is not a valid name for a module",
                 "use only letters, digits and _, and begin with a letter or _");
    }

    void read_with(const JsonNode& node, IncludeItem& item) {
        if (node.kind != JsonKind::object)
            return wrong_type(node, "an object", "write { \"name of the port\": \"name in this graph\" }");
        for (const JsonMember& member : node.members)
            if (member.value.kind == JsonKind::number)
                wrong_type(member.value, "the name of a part of this graph", kNumberHelp);
            else if (expect_string(member.value, "the name of a part of this graph"))
                item.with[member.key] = {member.value.string, member.key_loc, member.value.loc};
    }

    const SourceMap& sources_;
    Diagnostics& errors_;
};

}  // namespace

const std::vector<std::string>& include_keys() {
    static const std::vector<std::string> keys{"file", "as", "with"};
    return keys;
}

std::optional<IncludeItem> read_include_item(const JsonNode& item, const SourceMap& sources,
                                             Diagnostics& errors) {
    return ItemReader(sources, errors).read(item);
}

std::map<std::string, ModulePort> read_module_ports(const JsonNode& root, const SourceMap& sources,
                                                    Diagnostics& errors) {
    const JsonNode* ports = root.find("ports");
    if (ports == nullptr) return {};
    return ItemReader(sources, errors).read_ports(*ports);
}

}  // namespace weft
