// Purpose: the data of a scene that every frame needs: its objects on the GPU, its lights at the current
// time, and its constants for shaders. Units: seconds.
#pragma once

#include <memory>
#include <vector>

#include "render/gpu_scene.h"
#include "render/views/sun_cascades.h"
#include "weft/scene/scene.h"

namespace weft::render {

class DrawnScene {
 public:
    // `owned` is either null or `&scene`. If it is not null, each texture of the scene is freed after it is
    // copied to the GPU.
    [[nodiscard]] static Result<DrawnScene> create(vk::Device& device, const scene::Scene& scene,
                                                   scene::Scene* owned);

    // Begins a frame: moves the objects and the lights to their places at `time_s`. The frame slot must not be
    // in flight: Executor::begin_frame() returns a free one.
    void set_time(uint32_t slot, double time_s);
    // Returns the camera at its place at the time of the last set_time().
    [[nodiscard]] scene::Camera placed(const scene::Camera& camera) const;
    // Returns the lights at the time of the last set_time().
    [[nodiscard]] const std::vector<shared::Light>& lights() const { return lights_; }
    // Returns constants for shaders: the sky, the environment and the counts of lights. The caller adds the
    // frame index, the time and the exposure.
    [[nodiscard]] shared::FrameConstants frame_constants() const;
    // Returns the cascades of the sun's shadow: for each shadow map in `maps`, the view from which it is drawn.
    // Empty if the scene has no directional light with an intensity above 0, or if the graph draws no shadow
    // map of the sun. `aspect` is width / height of the picture.
    [[nodiscard]] SunCascades find_sun(const scene::Camera& camera, float aspect, const SunMaps& maps) const;
    [[nodiscard]] GpuScene& gpu() { return *gpu_; }

 private:
    DrawnScene() = default;

    std::unique_ptr<GpuScene> gpu_;
    std::vector<scene::Light> scene_lights_;
    size_t light_functions_ = 0;
    bool lights_move_ = false;
    scene::Motion motion_;
    std::vector<glm::mat4> nodes_;  // The transforms of motion_.nodes at the current time.
    std::vector<shared::Light> lights_;
    std::optional<scene::Bounds> fixed_bounds_;  // Of the objects that do not move.
    scene::Bounds bounds_;
    shared::FrameConstants constants_{};
};

}  // namespace weft::render
