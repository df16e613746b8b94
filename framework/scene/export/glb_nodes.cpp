#include "scene/export/glb_nodes.h"

#include <tiny_gltf.h>

#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <utility>

namespace weft::scene::glb {
namespace {

// The far plane of a camera, divided by its near plane. tinygltf always writes a far plane. The cameras of
// Weft have none.
constexpr double kFarPlaneFactor = 1e6;

template <class Element>
int add_attribute(const std::vector<Element>& elements, int type, tinygltf::Model& out) {
    return add_accessor(out, elements, {type, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER});
}

tinygltf::Primitive primitive_of(const Mesh& mesh, tinygltf::Model& out) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    const int positions = add_attribute(mesh.positions, TINYGLTF_TYPE_VEC3, out);
    out.accessors.back().minValues = numbers_of(mesh.bounds.min);
    out.accessors.back().maxValues = numbers_of(mesh.bounds.max);
    primitive.attributes["POSITION"] = positions;
    primitive.attributes["NORMAL"] = add_attribute(mesh.normals, TINYGLTF_TYPE_VEC3, out);
    primitive.attributes["TANGENT"] = add_attribute(mesh.tangents, TINYGLTF_TYPE_VEC4, out);
    primitive.attributes["TEXCOORD_0"] = add_attribute(mesh.uvs, TINYGLTF_TYPE_VEC2, out);
    if (!mesh.second_uvs.empty())
        primitive.attributes["TEXCOORD_1"] = add_attribute(mesh.second_uvs, TINYGLTF_TYPE_VEC2, out);
    if (!mesh.colors.empty())
        primitive.attributes["COLOR_0"] = add_attribute(mesh.colors, TINYGLTF_TYPE_VEC4, out);
    primitive.indices = add_accessor(
        out, mesh.indices,
        {TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER});
    return primitive;
}

// Makes the meshes of the file. The buffer gets the vertices of each mesh of the scene once.
class MeshTable {
 public:
    MeshTable(const Scene& scene, tinygltf::Model& out) : scene_(scene), out_(out) {}

    int mesh_of(const Instance& instance) {
        const auto [found, is_new] =
            meshes_.try_emplace({instance.mesh, instance.material}, static_cast<int>(out_.meshes.size()));
        if (!is_new) return found->second;
        const Mesh& source = scene_.meshes[instance.mesh];
        const auto [primitive, is_first] = primitives_.try_emplace(instance.mesh);
        if (is_first) primitive->second = primitive_of(source, out_);
        tinygltf::Mesh mesh;
        mesh.name = source.name;
        mesh.primitives.push_back(primitive->second);
        mesh.primitives.back().material = static_cast<int>(instance.material);
        out_.meshes.push_back(std::move(mesh));
        return found->second;
    }

 private:
    const Scene& scene_;
    tinygltf::Model& out_;
    std::map<std::pair<uint32_t, uint32_t>, int> meshes_;  // By mesh and material of the scene.
    std::map<uint32_t, tinygltf::Primitive> primitives_;   // By mesh of the scene.
};

}  // namespace

tinygltf::Node& add_node(const std::string& name, const glm::mat4& transform, tinygltf::Model& out) {
    std::vector<tinygltf::Node>& nodes = out.nodes;
    out.scenes.front().nodes.push_back(static_cast<int>(nodes.size()));
    tinygltf::Node& node = nodes.emplace_back();
    node.name = name;
    const float* numbers = glm::value_ptr(transform);
    if (transform != glm::mat4(1)) node.matrix.assign(numbers, numbers + 16);
    return node;
}

void add_instances(const Scene& scene, tinygltf::Model& out) {
    MeshTable meshes(scene, out);
    for (const Instance& instance : scene.instances) {
        if (scene.meshes[instance.mesh].indices.empty()) continue;
        const int mesh = meshes.mesh_of(instance);
        add_node(instance.name, instance.transform, out).mesh = mesh;
    }
}

void add_cameras(const std::vector<Camera>& cameras, tinygltf::Model& out) {
    for (const Camera& camera : cameras) {
        tinygltf::Camera to;
        to.name = camera.name;
        to.type = "perspective";
        to.perspective.yfov = double{camera.fov_y_rad};
        to.perspective.znear = double{camera.near_m};
        to.perspective.zfar = double{camera.near_m} * kFarPlaneFactor;
        add_node(camera.name, camera.transform, out).camera = static_cast<int>(out.cameras.size());
        out.cameras.push_back(std::move(to));
    }
}

}  // namespace weft::scene::glb
