#include "scene/gltf/node_walk.h"

#include <cmath>

#include "weft/limits.h"

namespace weft::scene::gltf {
namespace {

constexpr float kMaxEntry = 1e15f;
// Memory per instance in bytes: the entry of Scene::instances, the entry of the GPU buffer (208), the draws
// (96) and the draw command (20). Each counts twice: a vector that grows copies its elements, and a GPU
// buffer needs a staging buffer.
constexpr uint64_t kBytesPerInstance = 2 * sizeof(Instance) + 2 * 208 + 2 * 96 + 2 * 20;

bool is_usable_transform(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(m[column][row]) <= kMaxEntry)) return false;
        }
    }
    return true;
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return std::isfinite(length) && length > 1e-20f ? v / length : fallback;
}

// Returns the part of `v` perpendicular to the unit vector `direction`, normalised. If this part is zero, the
// result is any unit vector perpendicular to `direction`.
glm::vec3 across_or(const glm::vec3& v, const glm::vec3& direction) {
    const glm::vec3 unit = unit_or(v, {1, 0, 0});
    const glm::vec3 steep = std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 across = unit - direction * glm::dot(unit, direction);
    return glm::length(across) > 1e-3f ? glm::normalize(across)
                                       : glm::normalize(glm::cross(direction, steep));
}

// Returns the transform without scale and shear. A camera looks along the direction of its -z axis, and the
// scale of its parent nodes must not distort the picture.
glm::mat4 rigid(const glm::mat4& world) {
    const glm::vec3 back = unit_or(glm::vec3(world[2]), {0, 0, 1});
    const glm::vec3 steep = std::abs(back.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right =
        unit_or(glm::cross(glm::vec3(world[1]), back), unit_or(glm::cross(steep, back), {1, 0, 0}));
    return {glm::vec4(right, 0), glm::vec4(glm::cross(back, right), 0), glm::vec4(back, 0), world[3]};
}

class Walk {
 public:
    Walk(const Document& document, const BuiltMeshes& meshes, uint32_t default_material, Scene& scene)
        : document_(document), meshes_(meshes), default_material_(default_material), scene_(scene) {}

    // Returns the memory in bytes of the objects that place() adds to the scene for this node. Every
    // instance, light and camera has its own copy of a name.
    [[nodiscard]] uint64_t memory_bytes(const Node& node) const {
        uint64_t bytes = 0;
        if (node.mesh != kNone) {
            for (const BuiltPrimitive& primitive : meshes_.of_gltf_mesh[node.mesh]) {
                const std::string& name = node.name.empty() ? meshes_.meshes[primitive.mesh].name : node.name;
                bytes += kBytesPerInstance + name.size();
            }
        }
        if (node.light != kNone)
            bytes += 3 * sizeof(Light) + node.name.size() + 2 * document_.lights[node.light].name.size();
        if (node.camera != kNone) bytes += 2 * sizeof(Camera) + node.name.size();
        return bytes;
    }

    void place(const Node& node, const glm::mat4& world) {
        if (node.mesh != kNone) {
            for (const BuiltPrimitive& primitive : meshes_.of_gltf_mesh[node.mesh]) {
                const std::string& name = node.name.empty() ? meshes_.meshes[primitive.mesh].name : node.name;
                const uint32_t material =
                    primitive.material == kNone ? default_material_ : primitive.material;
                scene_.instances.push_back({name, primitive.mesh, material, world});
            }
        }
        if (node.light != kNone) {
            Light light = document_.lights[node.light];
            light.position = glm::vec3(world[3]);
            // The shape of a light extends along the node's x axis. The light faces along the node's −z axis.
            const glm::vec3 forward = unit_or(-glm::vec3(world[2]), {0, 0, -1});
            const glm::vec3 width = across_or(glm::vec3(world[0]), forward);
            light.direction = light.type == LightType::capsule ? width : forward;
            light.side = light.type == LightType::capsule ? forward : width;
            if (!node.name.empty() && light.name.empty()) light.name = node.name;
            scene_.lights.push_back(std::move(light));
        }
        if (node.camera != kNone && document_.cameras[node.camera]) {
            Camera camera = *document_.cameras[node.camera];
            camera.transform = rigid(world);
            // Files often have a useful name only for the node, not for the camera. So the camera takes the
            // name of its node.
            if (!node.name.empty()) camera.name = node.name;
            scene_.cameras.push_back(std::move(camera));
        }
    }

 private:
    const Document& document_;
    const BuiltMeshes& meshes_;
    uint32_t default_material_;
    Scene& scene_;
};

}  // namespace

void place_nodes(const Document& document, const BuiltMeshes& meshes, uint32_t default_material,
                 const SceneLimits& limits, MemoryBudget& memory, Report& report, Scene& scene) {
    struct Visit {
        uint32_t node;
        glm::mat4 parent;
    };
    Walk walk(document, meshes, default_material, scene);
    std::vector<Visit> stack;
    // The roots are pushed in reverse order. The stack returns the last entry first, so the nodes are visited
    // in the order of the file.
    for (size_t i = document.roots.size(); i-- > 0;) stack.push_back({document.roots[i], glm::mat4(1)});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const Node& node = document.nodes[visit.node];
        const glm::mat4 world = visit.parent * node.local;
        if (!is_usable_transform(world)) {
            report.warn("S152", "/nodes/" + std::to_string(visit.node),
                        label("node", visit.node, node.name) +
                            ": the transform in the scene is too large or not finite; the node and its "
                            "descendants are ignored",
                        "correct the matrix or scale of the node or of one of its parents");
            continue;
        }
        if (!take_memory(
                memory, {walk.memory_bytes(node), "S107", "/nodes/" + std::to_string(visit.node), "the node"},
                report))
            return;
        walk.place(node, world);
        if (scene.instances.size() > limits.instances) {
            report.error("S107", "/nodes/" + std::to_string(visit.node),
                         "the scene has more than " + std::to_string(limits.instances) + " instances",
                         "join meshes or split the scene, " + raise_limit_text("scene.instances"));
            return;
        }
        for (size_t i = node.children.size(); i-- > 0;) stack.push_back({node.children[i], world});
    }
}

}  // namespace weft::scene::gltf
