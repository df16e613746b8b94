#include "render/drawn_scene.h"

#include <algorithm>

#include "render/frame_data.h"
#include "scene/model/node_placement.h"

namespace weft::render {

Result<DrawnScene> DrawnScene::create(vk::Device& device, const scene::Scene& scene, scene::Scene* owned) {
    Result<std::unique_ptr<GpuScene>> gpu = GpuScene::create(device, scene, owned);
    if (!gpu) return gpu.take_errors();
    DrawnScene drawn;
    drawn.gpu_ = std::move(*gpu);
    drawn.scene_lights_ = scene.lights;
    drawn.light_functions_ = scene.light_functions.size();
    drawn.lights_move_ = std::ranges::any_of(scene.lights, [](const scene::Light& light) {
        return light.path.turns_per_s != 0 || light.node != scene::kNone;
    });
    drawn.motion_ = scene.motion;
    drawn.lights_ = gpu_lights(scene.lights, 0, scene.light_functions.size());
    drawn.bounds_ = scene::world_bounds(scene);
    if (!scene.motion.nodes.empty()) drawn.fixed_bounds_ = scene::fixed_bounds(scene);
    drawn.constants_ = scene_constants(scene);
    return drawn;
}

void DrawnScene::set_time(uint32_t slot, double time_s) {
    if (!motion_.nodes.empty()) {
        nodes_ = scene::transforms_at(motion_, time_s);
        gpu_->move(slot, nodes_);
        bounds_ = united(fixed_bounds_, gpu_->moving().bounds()).value_or(bounds_);
        for (scene::Light& light : scene_lights_)
            if (light.node != scene::kNone) scene::place_light(nodes_[light.node], light);
    }
    if (lights_move_) lights_ = gpu_lights(scene_lights_, time_s, light_functions_);
}

scene::Camera DrawnScene::placed(const scene::Camera& camera) const {
    scene::Camera placed = camera;
    if (camera.node < nodes_.size()) placed.transform = scene::rigid_transform(nodes_[camera.node]);
    return placed;
}

shared::FrameConstants DrawnScene::frame_constants() const {
    shared::FrameConstants frame = constants_;
    frame.light_count = static_cast<uint32_t>(lights_.size());
    const auto directional = [](const shared::Light& light) {
        return light.type == shared::kLightDirectional;
    };
    frame.directional_count = static_cast<uint32_t>(std::ranges::count_if(lights_, directional));
    const auto first_other = std::ranges::find_if_not(lights_, is_plain);
    frame.plain_count = static_cast<uint32_t>(first_other - lights_.begin());
    return frame;
}

// The sun is the first directional light. Directional lights come first in `lights_`, so only element 0 is
// checked.
SunCascades DrawnScene::find_sun(const scene::Camera& camera, float aspect, const SunMaps& maps) const {
    if (maps.count == 0 || lights_.empty() || lights_[0].type != shared::kLightDirectional) return {};
    return sun_cascades(camera, aspect, {-lights_[0].direction, bounds_}, maps);
}

}  // namespace weft::render
