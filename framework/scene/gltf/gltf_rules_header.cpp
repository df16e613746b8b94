#include <algorithm>
#include <array>

#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

constexpr uint64_t kMaxExtensions = 1024;
constexpr std::array<std::string_view, 13> kKnownExtensions{"EXT_mesh_gpu_instancing",
                                                            "KHR_lights_punctual",
                                                            "KHR_materials_anisotropy",
                                                            "KHR_materials_clearcoat",
                                                            "KHR_materials_diffuse_transmission",
                                                            "KHR_materials_emissive_strength",
                                                            "KHR_materials_ior",
                                                            "KHR_materials_specular",
                                                            "KHR_materials_transmission",
                                                            "KHR_materials_unlit",
                                                            "KHR_materials_volume",
                                                            "KHR_mesh_quantization",
                                                            "KHR_texture_transform"};

// Weft reads this extension of textures only to name it in messages.
constexpr std::string_view kBasisImages = "KHR_texture_basisu";

constexpr const char* kConvertOldFile =
    "convert it to glTF 2.0, for example with `gltf-pipeline -i OLD -o NEW`, or export the scene as glTF 2.0";

void check_version(const Fields& asset, const char* key, bool fine, const std::string& version,
                   Report& report) {
    if (fine) return;
    report.error("S113", asset.pointer_to(key), "the glTF version is \"" + version + "\"; wanted \"2.0\"",
                 "export the scene as glTF 2.0");
}

// Detects a file of glTF 1.0, which may have no version. glTF 1.0 stores objects by name (a JSON object)
// where glTF 2.0 has arrays.
bool is_gltf_1(const Fields& root) {
    if (root.has("asset")) {
        const std::optional<Fields> asset = root.object("asset", Need::optional);
        if (asset && asset->has("version")) {
            const std::optional<std::string> version = asset->text("version", Need::optional);
            return version && (*version == "1" || version->starts_with("1."));
        }
    }
    return root.is_object("meshes") || root.is_object("nodes") || root.is_object("buffers");
}

void check_asset(Checker& c) {
    if (is_gltf_1(c.root)) {
        c.report.error("S113", c.root.has("asset") ? "/asset/version" : "/asset",
                       "the file is a glTF 1.0 file; wanted glTF 2.0", kConvertOldFile);
        return;
    }
    const std::optional<Fields> asset = c.root.object("asset", Need::required);
    if (!asset) return;
    if (const auto version = asset->text("version", Need::required)) {
        check_version(*asset, "version", version->starts_with("2."), *version, c.report);
    }
    if (const auto version = asset->text("minVersion", Need::optional)) {
        check_version(*asset, "minVersion", *version == "2.0", *version, c.report);
    }
}

void check_extensions(Checker& c) {
    const std::vector<std::string> required = c.root.texts("extensionsRequired", kMaxExtensions);
    for (size_t i = 0; i < required.size(); ++i) {
        if (is_known_extension(required[i])) continue;
        c.report.error("S105", "/extensionsRequired/" + std::to_string(i),
                       "the file requires the extension " + required[i] + ", which is not supported",
                       required[i] == kBasisImages ? "convert the textures to PNG or JPEG"
                                                   : "export without " + required[i] +
                                                         "; Weft reads no compressed meshes and textures");
    }
    const std::vector<std::string> used = c.root.texts("extensionsUsed", kMaxExtensions);
    for (size_t i = 0; i < used.size(); ++i) {
        const bool told = std::find(required.begin(), required.end(), used[i]) != required.end();
        if (told || is_known_extension(used[i]) || used[i] == kBasisImages) continue;
        c.report.warn("S150", "/extensionsUsed/" + std::to_string(i),
                      "the extension " + used[i] + " is ignored",
                      "export without the extension if the scene does not look as intended");
    }
}

}  // namespace

bool is_known_extension(std::string_view name) {
    return std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) != kKnownExtensions.end();
}

bool is_kept_extension(std::string_view name) {
    return is_known_extension(name) || name == kBasisImages;
}

void check_header(Checker& c) {
    check_asset(c);
    // A file of another glTF version would cause many more errors, so checking stops here.
    if (c.report.failed()) return;
    check_extensions(c);
    for (const char* name :
         {"buffers", "bufferViews", "accessors", "samplers", "meshes", "nodes", "scenes", "cameras"}) {
        c.sizes[name] = c.root.array_size(name, c.limits.array_items);
    }
    for (const char* name : {"images", "textures", "materials"}) {
        c.sizes[name] = c.root.array_size(name, c.limits.materials);
    }
    for (const char* name : {"animations", "skins"}) {
        c.sizes[name] = c.root.array_size(name, c.limits.array_items);
    }
}

}  // namespace weft::scene::gltf
