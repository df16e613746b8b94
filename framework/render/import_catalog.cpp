#include "weft/render/import_catalog.h"

#include <algorithm>

#include "render/frame_data.h"
#include "render/imports/material_textures.h"
#include "render/imports/scene_buffers.h"
#include "render/imports/scene_lights.h"
#include "render/probes/probe_imports.h"
#include "render/scene_bindings.h"
#include "render/views/frame_views.h"
#include "render/views/sun_cascades.h"
#include "shared/draw_command.glsl"
#include "shared/draw_vertices_command.glsl"
#include "shared/frame.glsl"
#include "shared/light.glsl"

namespace weft::render {
namespace {

// Vertices have two streams, with strides of 16 and 24 bytes. Stream 0 has the position, which every draw
// needs. Stream 1 has the attributes that only shading needs. Members of an attribute: name, format, stream,
// offset in bytes.
VertexFormat canonical_vertex_format() {
    return {{16, 24},
            {{"position", Format::rgba32f, 0, 0},
             {"normal", Format::rgba16_snorm, 1, 0},
             {"tangent", Format::rgba16_snorm, 1, 8},
             {"uv", Format::rg32f, 1, 16}}};
}

DrawVariant variant(const std::string& name, bool masked, bool anisotropic) {
    return {name, {{"MASKED", masked ? 1.0 : 0.0}, {"ANISOTROPIC", anisotropic ? 1.0 : 0.0}}};
}

std::vector<DrawVariant> variants_of(const std::string& list) {
    if (list == "anisotropic") return {variant("opaque", false, true), variant("masked", true, true)};
    if (list == "coated" || list == "scattering")
        return {variant("opaque", false, false), variant("masked", true, false)};
    if (list == "opaqueStill") return {variant("opaque", false, false)};
    if (list == "maskedStill") return {variant("masked", true, false)};
    return {variant(list, list == "masked", false)};
}

ImportDecl draw_list(const std::string& name, uint32_t draws) {
    ImportDecl import;
    import.name = name;
    import.kind = ImportKind::draw_list;
    import.variants = variants_of(name);
    import.vertex_format = canonical_vertex_format();
    import.draws = draws;
    return import;
}

ImportDecl draw_commands(const ImportDecl& list) {
    ImportDecl import;
    import.name = commands_of(list.name);
    import.kind = ImportKind::buffer;
    import.read_only = true;
    ResourceDecl& buffer = import.resource;
    buffer.name = import.name;
    buffer.kind = ResourceKind::buffer;
    buffer.lifetime = ResourceLifetime::imported;
    buffer.stride_bytes = sizeof(shared::DrawCommand);
    buffer.size_bytes = uint64_t{std::max(1u, list.draws)} * sizeof(shared::DrawCommand);
    buffer.usage = usage::kStorage | usage::kTransferSrc | usage::kTransferDst | usage::kIndirect;
    // The state of the buffer between frames. Nothing really reads the buffer then: only graphs access it.
    // The transfer read is declared so that a frame's writes have finished before the next frame reads them.
    const AccessState between{stage::kCopy, access::kTransferRead, Layout::undefined};
    buffer.import = ImportState{between, between, 0};
    return import;
}

uint32_t count_draws(const scene::Scene* scene, std::string_view list) {
    if (scene == nullptr) return 1;
    return static_cast<uint32_t>(
        std::ranges::count_if(scene->instances, [&](const scene::Instance& instance) {
            return is_in_draw_list(instance, scene->materials[instance.material], list);
        }));
}

// Counts the directional lights with an intensity above 0. Returns 1 if `scene` is null.
uint32_t count_directional_lights(const scene::Scene* scene) {
    if (scene == nullptr) return 1;
    return static_cast<uint32_t>(std::ranges::count_if(scene->lights, [](const scene::Light& light) {
        return light.type == scene::LightType::directional && light.intensity > 0;
    }));
}

// Number of views of lamps if there is no scene: the views of a point light and of two spot lights.
constexpr uint32_t kAssumedLampViews = 8;

// The list `name` of views of lamps, of which each lamp has `count(lamp)`.
ImportDecl lamp_view_list(const char* name, const scene::Scene* scene,
                          uint32_t (*count)(const shared::Light&)) {
    uint32_t views = scene == nullptr ? kAssumedLampViews : 0;
    if (scene != nullptr)
        for (const shared::Light& light : gpu_lights(scene->lights, 0, scene->light_functions.size()))
            views += count(light);
    ImportDecl lamps = view_list(name, views);
    lamps.assumes_views = scene == nullptr;
    return lamps;
}

// True if the scene has an environment map with a scale above 0, or if `scene` is null.
bool has_environment_picture(const scene::Scene* scene) {
    return scene == nullptr || (!scene->environment.mips.empty() && scene->environment.scale > 0);
}

ImportDecl output(Extent3D extent) {
    ImportDecl import;
    import.name = "backbuffer";
    import.kind = ImportKind::output;
    ResourceDecl& image = import.resource;
    image.name = import.name;
    image.kind = ResourceKind::image;
    image.lifetime = ResourceLifetime::imported;
    image.format = Format::rgba8;
    image.extent = extent;
    image.usage = usage::kColorAttachment | usage::kStorage | usage::kSampled | usage::kTransferSrc |
                  usage::kTransferDst;
    // Between frames, the program may copy or blit the image. This must finish before the next frame writes
    // the image. The next frame does not need the old content, so its entry layout is undefined.
    const AccessState copied{stage::kCopy | stage::kBlit, access::kTransferRead, Layout::transfer_src};
    image.import = ImportState{{copied.stages, copied.access, Layout::undefined}, copied, 0};
    return import;
}

}  // namespace

bool is_still_list(std::string_view list) {
    return list == "opaqueStill" || list == "maskedStill";
}

bool is_in_draw_list(const scene::Instance& instance, const scene::Material& material,
                     std::string_view list) {
    if (is_still_list(list))
        return instance.node == scene::kNone &&
               is_in_draw_list(instance, material, list == "opaqueStill" ? "opaque" : "masked");
    if (list == "anisotropic")
        return material.anisotropy > 0 && material.alpha_mode != scene::AlphaMode::blend;
    if (list == "coated")
        return material.clearcoat > 0 && material.anisotropy == 0 &&
               material.alpha_mode != scene::AlphaMode::blend;
    if (list == "scattering")
        return (material.diffuse_transmission > 0 || material.diffuse_roughness_rad > 0) &&
               material.anisotropy == 0 && material.clearcoat == 0 &&
               material.alpha_mode != scene::AlphaMode::blend;
    if (list == "refractive")
        return material.transmission > 0 && material.alpha_mode == scene::AlphaMode::blend;
    switch (material.alpha_mode) {
        case scene::AlphaMode::opaque:
            return list == "opaque";
        case scene::AlphaMode::mask:
            return list == "masked";
        case scene::AlphaMode::blend:
            return list == "transparent";
    }
    return false;
}

uint32_t draw_variant(const scene::Material& material, std::string_view list) {
    const bool has_both = list == "anisotropic" || list == "coated" || list == "scattering";
    return has_both && material.alpha_mode == scene::AlphaMode::mask ? 1 : 0;
}

std::string commands_of(std::string_view list) {
    return std::string(list) + "Commands";
}

ImportDecl view_list(const std::string& name, uint32_t count) {
    ImportDecl import;
    import.name = name;
    import.kind = ImportKind::views;
    import.views = count;
    return import;
}

ImportCatalog scene_imports(Extent3D output_extent, const scene::Scene* scene, const scene::Probes* probes) {
    ImportCatalog catalog;
    for (const char* list : kDrawLists)
        catalog.imports.emplace(list, draw_list(list, count_draws(scene, list)));
    for (const char* list : kCommandLists)
        catalog.imports.emplace(commands_of(list), draw_commands(catalog.imports.at(list)));
    catalog.imports.emplace("backbuffer", output(output_extent));
    catalog.views = {"camera", "sun"};
    catalog.imports.emplace("sun", view_list("sun", shared::kMostSunCascades));
    catalog.imports.emplace(kLampViews, lamp_view_list(kLampViews, scene, count_lamp_views));
    catalog.imports.emplace(kLampShadowViews, lamp_view_list(kLampShadowViews, scene, count_lamp_maps));
    // The views of the first directional light are in the list "sun", so the list kFurtherSunViews has one
    // view less than `suns`.
    const uint32_t suns = std::clamp(count_directional_lights(scene), 1u, shared::kMostSuns);
    catalog.imports.emplace(kFurtherSunViews, view_list(kFurtherSunViews, suns - 1));
    catalog.imports.emplace(
        kSceneSunViews,
        view_list(kSceneSunViews, std::min(count_directional_lights(scene), shared::kMostSuns)));
    catalog.numbers = {{"directionalLights", count_directional_lights(scene)},
                       {"environmentPictures", has_environment_picture(scene) ? 1 : 0},
                       {"outputIsLinear", 0}};
    catalog.strides = {{"DrawCommand", sizeof(shared::DrawCommand)},
                       {"DrawVerticesCommand", sizeof(shared::DrawVerticesCommand)},
                       {"Light", sizeof(shared::Light)},
                       {"ViewConstants", sizeof(shared::ViewConstants)}};
    add_scene_buffers(catalog, scene);
    const scene::Probes none;
    if (probes == nullptr && scene != nullptr) probes = &none;
    add_probe_imports(catalog, probes);
    catalog.imports.emplace(kSceneLights, scene_lights_import(scene));
    catalog.imports.emplace(kLightChanges, light_changes_import());
    const uint32_t textures = scene != nullptr ? order_textures(*scene).count() : 1;
    catalog.imports.emplace(kMaterialTextures, texture_table(kMaterialTextures, textures));
    catalog.bindings = scene_bindings();
    return catalog;
}

}  // namespace weft::render
