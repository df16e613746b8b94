#include "render/motion/moving_objects.h"

namespace weft::render {
namespace {

scene::Bounds moved(const scene::Bounds& box, const glm::mat4& transform) {
    scene::Bounds out{glm::vec3(transform * glm::vec4(box.min, 1)),
                      glm::vec3(transform * glm::vec4(box.min, 1))};
    for (int corner = 1; corner < 8; ++corner) {
        const glm::vec3 at((corner & 1) != 0 ? box.max.x : box.min.x,
                           (corner & 2) != 0 ? box.max.y : box.min.y,
                           (corner & 4) != 0 ? box.max.z : box.min.z);
        const glm::vec3 world(transform * glm::vec4(at, 1));
        out.min = glm::min(out.min, world);
        out.max = glm::max(out.max, world);
    }
    return out;
}

}  // namespace

MovingObjects::MovingObjects(const scene::Scene& scene) {
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        if (instance.node == scene::kNone) continue;
        objects_.push_back({i, instance.mesh, instance.node, instance.transform, instance.transform, false,
                            scene.meshes[instance.mesh].bounds});
    }
}

void MovingObjects::move(std::span<const glm::mat4> nodes) {
    for (MovingObject& object : objects_) {
        const glm::mat4 next = nodes[object.node];
        const glm::mat4 previous = has_moved_ ? object.transform : next;
        object.changed = next != object.transform || previous != object.previous;
        object.previous = previous;
        object.transform = next;
    }
    has_moved_ = true;
}

std::optional<scene::Bounds> MovingObjects::bounds() const {
    std::optional<scene::Bounds> all;
    for (const MovingObject& object : objects_)
        all = united(all, moved(object.mesh_bounds, object.transform));
    return all;
}

std::optional<scene::Bounds> united(const std::optional<scene::Bounds>& a,
                                    const std::optional<scene::Bounds>& b) {
    if (!a || !b) return a ? a : b;
    return scene::Bounds{glm::min(a->min, b->min), glm::max(a->max, b->max)};
}

}  // namespace weft::render
