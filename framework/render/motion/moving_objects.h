// Purpose: the objects of a scene that move, with their transforms in the current frame and in the previous
// frame, from which shaders compute velocities. Pure data; no Vulkan. Units: metres.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::render {

struct MovingObject {
    uint32_t instance = 0;  // Index into Scene::instances.
    uint32_t mesh = 0;
    uint32_t node = 0;  // Index into Motion::nodes.
    glm::mat4 transform{1};
    glm::mat4 previous{1};
    // True if one of the two transforms differs from that of the last frame. An object that stops therefore
    // changes once more, because its velocity becomes 0.
    bool changed = false;
    scene::Bounds mesh_bounds;
};

class MovingObjects {
 public:
    MovingObjects() = default;
    explicit MovingObjects(const scene::Scene& scene);

    // Begins a frame. `nodes` is the result of transforms_at(). In the first frame, the previous transforms
    // are those of this frame.
    void move(std::span<const glm::mat4> nodes);

    [[nodiscard]] std::span<const MovingObject> all() const { return objects_; }
    // Returns the bounding box of all objects in world space; nullopt if no object moves.
    [[nodiscard]] std::optional<scene::Bounds> bounds() const;

 private:
    std::vector<MovingObject> objects_;
    bool has_moved_ = false;
};

// Returns the smallest box that contains both boxes. Each may be nullopt: nothing.
[[nodiscard]] std::optional<scene::Bounds> united(const std::optional<scene::Bounds>& a,
                                                  const std::optional<scene::Bounds>& b);

}  // namespace weft::render
