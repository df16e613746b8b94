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

    // Moves the animated lights to their positions at `time_s`.
    void set_time(double time_s);
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
    std::vector<shared::Light> lights_;
    scene::Bounds bounds_;
    shared::FrameConstants constants_{};
};

}  // namespace weft::render
