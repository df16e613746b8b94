#include "weft/scene/load_gltf.h"

#include <algorithm>
#include <new>
#include <system_error>

#include "scene/gltf/accessor_reader.h"
#include "scene/gltf/alpha_settle.h"
#include "scene/gltf/gltf_check.h"
#include "scene/gltf/gltf_container.h"
#include "scene/gltf/gltf_resources.h"
#include "scene/gltf/mesh_build.h"
#include "scene/gltf/node_walk.h"
#include "scene/gltf/parse/parse_document.h"
#include "scene/gltf/texture_build.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "scene/loading/rooted_folder.h"

namespace weft::scene {
namespace {

namespace fs = std::filesystem;

bool is_gltf_name(const fs::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".gltf" || extension == ".glb";
}

// Returns `path` if it is a file. If it is a folder, returns the only glTF file in the folder. The result is
// empty after an error was reported.
fs::path find_file(const fs::path& path, gltf::Report& report) {
    std::error_code failed;
    if (!fs::is_directory(path, failed)) {
        if (fs::exists(path, failed)) return path;
        report.error(
            "S101", {}, "there is no file or folder \"" + path.string() + "\"",
            "check the path: name a .gltf or .glb file, a folder that contains one, or builtin:NAME");
        return {};
    }
    std::vector<fs::path> found;
    for (fs::directory_iterator it(path, failed), end; !failed && it != end; it.increment(failed)) {
        if (is_gltf_name(it->path())) found.push_back(it->path());
    }
    if (found.size() == 1) return found.front();
    std::sort(found.begin(), found.end());
    std::string names;
    for (const fs::path& file : found) names += (names.empty() ? ": " : ", ") + file.filename().string();
    report.error(
        "S101", {},
        "the folder contains " + std::to_string(found.size()) + " glTF files; wanted exactly one" + names,
        found.empty() ? "name a folder that contains a .gltf or .glb file" : "name one of the files");
    return {};
}

FileBytes read_scene_file(const fs::path& file, const SceneLimits& limits, MemoryBudget& memory,
                          gltf::Report& report) {
    const uint64_t most_bytes = saturating_add(limits.resource_bytes, limits.json_bytes);
    FileBytes bytes = read_plain_file(file, std::min(most_bytes, memory.left_bytes()));
    if (!bytes.fault && memory.take(bytes.bytes.size())) return bytes;
    const bool large = !bytes.fault || *bytes.fault == ReadFault::too_large;
    report.error(
        large ? "S107" : "S101", {}, bytes.message,
        large ? "split the scene into several files, or raise scene.resourceBytes or scene.memoryBytes "
                "with --limits"
              : "check that the file exists and can be read");
    return bytes;
}

// Estimated memory in bytes for the parsed JSON, for the strings that are copied from the JSON, and for the
// model of tinygltf. The estimate is the number of bytes of the JSON text times the first constant, plus the
// number of JSON values times the second constant. It is larger than the largest measured use.
constexpr uint64_t kBytesPerJsonByte = 3, kBytesPerJsonValue = 400;
// The Document (the result of parsing) keeps 1 / kJsonPartOfDocument of the memory that was taken for the
// JSON. This part remains in use while build_scene() runs. The rest is released before build_scene() begins.
constexpr uint64_t kJsonPartOfDocument = 4;

// Adds a default material if a primitive has no material, and returns its index. Otherwise returns kNone.
uint32_t default_material(const gltf::BuiltMeshes& built, Scene& scene) {
    for (const std::vector<gltf::BuiltPrimitive>& primitives : built.of_gltf_mesh) {
        for (const gltf::BuiltPrimitive& primitive : primitives) {
            if (primitive.material != kNone) continue;
            Material material;
            material.name = "default";
            scene.materials.push_back(std::move(material));
            return static_cast<uint32_t>(scene.materials.size() - 1);
        }
    }
    return kNone;
}

Scene build_scene(gltf::Document& document, const fs::path& file, const SceneLimits& limits,
                  const LoadOptions& options, MemoryBudget& memory, gltf::Report& report) {
    Scene scene;
    scene.name = document.name.empty() ? file.stem().string() : document.name;
    gltf::BuiltMeshes built = gltf::build_meshes(document, limits, options, memory, report);
    scene.materials = std::move(document.materials);
    scene.light_functions = std::move(document.light_functions);
    // After an error, no textures are loaded. If the memory is exhausted, loading textures would only report
    // the same error again.
    if (report.failed()) return scene;
    scene.textures = gltf::build_textures(document, limits, options, memory, report, scene.materials,
                                          scene.light_functions);
    if (!report.failed()) gltf::settle_alpha(built, scene.textures, scene.materials);
    const uint32_t fallback = default_material(built, scene);
    gltf::place_nodes(document, built, fallback, limits, memory, report, scene);
    scene.meshes = std::move(built.meshes);
    if (report.failed()) return scene;
    if (scene.instances.empty()) {
        report.warn("S156", {}, "the scene has no triangles to draw", "add a mesh to a node of the scene");
    }
    scene.bounds = world_bounds(scene);
    return scene;
}

// Reads and checks the JSON only. The files that the JSON refers to are not opened. `taken_bytes` receives
// the number of bytes that the JSON takes from `memory`.
std::optional<gltf::CheckedJson> read_json(std::string_view json, const SceneLimits& limits,
                                           MemoryBudget& memory, uint64_t& taken_bytes,
                                           gltf::Report& report) {
    const std::optional<uint64_t> values = gltf::count_values(json, limits, report);
    if (!values) return std::nullopt;
    taken_bytes = json.size() * kBytesPerJsonByte + *values * kBytesPerJsonValue;
    if (!gltf::take_memory(memory, {taken_bytes, "S107", {}, "the JSON of the file"}, report))
        return std::nullopt;
    return gltf::check_gltf(json, limits, report);
}

std::optional<Scene> load_scene(const fs::path& file, const SceneLimits& limits, const LoadOptions& options,
                                gltf::Report& report) {
    MemoryBudget memory(limits.memory_bytes);
    FileBytes bytes = read_scene_file(file, limits, memory, report);
    if (report.failed()) return std::nullopt;
    const std::optional<gltf::Container> container = gltf::open_container(bytes.bytes, report);
    if (!container) return std::nullopt;
    uint64_t json_bytes = 0;
    std::optional<gltf::CheckedJson> checked = read_json(container->json, limits, memory, json_bytes, report);
    if (!checked) return std::nullopt;
    const RootedFolder folder(file.parent_path());
    std::optional<gltf::Resources> resources =
        gltf::load_resources(*checked, container->binary, folder, limits, memory, report);
    if (!resources) return std::nullopt;
    memory.give_back(bytes.bytes.size());
    bytes = {};
    std::optional<gltf::Document> document = gltf::parse_document(*checked, std::move(*resources), report);
    if (!document) return std::nullopt;
    checked.reset();
    gltf::check_sparse_indices(*document);
    memory.give_back(json_bytes - json_bytes / kJsonPartOfDocument);
    std::optional<Scene> scene = build_scene(*document, file, limits, options, memory, report);
    for (const std::vector<uint8_t>& buffer : document->buffers) memory.give_back(buffer.size());
    for (const gltf::EncodedImage& image : document->images) memory.give_back(image.bytes.size());
    memory.give_back(json_bytes / kJsonPartOfDocument);
    scene->memory_bytes = memory.taken_bytes();
    return scene;
}

}  // namespace

Result<Scene> load_gltf(const fs::path& file_or_folder, Diagnostics& warnings, const SceneLimits& limits,
                        const LoadOptions& options) {
    gltf::Report unnamed(file_or_folder.string());
    const fs::path file = find_file(file_or_folder, unnamed);
    if (file.empty()) return unnamed.take_errors();
    gltf::Report report(file.string());
    std::optional<Scene> scene;
    try {
        scene = load_scene(file, limits, options, report);
    } catch (const std::bad_alloc&) {
        report.error("X571", {}, "memory ran out while the scene was loaded",
                     "close other programs, or simplify the scene");
    }
    for (Diagnostic& warning : report.take_warnings()) warnings.push_back(std::move(warning));
    if (report.failed()) return report.take_errors();
    return std::move(*scene);
}

}  // namespace weft::scene
