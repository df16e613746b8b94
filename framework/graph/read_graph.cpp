// A graph's file and those that it includes, depth first, each of them once: what is included first lies
// lowest when they are merged.
#include <algorithm>
#include <filesystem>

#include "graph/json_doc.h"
#include "graph/quantity_text.h"
#include "graph/stages.h"

namespace weft {
namespace {

class IncludeReader {
 public:
    IncludeReader(JsonDoc& doc, const FileReader& reader, const GraphReading& reading)
        : doc_(doc), reader_(reader), reading_(reading) {
        bytes_ = doc.sources.files.front().text.size();
        open_.push_back(0);
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

    Diagnostics take_errors() { return std::move(errors_); }

 private:
    void fail(SourceLoc loc, std::string code, std::string message, std::string help) {
        errors_.push_back(doc_.sources.error(loc, std::move(code), std::move(message)));
        errors_.back().help.push_back(std::move(help));
    }

    bool is_good_name(const JsonNode& item) {
        if (item.kind != JsonKind::string) {
            fail(item.loc, "W102",
                 std::string("found ") + json_kind_name(item.kind) + ", wanted the name of a file",
                 "write it in double quotes");
            return false;
        }
        const std::filesystem::path name(item.string);
        const bool climbs = std::ranges::find(name, "..") != name.end();
        if (!item.string.empty() && name.is_relative() && !climbs) return true;
        fail(item.loc, "W126", "\"" + item.string + "\" is not a file below the graph's folder",
             "write a relative path without \"..\", of a file beside this one or in the shipped graphs "
             "folder");
        return false;
    }

    // Where it may lie: beside the file that names it, then among the shipped graphs.
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
            std::optional<std::string> text = reader_(path);
            if (text) return read(item, path, std::move(*text));
        }
        std::string places;
        for (const std::string& path : paths) places += (places.empty() ? "\"" : " and \"") + path + "\"";
        fail(item.loc, "W126", "there is no readable file \"" + item.string + "\"",
             "looked for " + places + ": correct the name");
    }

    void check_circle(const JsonNode& item, uint32_t file) {
        const auto first = std::ranges::find(open_, file);
        if (first == open_.end()) return;  // here already by another way
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
                        "include fewer, " + raise_limit_text("graph.includeFiles"));
        bytes_ += text.size();
        if (bytes_ > limits.json_bytes)
            return fail(item.loc, "W004",
                        "the files have more than " + limit_bytes_text(limits.json_bytes) + " together",
                        "check that \"" + path + "\" is a graph, " + raise_limit_text("graph.jsonBytes"));
        const auto file = static_cast<uint32_t>(doc_.sources.files.size());
        Result<JsonNode> root = read_json_file(doc_.sources, path, std::move(text), limits, item.loc);
        if (!root) {
            const Diagnostics& faults = root.errors();
            errors_.insert(errors_.end(), faults.begin(), faults.end());
            return;
        }
        open_.push_back(file);
        follow(*root);
        open_.pop_back();
        doc_.included.push_back({file, std::move(*root)});
    }

    JsonDoc& doc_;
    const FileReader& reader_;
    const GraphReading& reading_;
    std::vector<uint32_t> open_;  // the files on the way to the current one
    uint64_t bytes_ = 0;          // of all files
    Diagnostics errors_;
};

}  // namespace

Result<JsonDoc> read_graph(const std::string& path, const FileReader& reader, const GraphReading& reading) {
    Result<JsonDoc> doc = read_json(path, reader, reading.limits);
    if (!doc) return doc;
    IncludeReader includes(*doc, reader, reading);
    includes.follow(doc->root);
    Diagnostics errors = includes.take_errors();
    if (!errors.empty()) return errors;
    return doc;
}

}  // namespace weft
