// Purpose: the scene's data for frames: its objects on the GPU, its lights at a time, and its constants.
// Units: seconds.
#pragma once

#include <memory>
#include <vector>

#include "render/gpu_scene.h"
#include "render/sun_cascades.h"
#include "weft/scene/scene.h"

namespace weft::render {

class DrawnScene {
 public:
    // `owned` is `scene` or null: as of GpuScene.
    [[nodiscard]] static Result<DrawnScene> create(vk::Device& device, const scene::Scene& scene,
                                                   scene::Scene* owned);

    // Moves the animated lights.
    void set_time(double time_s);
    // At the time of the last set_time().
    [[nodiscard]] const std::vector<shared::Light>& lights() const { return lights_; }
    // The sky, the environment and the counts of lights; the caller adds time and exposure.
    [[nodiscard]] shared::FrameConstants frame_constants() const;
    // Empty if there is no directional light with intensity, or the graph has no maps. `aspect` is the
    // picture's width / height.
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
