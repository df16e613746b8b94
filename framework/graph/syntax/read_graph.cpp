// Reads a graph file and all files that it includes, depth first and each file once. When the files are
// merged, files included later override files included earlier.
#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "graph/diagnostics/quantity_text.h"
#include "graph/syntax/contained_file.h"
#include "graph/syntax/read_graph.h"
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

class IncludeReader {
 public:
    IncludeReader(JsonDoc& doc, const FileReader& reader, const GraphReading& reading)
        : doc_(doc), reader_(reader), reading_(reading) {
        bytes_ = doc.sources.files.front().text.size();
        values_ = count_values(doc.root);
        open_.push_back(0);
        const std::filesystem::path graph(doc.sources.files.front().path);
        folders_ = {real_folder(graph.parent_path()), reading.include_root.empty()
                                                          ? std::filesystem::path()
                                                          : real_folder(reading.include_root)};
    }

    void follow(const JsonNode& file_root) {
        const JsonNode* list = file_root.find("include");
        if (!list) return;
        if (list->kind != JsonKind::array)
            return fail(list->loc, "W102",
                        std::string("found ") + json_kind_name(list->kind) + ", wanted a list of files",
                        "write [\"modules/file.json\"]");
        for (const JsonNode& item : list->items) {
            if (!errors_.empty() && errors_.back().code == "W004") return;
            if (is_good_name(item)) include(item);
        }
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

    bool is_good_name(const JsonNode& item) {
        if (item.kind != JsonKind::string) {
            fail(item.loc, "W102",
                 std::string("found ") + json_kind_name(item.kind) + ", wanted the name of a file",
                 "write the name of the file in double quotes");
            return false;
        }
        const std::filesystem::path name(item.string);
        const bool climbs = std::ranges::find(name, "..") != name.end();
        if (!item.string.empty() && name.is_relative() && !climbs) return true;
        fail(item.loc, "W126", "\"" + item.string + "\" is not a path inside the folder of the graph",
             "write a path without \"..\", relative to the folder of this file or to the shipped graphs "
             "folder");
        return false;
    }

    // Returns the paths at which an included file may be, in the order of the search: beside the including
    // file, then in the folder of shipped graphs.
    [[nodiscard]] std::vector<std::string> candidates(const std::string& name) const {
        const std::filesystem::path includer(doc_.sources.files[open_.back()].path);
        std::vector<std::string> paths{(includer.parent_path() / name).lexically_normal().generic_string()};
        if (!reading_.include_root.empty())
            paths.push_back(
                (std::filesystem::path(reading_.include_root) / name).lexically_normal().generic_string());
        return paths;
    }

    void include(const JsonNode& item) {
        const std::vector<std::string> paths = candidates(item.string);
        const std::vector<SourceFile>& files = doc_.sources.files;
        for (const std::string& path : paths) {
            const auto known = std::ranges::find(files, path, &SourceFile::path);
            if (known != files.end()) return check_circle(item, static_cast<uint32_t>(known - files.begin()));
            // The path may name no file on disk: `reader` can also provide files from memory. So only
            // existing files are checked for links.
            const RealFile real = find_real_file(path, folders_);
            if (!real.path.empty() && !real.is_inside)
                return fail(
                    item.loc, "W126",
                    "\"" + item.string + "\" is a symbolic link that leads out of the folder of the graph",
                    "replace the link by a copy of the file");
            std::optional<std::string> text = reader_(path);
            if (text) return read(item, path, std::move(*text));
        }
        std::string places;
        for (const std::string& path : paths) places += (places.empty() ? "\"" : " and \"") + path + "\"";
        fail(item.loc, "W126", "the file \"" + item.string + "\" does not exist or cannot be read",
             "correct the name; Weft looked for " + places);
    }

    void check_circle(const JsonNode& item, uint32_t file) {
        const auto first = std::ranges::find(open_, file);
        // The file was read before, but it is not in the chain of open includes. Such a repeated include is
        // allowed; the file is not read again.
        if (first == open_.end()) return;
        std::string chain;
        for (auto it = first; it != open_.end(); ++it) chain += doc_.sources.files[*it].path + " -> ";
        fail(item.loc, "W127", "files include each other: " + chain + doc_.sources.files[file].path,
             "remove one of these includes");
    }

    void read(const JsonNode& item, const std::string& path, std::string text) {
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
        if (!root) {
            const Diagnostics& faults = root.errors();
            errors_.insert(errors_.end(), faults.begin(), faults.end());
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

    JsonDoc& doc_;
    const FileReader& reader_;
    const GraphReading& reading_;
    // Indices into SourceMap::files of the files that are being read: each file includes the next one.
    std::vector<uint32_t> open_;
    // Folders that included files must lie in, after resolving symbolic links: the graph's folder and the
    // include root.
    std::array<std::filesystem::path, 2> folders_;
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
    Diagnostics errors = includes.take_errors();
    if (!errors.empty()) return errors;
    return doc;
}

}  // namespace weft
