// Reads a graph file and all files that it includes, depth first. Each file is read once for the graph, and
// once for each instance of a module that it belongs to. When the files are merged, files included later
// override files included earlier.
#include <algorithm>
#include <filesystem>
#include <set>

#include "graph/diagnostics/quantity_text.h"
#include "graph/diagnostics/quoted_list.h"
#include "graph/syntax/contained_file.h"
#include "graph/syntax/include_item.h"
#include "graph/syntax/read_graph.h"
#include "graph/syntax/reference_name.h"
#include "weft/syntax/json_doc.h"

namespace weft {
namespace {

// Returns the number of JSON values in a tree. The recursion is not too deep, because the JSON reader limits
// the nesting.
uint64_t count_values(const JsonNode& node) {
    uint64_t count = 1;
    for (const JsonMember& member : node.members) count += count_values(member.value);
    for (const JsonNode& item : node.items) count += count_values(item);
    return count;
}

bool is_same_fault(const Diagnostic& a, const Diagnostic& b) {
    return a.code == b.code && a.file == b.file && a.line == b.line && a.column == b.column;
}

class IncludeReader {
 public:
    IncludeReader(JsonDoc& doc, const FileReader& reader, const GraphReading& reading)
        : doc_(doc), reader_(reader), reading_(reading) {
        bytes_ = doc.sources.files.front().text.size();
        values_ = count_values(doc.root);
        open_.push_back(0);
        doc.modules.emplace_back();
        doc.module_of_file.push_back(0);
        places_.assign(reading.graph_path.begin(), reading.graph_path.end());
        if (!reading.include_root.empty()) places_.emplace_back(reading.include_root);
        const std::filesystem::path graph(doc.sources.files.front().path);
        folders_.push_back(real_folder(graph.parent_path()));
        for (const std::filesystem::path& place : places_) folders_.push_back(real_folder(place));
        real_paths_.push_back(real_path(graph.string()));
    }

    void follow(const JsonNode& file_root) {
        doc_.modules[module()].ports.merge(read_module_ports(file_root, doc_.sources, errors_));
        const JsonNode* list = file_root.find("include");
        if (!list) return;
        if (list->kind != JsonKind::array)
            return fail(list->loc, "W102",
                        std::string("found ") + json_kind_name(list->kind) + ", wanted a list of files",
                        "write [\"modules/file.json\"]");
        for (const JsonNode& item : list->items) {
            if (!errors_.empty() && errors_.back().code == "W004") return;
            if (const std::optional<IncludeItem> wanted = read_include_item(item, doc_.sources, errors_))
                include(*wanted);
        }
    }

    // Checks that "with" names only ports. Call it after all files were read.
    void check_ports() {
        if (!errors_.empty()) return;
        for (const ModuleInstance& module : doc_.modules)
            for (const auto& [port, target] : module.with)
                if (!module.ports.contains(port)) report_unknown_port(module, port, target);
        // If no file was included as a module, these lists become empty. Then no later stage looks up names
        // in modules.
        if (doc_.modules.size() > 1) return;
        doc_.modules.clear();
        doc_.module_of_file.clear();
    }

    // Checks the number of tiers and the limit graph.jsonValues. The values of all files count once for each
    // tier, and once for the graph without a tier, because each of these is merged and parsed separately.
    void check_tiers() {
        std::set<std::string_view> names;
        for (const IncludedJson& included : doc_.included) check_tiers(included.root, names);
        check_tiers(doc_.root, names);
    }

    Diagnostics take_errors() { return std::move(errors_); }

 private:
    void check_tiers(const JsonNode& root, std::set<std::string_view>& names) {
        const JsonNode* tiers = root.find("tiers");
        if (tiers == nullptr || !errors_.empty()) return;
        const GraphLimits& limits = reading_.limits;
        for (const JsonMember& tier : tiers->members) {
            names.insert(tier.key);
            if (names.size() > limits.tiers)
                return fail(tier.key_loc, "W004",
                            "the graph has more than " + std::to_string(limits.tiers) + " tiers",
                            "use parameters instead of some tiers, " + raise_limit_text("graph.tiers"));
            if (values_ * (names.size() + 1) > limits.json_values)
                return fail(tier.key_loc, "W004",
                            "the files contain " + std::to_string(values_) +
                                " values, and all values are counted once more for each tier: with " +
                                std::to_string(names.size()) + " tiers this is more than " +
                                std::to_string(limits.json_values),
                            "use fewer tiers, " + raise_limit_text("graph.jsonValues"));
        }
    }

    void fail(SourceLoc loc, std::string code, std::string message, std::string help) {
        errors_.push_back(doc_.sources.error(loc, std::move(code), std::move(message)));
        errors_.back().help.push_back(std::move(help));
    }

