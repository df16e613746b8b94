// Purpose: the objects of a scene that move, with their transforms in the current frame and in the previous
// frame, from which shaders compute velocities. An object follows a node of the scene, or the program moves
// it. Pure data; no Vulkan. Units: metres.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::render {

struct MovingObject {
    uint32_t instance = 0;  // Index into Scene::instances.
    uint32_t mesh = 0;
    uint32_t node = scene::kNone;  // Index into Motion::nodes; kNone: the program moves the object.
    glm::mat4 transform{1};
    glm::mat4 previous{1};
    glm::mat4 next{1};  // The transform of the next frame, if the program moves the object.
    // True if `transform` or `previous` differs from its value in the last frame. So an object that stops
    // counts as changed for one more frame: then `previous` changes, and the velocity becomes 0.
    bool changed = false;
    bool active = false;  // True if the object is in MovingObjects::active().
    // Number of frames in which the object must still be written: every frame slot needs the last change.
    uint32_t writes_left = 0;
    scene::Bounds mesh_bounds;
};

class MovingObjects {
 public:
    MovingObjects() = default;
    // If `program_moves` is true, the program may move every instance that follows no node.
    MovingObjects(const scene::Scene& scene, bool program_moves);

    // Returns true if the program may move this instance.
    [[nodiscard]] bool can_set(uint32_t instance) const;
    // Sets the transform of the next frame of an instance that the program may move.
    void set(uint32_t instance, const glm::mat4& transform);
    // Begins a frame. `nodes` is the result of transforms_at(). In the first frame, the previous transforms
    // are those of this frame.
    void move(std::span<const glm::mat4> nodes);

    [[nodiscard]] std::span<const MovingObject> all() const { return objects_; }
    // Returns the indices in all() of the objects whose data must be written in this frame.
    [[nodiscard]] std::span<const uint32_t> active() const { return active_; }
    [[nodiscard]] bool any_changed() const { return any_changed_; }
    // Returns the bounding box of all objects in world space; nullopt if no object moves.
    [[nodiscard]] std::optional<scene::Bounds> bounds() const;

 private:
    std::vector<MovingObject> objects_;
    std::vector<uint32_t> active_;
    // Index: instance. Index into objects_; kNone: the instance does not move.
    std::vector<uint32_t> object_of_;
    bool has_moved_ = false;
    bool any_changed_ = false;
};

// Returns the smallest box that contains both boxes. An argument that is nullopt is an empty box.
[[nodiscard]] std::optional<scene::Bounds> united(const std::optional<scene::Bounds>& a,
                                                  const std::optional<scene::Bounds>& b);

}  // namespace weft::render
