// Purpose: the data of a scene that every frame needs: its objects on the GPU, its lights at the current
// time, and its constants for shaders. Units: seconds.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/gpu_scene.h"
#include "render/probes/probe_turns.h"
#include "render/views/sun_cascades.h"
#include "weft/render/frame_input.h"
#include "weft/scene/scene.h"

namespace weft::render {

class DrawnScene {
 public:
    // `owned` is either null or `&scene`. If it is not null, each texture of the scene is freed after it is
    // copied to the GPU.
    [[nodiscard]] static Result<DrawnScene> create(vk::Device& device, const scene::Scene& scene,
                                                   const SceneSettings& settings, scene::Scene* owned);

    // Returns an error W244 if `input` moves an instance that the program may not move.
    [[nodiscard]] Status check(const FrameInput& input) const;
    // Begins a frame: moves the objects and the lights to their places. The frame slot must not be in flight:
    // Executor::begin_frame() returns a free one. check() must have accepted the input.
    void begin_frame(uint32_t slot, const FrameInput& input);
    // Returns the camera at the place that it has at the time of the last begin_frame(): an animation may
    // move it.
    [[nodiscard]] scene::Camera placed(const scene::Camera& camera) const;
    // Returns the lights at the time of the last begin_frame().
    [[nodiscard]] const std::vector<shared::Light>& lights() const { return lights_; }
    // Returns constants for shaders: the sky, the environment and the counts of lights. The caller adds the
    // frame index, the time and the exposure.
    [[nodiscard]] shared::FrameConstants frame_constants() const;
    // Returns the cascades of the sun's shadow: for each shadow map in `maps`, the view from which it is
    // drawn. Empty if the scene has no directional light with an intensity above 0, or if the graph draws no
    // shadow map of the sun. `aspect` is width / height of the picture.
    [[nodiscard]] SunCascades find_sun(const scene::Camera& camera, float aspect, const SunMaps& maps);
    // Returns the data of two kinds of shadow maps: the maps of the directional lights 2 to 4, and the maps
    // over all objects that do not move. Only the maps that the graph draws have a size in `sizes_px`.
    [[nodiscard]] FurtherSunMaps find_further_suns(const FurtherSunSizes& sizes_px) const {
        return further_sun_maps(lights_, bounds_, gpu_->still_bounds().value_or(bounds_), sizes_px);
    }
    // In each frame, ProbeTurns chooses the light probes that are lit anew: probe_turns() chooses irradiance
    // probes, reflection_turns() chooses reflection probes.
    [[nodiscard]] ProbeTurns& probe_turns() { return turns_; }
    [[nodiscard]] ProbeTurns& reflection_turns() { return reflection_turns_; }
    [[nodiscard]] GpuScene& gpu() { return *gpu_; }
    [[nodiscard]] const GpuScene& gpu() const { return *gpu_; }

 private:
    DrawnScene() = default;
    void update_lights(const FrameInput& input);
    [[nodiscard]] std::span<const glm::mat4> nodes() const { return gpu_->parts().first().nodes(); }

    std::unique_ptr<GpuScene> gpu_;
    std::vector<scene::Light> scene_lights_;
    size_t light_functions_ = 0;
    bool lights_move_ = false;
    bool has_program_lights_ = false;  // True if `lights_` comes from FrameInput::lights, not from the scene.
    std::vector<shared::Light> lights_;
    scene::Bounds bounds_;
    SunCascadesCache sun_;
    ProbeTurns turns_, reflection_turns_;
    shared::FrameConstants constants_{};
};

}  // namespace weft::render