    // Returns the instance to which the file that is being read belongs.
    [[nodiscard]] uint32_t module() const { return doc_.module_of_file[open_.back()]; }

    void report_unknown_port(const ModuleInstance& module, const std::string& port,
                             const PortTarget& target) {
        const std::string& file = doc_.sources.files[module.file].path;
        std::vector<std::string> ports;
        for (const auto& [name, unused] : module.ports) ports.push_back(name);
        const std::string near = did_you_mean_text(port, ports);
        fail(target.port_loc, "W238", "\"" + file + "\" has no port \"" + port + "\"",
             ports.empty()
                 ? "the file has no ports: list the name in its section \"ports\", or remove it here"
                 : (near.empty() ? "" : near + "; ") + "the ports are " + quoted_list(ports));
    }

    // Returns the paths at which an included file may be, in the order of the search: beside the including
    // file, in the folders of the graph path, then in the folder of shipped graphs.
    [[nodiscard]] std::vector<std::string> candidates(const std::string& name) const {
        const std::filesystem::path includer(doc_.sources.files[open_.back()].path);
        std::vector<std::string> paths{(includer.parent_path() / name).lexically_normal().generic_string()};
        for (const std::filesystem::path& place : places_)
            paths.push_back((place / name).lexically_normal().generic_string());
        return paths;
    }

    [[nodiscard]] std::optional<uint32_t> find_module(const std::string& name) const {
        const auto it = std::ranges::find(doc_.modules, name, &ModuleInstance::name);
        if (it == doc_.modules.end()) return std::nullopt;
        return static_cast<uint32_t>(it - doc_.modules.begin());
    }

    // Returns true if the file was already read for the same module. This is the module instance named by the
    // item's "as" or, without "as", the module (or the graph) whose file is being read.
    [[nodiscard]] bool is_known(const IncludeItem& item, std::optional<uint32_t> instance,
                                const std::string& path) const {
        const std::filesystem::path real = real_path(path);
        if (!item.as.empty()) return instance && real_paths_[doc_.modules[*instance].file] == real;
        for (size_t i = 0; i < real_paths_.size(); ++i)
            if (real_paths_[i] == real && doc_.module_of_file[i] == module()) return true;
        return false;
    }

    // Returns the path without symbolic links. A file can be found by several paths, for example by a
    // relative and by an absolute one. A file that is not on disk has only one path.
    [[nodiscard]] std::filesystem::path real_path(const std::string& path) const {
        const RealFile real = find_real_file(path, folders_);
        return real.path.empty() ? std::filesystem::path(path) : real.path;
    }

    // Returns true if neither the file nor its folder is a link that leads out of the allowed folders. The
    // path may name no file on disk: `reader` can also provide files from memory.
    [[nodiscard]] bool is_inside(const std::string& path) const {
        const RealFile real = find_real_file(path, folders_);
        if (real.path.empty()) return true;
        const std::filesystem::path folder = real_folder(std::filesystem::path(path).parent_path());
        return real.is_inside && std::ranges::any_of(folders_, [&](const std::filesystem::path& allowed) {
                   return folder == allowed || lies_below(folder, allowed);
               });
    }

    void include(const IncludeItem& item) {
        const std::vector<std::string> paths = candidates(item.file);
        const std::optional<uint32_t> instance =
            item.as.empty() ? std::nullopt : find_module(name_in_group(doc_.modules[module()].name, item.as));
        for (const std::string& path : paths) {
            if (is_circle(item, path)) return;
            if (is_known(item, instance, path)) return check_same(item, instance);
            if (!is_inside(path))
                return fail(
                    item.loc, "W126",
                    "\"" + item.file + "\" is a symbolic link that leads out of the folder of the graph",
                    "replace the link by a copy of the file");
            std::optional<std::string> text = reader_(path);
            if (!text) continue;
            if (instance) return report_same_name(item, *instance);
            return read(item, path, std::move(*text));
        }
        std::string places;
        for (const std::string& path : paths) places += (places.empty() ? "\"" : " and \"") + path + "\"";
        fail(item.loc, "W126", "the file \"" + item.file + "\" does not exist or cannot be read",
             "correct the name; Weft looked for " + places);
    }

    void report_same_name(const IncludeItem& item, uint32_t instance) {
        const ModuleInstance& other = doc_.modules[instance];
        fail(item.as_loc, "W239", "the name \"" + item.as + "\" already stands for another module",
             "choose another name");
        const SourceLoc first = other.as_loc;
        errors_.back().notes.push_back({doc_.sources.files[first.file].path, first.line, first.column,
                                        "\"" + doc_.sources.files[other.file].path + "\" has this name"});
    }

