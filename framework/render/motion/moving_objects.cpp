#include "render/motion/moving_objects.h"

#include "render/views/frustum.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

MovingObjects::MovingObjects(const scene::Scene& scene, bool program_moves) {
    object_of_.assign(scene.instances.size(), scene::kNone);
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        if (instance.node == scene::kNone && !program_moves) continue;
        const auto index = static_cast<uint32_t>(objects_.size());
        object_of_[i] = index;
        MovingObject object;
        object.instance = i;
        object.mesh = instance.mesh;
        object.node = instance.node;
        object.transform = object.previous = object.next = instance.transform;
        object.mesh_bounds = scene.meshes[instance.mesh].bounds;
        // An object that follows a node of the scene always stays active, because the node may move it in any
        // frame.
        object.active = instance.node != scene::kNone;
        if (object.active) active_.push_back(index);
        objects_.push_back(object);
    }
}

bool MovingObjects::can_set(uint32_t instance) const {
    return instance < object_of_.size() && object_of_[instance] != scene::kNone &&
           objects_[object_of_[instance]].node == scene::kNone;
}

void MovingObjects::set(uint32_t instance, const glm::mat4& transform) {
    const uint32_t index = object_of_[instance];
    MovingObject& object = objects_[index];
    object.next = transform;
    if (object.active || transform == object.transform) return;
    object.active = true;
    active_.push_back(index);
}

void MovingObjects::move(std::span<const glm::mat4> nodes) {
    std::erase_if(active_, [&](uint32_t index) {
        MovingObject& object = objects_[index];
        const bool stays = object.node != scene::kNone || object.writes_left > 0 ||
                           object.next != object.transform || object.previous != object.transform;
        object.active = stays;
        return !stays;
    });
    any_changed_ = false;
    for (const uint32_t index : active_) {
        MovingObject& object = objects_[index];
        const glm::mat4 next = object.node != scene::kNone ? nodes[object.node] : object.next;
        const glm::mat4 previous = has_moved_ ? object.transform : next;
        object.changed = next != object.transform || previous != object.previous;
        object.previous = previous;
        object.transform = next;
        if (object.changed) object.writes_left = vk::kFramesInFlight;
        if (object.writes_left > 0) --object.writes_left;
        any_changed_ |= object.changed;
    }
    has_moved_ = true;
}

std::optional<scene::Bounds> MovingObjects::bounds() const {
    std::optional<scene::Bounds> all;
    for (const MovingObject& object : objects_)
        all = united(all, box_in_world(object.mesh_bounds, object.transform));
    return all;
}

std::optional<scene::Bounds> united(const std::optional<scene::Bounds>& a,
                                    const std::optional<scene::Bounds>& b) {
    if (!a || !b) return a ? a : b;
    return scene::Bounds{glm::min(a->min, b->min), glm::max(a->max, b->max)};
}

}  // namespace weft::render
