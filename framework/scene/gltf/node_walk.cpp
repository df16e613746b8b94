#include "scene/gltf/node_walk.h"

#include "scene/gltf/instancing_build.h"
#include "scene/gltf/motion_build.h"
#include "scene/gltf/probe_build.h"
#include "scene/model/node_placement.h"
#include "weft/limits.h"

namespace weft::scene::gltf {
namespace {

// Memory per instance in bytes: the entry of Scene::instances, the entry of the GPU buffer (208), the draws
// (96) and the draw command (20). Each counts twice: a vector that grows copies its elements, and a GPU
// buffer needs a staging buffer.
constexpr uint64_t kBytesPerInstance = 2 * sizeof(Instance) + 2 * 208 + 2 * 96 + 2 * 20;
// Additional memory for each instance in bytes. If a file has animations, each frame in flight has its own
// copy of the instance in the GPU buffer.
constexpr uint64_t kBytesPerInstanceOfFrames = 2 * 208;
// Memory per moving node: a vector that grows, the copy for drawing, the copy that each frame makes, and the
// transforms of the node and of its object, in this frame and the previous one.
constexpr uint64_t kBytesPerMovingNode = 4 * sizeof(MovingNode) + 6 * sizeof(glm::mat4);

std::string pointer_of(uint32_t node) {
    return "/nodes/" + std::to_string(node);
}

// The place of a node: its transform at rest, and its index in Motion::nodes if it moves.
struct Place {
    glm::mat4 world{1};
    uint32_t moving = kNone;
};

class Walk {
 public:
    Walk(const Document& document, const BuiltMeshes& meshes, uint32_t default_material,
         const SceneLimits& limits, Report& report, Scene& scene)
        : document_(document),
          meshes_(meshes),
          default_material_(default_material),
          limits_(limits),
          report_(report),
          scene_(scene),
          animated_(animated_nodes(document)),
          moving_(document.nodes.size(), kNone) {}

    [[nodiscard]] const std::vector<uint32_t>& moving() const { return moving_; }

    // Takes the memory for the objects of a node, and checks the number of instances. `copies` is the number
    // of instances per mesh. Returns false after an error.
    [[nodiscard]] bool take_room(uint32_t index, const Place& parent, uint64_t copies, MemoryBudget& memory) {
        const Node& node = document_.nodes[index];
        const uint64_t added =
            node.mesh == kNone ? 0 : saturating_mul(copies, meshes_.of_gltf_mesh[node.mesh].size());
        if (saturating_add(scene_.instances.size(), added) > limits_.instances) {
            report_.error("S107", pointer_of(index),
                          "the scene has more than " + std::to_string(limits_.instances) + " instances",
                          "join meshes or split the scene, " + raise_limit_text("scene.instances"));
            return false;
        }
        const uint64_t bytes = memory_bytes(node, copies, moves(index, parent));
        return take_memory(memory, {bytes, "S107", pointer_of(index), "the node"}, report_);
    }

    // Returns the place of a node below `parent`. A node that moves is added to the motion of the scene.
    Place enter(uint32_t index, const Place& parent) {
        const Node& node = document_.nodes[index];
        Place place{parent.world * node.local, kNone};
        if (!moves(index, parent)) return place;
        MovingNode moving;
        moving.parent = parent.moving;
        if (moving.parent == kNone) moving.before = parent.world;
        if (animated_[index]) {
            moving.translation = node.translation;
            moving.rotation = node.rotation;
            moving.scale = node.scale;
        } else {
            moving.before = moving.before * node.local;
        }
        place.moving = add(moving);
        moving_[index] = place.moving;
        return place;
    }

    void place(const Node& node, const Place& place, const InstanceTransforms* copies) {
        if (node.mesh != kNone && copies == nullptr) place_mesh(node, place);
        if (node.mesh != kNone && copies != nullptr)
            for (uint64_t i = 0; i < copies->count(); ++i)
                place_mesh(node, below(place, copies->transform(i)));
        if (node.light != kNone) {
            Light light = document_.lights[node.light];
            place_light(place.world, light);
            light.node = place.moving;
            if (!node.name.empty() && light.name.empty()) light.name = node.name;
            scene_.lights.push_back(std::move(light));
        }
        if (node.camera != kNone && document_.cameras[node.camera]) {
            Camera camera = *document_.cameras[node.camera];
            camera.transform = rigid_transform(place.world);
            camera.node = place.moving;
            // Files often have a useful name only for the node, not for the camera. So the camera takes the
            // name of its node.
            if (!node.name.empty()) camera.name = node.name;
            scene_.cameras.push_back(std::move(camera));
        }
    }

