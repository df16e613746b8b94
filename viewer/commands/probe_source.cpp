#include "viewer/commands/probe_source.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "viewer/files/files.h"
#include "viewer/output/progress_text.h"
#include "weft/scene/place_probes.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;

// Returns the path of the scene file without its extension. If `scene` is a folder, the scene file is the
// .gltf or .glb file in it; without such a file, the function returns an empty path.
fs::path stem_of_scene(const std::string& scene) {
    std::error_code failed;
    if (!fs::is_directory(scene, failed)) return fs::path(scene).replace_extension();
    for (fs::directory_iterator it(scene, failed), end; !failed && it != end; it.increment(failed)) {
        const fs::path extension = it->path().extension();
        if (extension == ".gltf" || extension == ".glb") return fs::path(it->path()).replace_extension();
    }
    return {};
}

// Returns the file with the probes of the scene; empty if there is none. A symbolic link does not count,
// because it can lead out of the folder of the scene.
std::string file_beside(const std::string& scene) {
    if (scene.starts_with("builtin:")) return {};
    fs::path file = stem_of_scene(scene);
    if (file.empty()) return {};
    file += ".probes.json";
    std::error_code failed;
    return fs::is_regular_file(fs::symlink_status(file, failed)) ? file.string() : std::string();
}

}  // namespace

Result<FoundProbes> find_probes(const scene::Scene& scene, const ProbeChoice& choice, const Limits& limits) {
    FoundProbes found;
    found.source = choice.probes.empty() ? file_beside(choice.scene) : choice.probes;
    if (found.source.empty()) found.source = "auto";
    if (found.source == "none") return found;
    const auto begin = std::chrono::steady_clock::now();
    ProgressText text("placing probes", isatty(STDERR_FILENO) == 1);
    scene::LoadOptions options;
    options.progress = [&](const scene::LoadProgress& now) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        std::fputs(text.at(elapsed.count(), now.what, now.done, now.total).c_str(), stderr);
    };
    scene::PlacementParams params;
    params.camera = choice.camera;
    Result<scene::Probes> probes =
        found.source == "auto" ? scene::place_probes(scene, params, limits.scene, options)
                               : scene::read_probes(found.source, reader_up_to(limits.graph.json_bytes),
                                                    scene, limits.scene, options);
    std::fputs(text.finish().c_str(), stderr);
    if (!probes) return probes.take_errors();
    found.probes = std::move(*probes);
    return found;
}

}  // namespace weft::viewer
