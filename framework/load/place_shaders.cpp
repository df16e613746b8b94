#include "load/place_shaders.h"

#include <algorithm>
#include <map>
#include <string>
#include <system_error>
#include <vector>

namespace weft {
namespace {

namespace fs = std::filesystem;

fs::path normal(const fs::path& folder) {
    const fs::path path = folder.lexically_normal();
    return path == "." ? fs::path() : path;
}

// Returns the path of `folder` relative to `base`; empty if it is not below `base`.
fs::path below(const fs::path& folder, const fs::path& base) {
    const fs::path relative = base.empty() && folder.is_relative() ? folder : folder.lexically_relative(base);
    const bool climbs = relative.empty() || relative == "." || *relative.begin() == "..";
    return climbs ? fs::path() : relative;
}

bool is_on_disk(const fs::path& path) {
    std::error_code failed;
    return fs::exists(path, failed);
}

// True for names that the shader compiler may open: without ".." and relative.
bool stays_inside(const fs::path& name) {
    return name.is_relative() && std::ranges::find(name, "..") == name.end();
}

class ShaderPlacer {
 public:
    ShaderPlacer(GraphDesc& graph, const LoadSettings& settings)
        : graph_(graph), settings_(settings), home_(folder_of(0)) {
        for (const fs::path& place : settings.graph_path) places_.push_back(normal(place));
        if (!settings.graph_root.empty()) places_.push_back(normal(settings.graph_root));
    }

    void run() {
        for (auto& [name, pass] : graph_.passes)
            if (!pass.shader.empty() && pass.shader_folder.empty()) place(pass);
    }

 private:
    [[nodiscard]] fs::path folder_of(uint32_t file) const {
        if (file >= graph_.sources.files.size()) return home_;
        return normal(fs::path(graph_.sources.files[file].path).parent_path());
    }

    void place(PassDesc& pass) {
        const fs::path folder = folder_of(pass.shader_loc.file);
        if (folder == home_ || !stays_inside(pass.shader)) return;
        pass.shader_folder = folder.generic_string();
        pass.shader_in_folder = pass.shader;
        if (is_beside(pass, folder)) pass.shader = (prefix(folder) / pass.shader).generic_string();
    }

    static bool is_beside(const PassDesc& pass, const fs::path& folder) {
        if (pass.type != "raster") return is_on_disk(folder / pass.shader);
        const fs::path stages = folder / pass.shader / fs::path(pass.shader).filename();
        return is_on_disk(stages.string() + ".vert") || is_on_disk(stages.string() + ".frag");
    }

    const fs::path& prefix(const fs::path& folder) {
        const auto [it, is_new] = prefixes_.try_emplace(folder);
        if (is_new) it->second = find_prefix(folder);
        return it->second;
    }

    // Returns the prefix for the shaders of a folder. If names of other shaders may already begin with this
    // prefix, the function returns the whole path of the folder instead. This case is rare.
    [[nodiscard]] fs::path find_prefix(const fs::path& folder) const {
        if (const fs::path inner = below(folder, home_); !inner.empty()) return inner;
        for (const fs::path& place : places_) {
            const fs::path found = folder == place ? place.filename() : below(folder, place);
            if (found.empty()) continue;
            const auto has_prefix = [&](const auto& known) { return known.second == found; };
            const bool is_taken = is_on_disk(home_ / found) || is_on_disk(settings_.shader_root / found) ||
                                  std::ranges::any_of(prefixes_, has_prefix);
            return is_taken ? folder : found;
        }
        return folder;
    }

    GraphDesc& graph_;
    const LoadSettings& settings_;
    fs::path home_;  // The folder of the graph.
    std::vector<fs::path> places_;
    std::map<fs::path, fs::path> prefixes_;
};

}  // namespace

void place_shaders(GraphDesc& graph, const LoadSettings& settings) {
    if (graph.sources.files.size() > 1) ShaderPlacer(graph, settings).run();
}

}  // namespace weft
