// `weft scene`: describes a scene and its light probes, draws where the probes stand, and writes the scene
// for other programs.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "file/write_file.h"
#include "graph/diagnostics/quantity_text.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/probe_source.h"
#include "viewer/commands/scene_source.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "viewer/pictures/image_file.h"
#include "viewer/pictures/probe_picture.h"
#include "weft/scene/encode_glb.h"
#include "weft/scene/place_probes.h"

namespace weft::viewer {
namespace {

std::string place_text(const glm::vec3& p) {
    return number_text(double{p.x}) + ", " + number_text(double{p.y}) + ", " + number_text(double{p.z});
}

std::string scene_text(const scene::Scene& scene) {
    uint64_t triangles = 0;
    for (const scene::Instance& instance : scene.instances)
        triangles += scene.meshes[instance.mesh].indices.size() / 3;
    return "scene \"" + scene.name + "\"\n  " + count_text(scene.instances.size(), "instance") + " of " +
           std::to_string(scene.meshes.size()) + (scene.meshes.size() == 1 ? " mesh, " : " meshes, ") +
           count_text(triangles, "triangle") + ", " + count_text(scene.materials.size(), "material") + ", " +
           count_text(scene.lights.size(), "light") + ", " + count_text(scene.cameras.size(), "camera") +
           "\n  bounds " + place_text(scene.bounds.min) + " to " + place_text(scene.bounds.max) + " m\n";
}

std::string volume_text(const scene::ProbeVolume& volume) {
    using scene::ProbeState;
    const uint32_t kept = count_of(volume, ProbeState::kept), moved = count_of(volume, ProbeState::moved);
    std::string text = "  irradiance: " + count_text(kept + moved, "probe") + ", of these " +
                       std::to_string(moved) + " moved; " +
                       count_text(count_of(volume, ProbeState::dropped), "grid point") + " dropped\n";
    const std::vector<scene::ProbeCell> cells = cells_of(volume);
    for (uint32_t level = 0; level < volume.strides.size(); ++level) {
        const auto count = std::ranges::count(cells, level, &scene::ProbeCell::level);
        text += "    level " + std::to_string(level) + ": spacing " +
                number_text(double{volume.spacing_m} * volume.strides[level]) + " m, " +
                count_text(static_cast<size_t>(count), "cell") + "\n";
    }
    if (volume.around_camera) text += "    the scene is large: the levels surround the camera\n";
    return text;
}

std::string probes_text(const FoundProbes& found) {
    if (found.source == "none") return "probes: none\n";
    const scene::ProbeMemory memory = memory_of(found.probes);
    std::string text =
        found.source == "auto" ? "probes, placed automatically\n" : "probes from " + found.source + "\n";
    text += volume_text(found.probes.volume) +
            "  reflection: " + count_text(found.probes.reflections.size(), "probe") + "\n";
    for (const scene::ReflectionProbe& probe : found.probes.reflections) {
        text += "    " + probe.name + " at " + place_text(probe.position);
        if (probe.box) text += ", box of " + place_text(probe.box->half_size_m * 2.0f) + " m";
        text += "\n";
    }
    return text + "  memory on the GPU: " + bytes_text(memory.volume_bytes) + " for irradiance, " +
           bytes_text(memory.reflection_bytes) + " for reflections\n";
}

ExitCode write_probe_picture(const std::string& path, const scene::Scene& scene,
                             const scene::Probes& probes) {
    const ProbePicture picture = draw_probes(scene, probes);
    const Status written =
        write_png(path, picture.width_px, picture.height_px, std::as_bytes(std::span(picture.rgba)));
    if (written) return ExitCode::ok;
    report(written.errors());
    return exit_code_for(written.errors());
}

// Returns true if the path is empty or names a PNG. Otherwise prints a message.
bool names_png(const std::string& path) {
    if (path.empty()) return true;
    const Result<ImageFileKind> kind = image_file_kind(path);
    if (kind && *kind == ImageFileKind::png) return true;
    std::fputs("weft: --output: the picture of the probes is a .png file; give a name that ends in .png\n",
               stderr);
    return false;
}

// Returns true if the path is empty, ends in `extension`, or has no extension and is a pipe or a device.
// Otherwise prints a message. `what`: what the option writes.
bool has_extension(const char* option, const std::string& path, const char* extension, const char* what) {
    const std::string found = std::filesystem::path(path).extension().string();
    if (path.empty() || found == extension || (found.empty() && is_stream(path))) return true;
    std::fprintf(stderr, "weft: %s: %s is a %s file; give a name that ends in %s\n", option, what, extension,
                 extension);
    return false;
}

ExitCode end_with(const Diagnostics& errors) {
    report(errors);
    return exit_code_for(errors);
}

ExitCode write_scene(const std::string& path, const scene::Scene& scene) {
    const Result<std::string> file = scene::encode_glb(scene);
    return file ? output_data(path, *file) : end_with(file.errors());
}

ExitCode write_sky(const std::string& path, const scene::Scene& scene) {
    if (scene::has_sky(scene)) return output_data(path, scene::encode_sky(scene));
    std::fputs("weft: --sky: the scene has no sky\n", stderr);
    return ExitCode::usage;
}

// Writes the scene and the sky, if the options ask for them.
ExitCode write_for_other_programs(const SceneOptions& options, const scene::Scene& scene) {
    if (!options.gltf.empty())
        if (const ExitCode code = write_scene(options.gltf, scene); code != ExitCode::ok) return code;
    return options.sky.empty() ? ExitCode::ok : write_sky(options.sky, scene);
}

ExitCode check_options(const SceneOptions& options) {
    if (!names_png(options.picture) || !has_extension("--gltf", options.gltf, ".glb", "the scene") ||
        !has_extension("--sky", options.sky, ".hdr", "the picture of the sky"))
        return ExitCode::usage;
    return check_outputs({options.picture, options.gltf, options.sky}, {options.scene, options.probes});
}

}  // namespace

ExitCode run_scene(const SceneOptions& options) {
    if (const ExitCode code = check_options(options); code != ExitCode::ok) return code;
    if (const Status expected = expect_scene(options.scene); !expected) return end_with(expected.errors());
    SceneChoice choice;
    choice.name = options.scene;
    choice.hour = options.hour;
    Diagnostics warnings;
    const Result<scene::Scene> scene = open_scene(choice, options.limits.scene, warnings);
    report(warnings);
    if (!scene) return end_with(scene.errors());
    if (const ExitCode code = write_for_other_programs(options, *scene); code != ExitCode::ok) return code;
    const Result<scene::Camera> camera = choose_camera(*scene, {options.scene, options.camera, 1});
    if (!camera) return end_with(camera.errors());
    const Result<FoundProbes> found =
        find_probes(*scene, {options.scene, options.probes, glm::vec3(camera->transform[3])}, options.limits);
    if (!found) return end_with(found.errors());
    if (!options.picture.empty()) {
        if (const ExitCode code = write_probe_picture(options.picture, *scene, found->probes);
            code != ExitCode::ok)
            return code;
    }
    return print_data(options.json ? probes_to_json(found->probes)
                                   : scene_text(*scene) + probes_text(*found));
}

}  // namespace weft::viewer
