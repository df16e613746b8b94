#include "scene/gltf/parse/parse_document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <new>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>

#include "scene/gltf/parse/parse_material.h"
#include "scene/gltf/parse/values.h"
#include "scene/model/lamp_area.h"
#include "scene/model/node_placement.h"

namespace weft::scene::gltf {
namespace {

using Buffers = std::vector<std::vector<uint8_t>>;

// Returns the buffer for a file name in the JSON. After the checks, these names are only numbers: the name
// "3" means buffer 3. Returns nullptr for any other name.
std::vector<uint8_t>* buffer_named(const std::string& name, void* buffers) {
    Buffers& all = *static_cast<Buffers*>(buffers);
    size_t index = 0;
    const auto parsed = std::from_chars(name.data(), name.data() + name.size(), index);
    if (parsed.ec != std::errc() || parsed.ptr != name.data() + name.size() || index >= all.size())
        return nullptr;
    return &all[index];
}

bool parse_model(const std::string& text, Buffers& buffers, tinygltf::Model& model, std::string& error) {
    tinygltf::TinyGLTF loader;
    tinygltf::FsCallbacks callbacks{};
    callbacks.FileExists = [](const std::string& name, void* all) {
        return buffer_named(name, all) != nullptr;
    };
    callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name,
                                 void* all) {
        std::vector<uint8_t>* buffer = buffer_named(name, all);
        if (buffer == nullptr) return false;
        *out = std::move(*buffer);
        return true;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                  void*) { return false; };
    callbacks.user_data = &buffers;
    loader.SetFsCallbacks(callbacks);
    std::string warning;
    try {
        const bool parsed = loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                       static_cast<unsigned int>(text.size()), "");
        return parsed && error.empty();
    } catch (const std::bad_alloc&) {
        // Memory that runs out is not a fault of the file. load_gltf() catches this exception and reports it.
        throw;
    } catch (const std::exception& fault) {
        error = fault.what();
        return false;
    }
}

Accessor convert(const tinygltf::Accessor& source) {
    Accessor out;
    out.view = index_or_none(source.bufferView);
    out.offset_bytes = source.byteOffset;
    out.count = source.count;
    out.type = static_cast<ComponentType>(source.componentType);
    out.components =
        static_cast<uint32_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(source.type)));
    out.normalized = source.normalized;
    if (!source.sparse.isSparse) return out;
    out.sparse.count = static_cast<uint64_t>(source.sparse.count);
    out.sparse.index_view = index_or_none(source.sparse.indices.bufferView);
    out.sparse.index_offset_bytes = static_cast<uint64_t>(source.sparse.indices.byteOffset);
    out.sparse.index_type = static_cast<ComponentType>(source.sparse.indices.componentType);
    out.sparse.value_view = index_or_none(source.sparse.values.bufferView);
    out.sparse.value_offset_bytes = static_cast<uint64_t>(source.sparse.values.byteOffset);
    return out;
}

MeshSource convert(const tinygltf::Mesh& source) {
    MeshSource out{source.name, {}};
    for (const tinygltf::Primitive& primitive : source.primitives) {
        const auto attribute = [&](const char* name) {
            const auto it = primitive.attributes.find(name);
            return it != primitive.attributes.end() ? index_or_none(it->second) : kNone;
        };
        out.primitives.push_back({static_cast<uint32_t>(primitive.mode), index_or_none(primitive.material),
                                  index_or_none(primitive.indices), attribute("POSITION"),
                                  attribute("NORMAL"), attribute("TANGENT"), attribute("TEXCOORD_0"),
                                  attribute("TEXCOORD_1"), attribute("COLOR_0")});
    }
    return out;
}

Light convert(const tinygltf::Light& source) {
    constexpr double kHalfPi = 1.5707963267948966;
    Light out;
    out.name = source.name;
    out.type = source.type == "directional" ? LightType::directional
               : source.type == "spot"      ? LightType::spot
                                            : LightType::point;
    out.color = glm::max(vector_or(source.color, glm::vec3(1)), glm::vec3(0));
    out.intensity = std::max(0.0f, static_cast<float>(source.intensity));
    out.range_m = std::max(0.0f, static_cast<float>(source.range));
    const double outer = std::clamp(source.spot.outerConeAngle, 0.0, kHalfPi);
    out.outer_cone_rad = static_cast<float>(outer);
    out.inner_cone_rad = static_cast<float>(std::clamp(source.spot.innerConeAngle, 0.0, outer));
    return out;
}

void apply(const LightSource& source, Light& light, std::vector<LightFunction>& functions) {
    if (source.shape) {
        light.type = *source.shape;
        light.half_size_m = source.half_size_m;
        light.intensity /= seen_area_m2(*source.shape, source.half_size_m);
    }
    if (!source.function) return;
    light.function = static_cast<uint32_t>(functions.size());
    functions.push_back(*source.function);
    functions.back().name = light.name;
}