 private:
    // Returns the memory in bytes of the objects that place() adds to the scene for this node. Every
    // instance, light and camera has its own copy of a name.
    [[nodiscard]] uint64_t memory_bytes(const Node& node, uint64_t copies, bool moves) const {
        uint64_t bytes = moves ? kBytesPerMovingNode : 0;
        if (node.mesh != kNone) {
            for (const BuiltPrimitive& primitive : meshes_.of_gltf_mesh[node.mesh]) {
                const std::string& name = node.name.empty() ? meshes_.meshes[primitive.mesh].name : node.name;
                uint64_t each = kBytesPerInstance + name.size();
                if (!document_.animations.empty()) each += kBytesPerInstanceOfFrames;
                bytes = saturating_add(bytes, saturating_mul(copies, each));
            }
            if (moves) bytes = saturating_add(bytes, saturating_mul(copies, kBytesPerMovingNode));
        }
        if (node.light != kNone)
            bytes = saturating_add(
                bytes, 3 * sizeof(Light) + node.name.size() + 2 * document_.lights[node.light].name.size());
        if (node.camera != kNone) bytes = saturating_add(bytes, 2 * sizeof(Camera) + node.name.size());
        return bytes;
    }

    [[nodiscard]] bool moves(uint32_t index, const Place& parent) const {
        return parent.moving != kNone || animated_[index];
    }

    uint32_t add(const MovingNode& node) {
        scene_.motion.nodes.push_back(node);
        return static_cast<uint32_t>(scene_.motion.nodes.size() - 1);
    }

    // Returns the place of an instance that has its own transform below a node. If the resulting transform is
    // not usable (see is_usable_transform()), the instance is invisible.
    Place below(const Place& node, const glm::mat4& transform) {
        Place place{node.world * transform, kNone};
        if (!is_usable_transform(place.world)) place.world = invisible_transform();
        if (node.moving != kNone) place.moving = add({node.moving, transform});
        return place;
    }

    void place_mesh(const Node& node, const Place& place) {
        for (const BuiltPrimitive& primitive : meshes_.of_gltf_mesh[node.mesh]) {
            const std::string& name = node.name.empty() ? meshes_.meshes[primitive.mesh].name : node.name;
            const uint32_t material = primitive.material == kNone ? default_material_ : primitive.material;
            scene_.instances.push_back({name, primitive.mesh, material, place.world, place.moving});
        }
    }

    const Document& document_;
    const BuiltMeshes& meshes_;
    uint32_t default_material_;
    const SceneLimits& limits_;
    Report& report_;
    Scene& scene_;
    std::vector<bool> animated_;
    // Index of each node of the document in Motion::nodes, or kNone for a node that does not move.
    std::vector<uint32_t> moving_;
};

}  // namespace

void place_nodes(const Document& document, const BuiltMeshes& meshes, uint32_t default_material,
                 const SceneLimits& limits, MemoryBudget& memory, Report& report, Scene& scene) {
    struct Visit {
        uint32_t node;
        Place parent;
    };
    Walk walk(document, meshes, default_material, limits, report, scene);
    std::vector<Visit> stack;
    // The roots are pushed in reverse order. The stack returns the last entry first, so the nodes are visited
    // in the order of the file.
    for (size_t i = document.roots.size(); i-- > 0;) stack.push_back({document.roots[i], {}});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const Node& node = document.nodes[visit.node];
        if (!is_usable_transform(visit.parent.world * node.local)) {
            report.warn("S152", pointer_of(visit.node),
                        label("node", visit.node, node.name) +
                            ": the transform in the scene is too large or not finite; the node and its "
                            "descendants are ignored",
                        "correct the matrix or scale of the node or of one of its parents");
            continue;
        }
        std::optional<InstanceTransforms> copies;
        if (document.instancing.contains(visit.node)) {
            copies = InstanceTransforms::open(document, visit.node, report);
            if (!copies) return;
        }
        if (!walk.take_room(visit.node, visit.parent, copies ? copies->count() : 1, memory)) return;
        const Place place = walk.enter(visit.node, visit.parent);
        walk.place(node, place, copies ? &*copies : nullptr);
        place_probe(document, meshes, {visit.node, place.world}, report, scene);
        for (size_t i = node.children.size(); i-- > 0;) stack.push_back({node.children[i], place});
    }
    build_animations(document, walk.moving(), memory, report, scene.motion);
    if (!report.failed() && !scene.motion.nodes.empty()) apply_pose(transforms_at(scene.motion, 0), scene);
}

}  // namespace weft::scene::gltf