    // Two items with the same "as" must have the same "with"; if they do not, reports an error. `instance` is
    // the module that an earlier item with this "as" made; nullopt if there is none.
    void check_same(const IncludeItem& item, std::optional<uint32_t> instance) {
        if (!instance) return;
        const auto same = [](const auto& a, const auto& b) {
            return a.first == b.first && a.second.name == b.second.name;
        };
        const std::map<std::string, PortTarget>& with = doc_.modules[*instance].with;
        if (std::ranges::equal(with, item.with, same)) return;
        fail(item.as_loc, "W239", "the module \"" + item.as + "\" is included twice with different \"with\"",
             "write the same \"with\" at both places, or choose another name for one of the two");
        const SourceLoc first = doc_.modules[*instance].as_loc;
        errors_.back().notes.push_back(
            {doc_.sources.files[first.file].path, first.line, first.column, "first included here"});
    }

    // Reports an error and returns true if the file is being read at the moment, because the file would then
    // include itself. A file that has been read completely may be included again.
    bool is_circle(const IncludeItem& item, const std::string& path) {
        const std::vector<SourceFile>& files = doc_.sources.files;
        const std::filesystem::path real = real_path(path);
        const auto first =
            std::ranges::find_if(open_, [&](uint32_t file) { return real_paths_[file] == real; });
        if (first == open_.end()) return false;
        std::string chain;
        for (auto it = first; it != open_.end(); ++it) chain += files[*it].path + " -> ";
        fail(item.loc, "W127", "files include each other: " + chain + path, "remove one of these includes");
        return true;
    }

    void read(const IncludeItem& item, const std::string& path, std::string text) {
        const GraphLimits& limits = reading_.limits;
        if (doc_.sources.files.size() > limits.include_files)
            return fail(item.loc, "W004",
                        "the graph includes more than " + std::to_string(limits.include_files) + " files",
                        "include fewer files, " + raise_limit_text("graph.includeFiles"));
        bytes_ += text.size();
        if (bytes_ > limits.json_bytes)
            return fail(item.loc, "W004",
                        "the files together have more than " + limit_bytes_text(limits.json_bytes),
                        "check that \"" + path + "\" is a graph, " + raise_limit_text("graph.jsonBytes"));
        // read_json_file() appends the file to the list of files, so the file gets this index.
        const auto file = static_cast<uint32_t>(doc_.sources.files.size());
        Result<JsonNode> root = read_json_file(doc_.sources, path, std::move(text), limits, item.loc);
        doc_.module_of_file.push_back(begin_module(item, file));
        real_paths_.push_back(real_path(path));
        if (!root) {
            // If the file belongs to several instances, each of its errors is reported only once.
            for (const Diagnostic& fault : root.errors())
                if (std::ranges::none_of(errors_,
                                         [&](const Diagnostic& d) { return is_same_fault(d, fault); }))
                    errors_.push_back(fault);
            return;
        }
        values_ += count_values(*root);
        if (values_ > limits.json_values)
            return fail(
                item.loc, "W004",
                "the files together contain more than " + std::to_string(limits.json_values) + " values",
                "include fewer files, " + raise_limit_text("graph.jsonValues"));
        open_.push_back(file);
        follow(*root);
        open_.pop_back();
        doc_.included.push_back({file, std::move(*root)});
    }

    // Returns the module instance to which an included file belongs. If the item has "as", this is a new
    // instance, otherwise the instance of the including file.
    uint32_t begin_module(const IncludeItem& item, uint32_t file) {
        if (item.as.empty()) return module();
        const std::string name = name_in_group(doc_.modules[module()].name, item.as);
        doc_.modules.push_back({name, module(), file, item.as_loc, {}, item.with});
        return static_cast<uint32_t>(doc_.modules.size() - 1);
    }

    JsonDoc& doc_;
    const FileReader& reader_;
    const GraphReading& reading_;
    // Indices into SourceMap::files of the files that are being read: each file includes the next one.
    std::vector<uint32_t> open_;
    std::vector<std::filesystem::path> real_paths_;  // By index of SourceMap::files; see real_path().
    // Folders in which included files are searched after the folder of the including file.
    std::vector<std::filesystem::path> places_;
    // Folders that included files must lie in, after resolving symbolic links: the graph's folder and
    // `places_`.
    std::vector<std::filesystem::path> folders_;
    // Total size in bytes of all files read so far.
    uint64_t bytes_ = 0;
    uint64_t values_ = 0;
    Diagnostics errors_;
};

}  // namespace

Result<JsonDoc> read_graph(const std::string& path, const FileReader& reader, const GraphReading& reading) {
    Result<JsonDoc> doc = read_json(path, reader, reading.limits);
    if (!doc) return doc;
    IncludeReader includes(*doc, reader, reading);
    includes.follow(doc->root);
    includes.check_tiers();
    includes.check_ports();
    Diagnostics errors = includes.take_errors();
    if (!errors.empty()) return errors;
    return doc;
}

}  // namespace weft