std::optional<Camera> convert(const tinygltf::Camera& source) {
    if (source.type != "perspective") return std::nullopt;
    Camera out;
    out.name = source.name;
    out.fov_y_rad = static_cast<float>(source.perspective.yfov);
    out.near_m = static_cast<float>(source.perspective.znear);
    return out;
}

void place(const tinygltf::Node& source, Node& out) {
    if (source.matrix.size() == 16) {
        for (size_t i = 0; i < 16; ++i) glm::value_ptr(out.local)[i] = static_cast<float>(source.matrix[i]);
        // The last row of an affine matrix is 0, 0, 0, 1. check_matrix() has warned if the file has other
        // numbers there.
        for (int column = 0; column < 4; ++column) out.local[column][3] = column == 3 ? 1.0f : 0.0f;
        return;
    }
    const glm::vec4 xyzw = unit_quaternion(vector_or(source.rotation, glm::vec4(0, 0, 0, 1)));
    out.rotation = glm::quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z);
    out.translation = vector_or(source.translation, glm::vec3(0));
    out.scale = vector_or(source.scale, glm::vec3(1));
    const glm::mat4 moved = glm::translate(glm::mat4(1), out.translation);
    out.local = glm::scale(moved * glm::mat4_cast(out.rotation), out.scale);
}

Node convert(const tinygltf::Node& source) {
    Node out;
    out.name = source.name;
    place(source, out);
    for (const int child : source.children) out.children.push_back(static_cast<uint32_t>(child));
    out.mesh = index_or_none(source.mesh);
    out.camera = index_or_none(source.camera);
    if (const tinygltf::Value* light = find_extension(source.extensions, "KHR_lights_punctual")) {
        out.light = static_cast<uint32_t>(number_or(*light, "light", 0));
    }
    return out;
}

// Returns the root nodes of the selected scene. If the file has no scenes, the roots are all nodes without a
// parent.
std::vector<uint32_t> root_nodes(const tinygltf::Model& model) {
    std::vector<uint32_t> roots;
    if (!model.scenes.empty()) {
        const auto chosen = static_cast<size_t>(std::max(0, model.defaultScene));
        for (const int node : model.scenes[chosen].nodes) roots.push_back(static_cast<uint32_t>(node));
        return roots;
    }
    std::vector<bool> has_parent(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) has_parent[static_cast<size_t>(child)] = true;
    }
    for (uint32_t i = 0; i < has_parent.size(); ++i) {
        if (!has_parent[i]) roots.push_back(i);
    }
    return roots;
}

Document convert(tinygltf::Model& model, std::vector<EncodedImage> images,
                 std::span<const LightSource> light_sources) {
    Document out;
    out.images = std::move(images);
    out.roots = root_nodes(model);
    if (!model.scenes.empty())
        out.name = model.scenes[static_cast<size_t>(std::max(0, model.defaultScene))].name;
    for (tinygltf::Buffer& buffer : model.buffers) out.buffers.push_back(std::move(buffer.data));
    for (const tinygltf::BufferView& view : model.bufferViews) {
        out.views.push_back(
            {static_cast<uint32_t>(view.buffer), view.byteOffset, view.byteLength, view.byteStride});
    }
    for (const tinygltf::Accessor& accessor : model.accessors) out.accessors.push_back(convert(accessor));
    for (const tinygltf::Mesh& mesh : model.meshes) out.meshes.push_back(convert(mesh));
    for (const tinygltf::Texture& texture : model.textures)
        out.texture_images.push_back(index_or_none(texture.source));
    for (const tinygltf::Material& material : model.materials)
        out.materials.push_back(convert_material(material, model));
    for (const tinygltf::Light& light : model.lights) out.lights.push_back(convert(light));
    for (size_t i = 0; i < std::min(light_sources.size(), out.lights.size()); ++i)
        apply(light_sources[i], out.lights[i], out.light_functions);
    for (const tinygltf::Camera& camera : model.cameras) out.cameras.push_back(convert(camera));
    for (const tinygltf::Node& node : model.nodes) out.nodes.push_back(convert(node));
    return out;
}

}  // namespace

std::optional<Document> parse_document(const CheckedJson& checked, Resources resources, Report& report) {
    tinygltf::Model model;
    std::string error;
    if (!parse_model(checked.text, resources.buffers, model, error)) {
        while (!error.empty() && error.back() == '\n') error.pop_back();
        report.error("S108", {}, "the file is not valid glTF: " + error, "export the scene again");
        return std::nullopt;
    }
    Document document = convert(model, std::move(resources.images), checked.lights);
    document.animations = checked.animations;
    document.instancing = checked.instancing;
    document.probes = checked.probes;
    for (const auto& [material, velocities] : checked.ripples)
        document.materials[material].ripples = velocities;
    for (const auto& [material, roughness_rad] : checked.diffuse_roughness_rad)
        document.materials[material].diffuse_roughness_rad = roughness_rad;
    return document;
}

}  // namespace weft::scene::gltf
