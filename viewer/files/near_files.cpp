#include "viewer/files/near_files.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/files/files.h"
#include "weft/scene/builtin_scenes.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;
// At most this number of files in a folder are compared with the misspelt name.
constexpr size_t kMostFiles = 4096;

// Returns the names of the files in `folder`, without the folder.
std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (; !error && entry != fs::directory_iterator() && names.size() < kMostFiles; entry.increment(error))
        names.push_back(entry->path().filename().string());
    return names;
}

std::string shown(const fs::path& path) {
    std::error_code error;
    const fs::path relative = fs::relative(path, fs::current_path(error), error);
    const bool is_below = !error && !relative.empty() && *relative.begin() != "..";
    return (is_below ? relative : path).string();
}

void add(std::vector<std::string>& all, std::string text) {
    if (std::ranges::find(all, text) == all.end()) all.push_back(std::move(text));
}

// Adds shipped graphs with a similar name. Only the name without folder and extension is compared, so that
// "deferred" finds "graphs/deferred.json".
void add_shipped_graphs(const fs::path& path, std::vector<std::string>& near) {
    const fs::path folder = shipped_root() / "graphs";
    std::vector<std::string> stems;
    for (const std::string& name : names_in(folder))
        if (name.ends_with(".json") && !name.ends_with(".schema.json"))
            stems.push_back(fs::path(name).stem().string());
    for (const std::string& stem : did_you_mean(path.stem().string(), stems))
        add(near, shown(folder / (stem + ".json")));
}

}  // namespace

void add_near_files(Diagnostic& error) {
    const bool is_graph = error.code == "W002", is_scene = error.code == "S101";
    std::error_code ignored;
    const fs::path path = error.file;
    if ((!is_graph && !is_scene && error.code != "X530") || error.line > 0 ||
        fs::exists(fs::symlink_status(path, ignored)))
        return;
    std::vector<std::string> near;
    const fs::path folder = path.parent_path();
    for (const std::string& name : did_you_mean(path.filename().string(), names_in(folder)))
        add(near, (folder / name).string());
    if (is_graph && folder.empty()) add_shipped_graphs(path, near);
    if (is_scene)
        for (const std::string& name : did_you_mean(path.string(), scene::builtin_scene_names()))
            add(near, "builtin:" + name);
    if (near.empty()) return;
    std::string text = "did you mean ";
    for (size_t i = 0; i < near.size(); ++i) text += (i > 0 ? " or \"" : "\"") + near[i] + "\"";
    error.help.insert(error.help.begin(), text + "?");
}

}  // namespace weft::viewer
