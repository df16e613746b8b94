#include "render/drawn_scene.h"

#include <algorithm>

#include "render/frame_data.h"
#include "render/views/plain_light.h"
#include "scene/model/node_placement.h"

namespace weft::render {

namespace {

Diagnostic cannot_move(const InstanceTransform& moved, const GpuPart* part) {
    const std::string name =
        "instance " + std::to_string(moved.instance) + " of part " + std::to_string(moved.part);
    Diagnostic d;
    d.code = "W244";
    if (part == nullptr) {
        d.message = "FrameInput::transforms moves " + name + ", but the session has no such part";
        d.help = {"use a number that Session::add_part() has returned, or kFirstPart for the scene"};
    } else {
        d.message = "FrameInput::transforms moves " + name +
                    ", which does not exist, follows a node, or was made without moves_instances";
        d.help = {"set SessionInput::moves_instances, or the argument moves_instances of prepare_part()",
                  "an instance with a node moves with its node: remove it from FrameInput::transforms"};
    }
    return d;
}

std::vector<glm::vec3> places_of(const std::vector<shared::ProbePoint>& points) {
    std::vector<glm::vec3> places;
    for (const shared::ProbePoint& point : points) places.push_back(point.position);
    return places;
}

}  // namespace

Result<DrawnScene> DrawnScene::create(vk::Device& device, const scene::Scene& scene,
                                      const SceneSettings& settings, scene::Scene* owned) {
    Result<std::unique_ptr<GpuScene>> gpu = GpuScene::create(device, scene, settings, owned);
    if (!gpu) return gpu.take_errors();
    DrawnScene drawn;
    drawn.gpu_ = std::move(*gpu);
    const GpuProbes& probes = drawn.gpu_->probes();
    drawn.turns_ = ProbeTurns(places_of(probes.points()));
    drawn.reflection_turns_ =
        ProbeTurns(places_of(probes.reflection_points()), ProbeTurns::kMostReflectionTurns);
    drawn.scene_lights_ = scene.lights;
    drawn.light_functions_ = scene.light_functions.size();
    drawn.lights_move_ = std::ranges::any_of(scene.lights, [](const scene::Light& light) {
        return light.path.turns_per_s != 0 || light.node != scene::kNone;
    });
    drawn.lights_ = gpu_lights(scene.lights, 0, scene.light_functions.size());
    drawn.constants_ = scene_constants(scene);
    return drawn;
}

Status DrawnScene::check(const FrameInput& input) const {
    for (const InstanceTransform& moved : input.transforms) {
        const GpuPart* part = gpu_->parts().find(moved.part);
        if (part == nullptr || !part->can_set_transform(moved.instance)) return cannot_move(moved, part);
    }
    return Unit{};
}

void DrawnScene::begin_frame(uint32_t slot, const FrameInput& input) {
    for (const InstanceTransform& moved : input.transforms)
        gpu_->parts().find(moved.part)->set_transform(moved.instance, moved.transform);
    gpu_->begin_frame(slot, input.time_s);
    bounds_ = gpu_->bounds().value_or(scene::Bounds{});
    update_lights(input);
    gpu_->set_lights(slot, lights_);
}

void DrawnScene::update_lights(const FrameInput& input) {
    if (input.lights) {
        lights_ = gpu_lights(*input.lights, input.time_s, light_functions_);
        has_program_lights_ = true;
        return;
    }
    for (scene::Light& light : scene_lights_)
        if (light.node < nodes().size()) scene::place_light(nodes()[light.node], light);
    if (lights_move_ || has_program_lights_)
        lights_ = gpu_lights(scene_lights_, input.time_s, light_functions_);
    has_program_lights_ = false;
}

scene::Camera DrawnScene::placed(const scene::Camera& camera) const {
    scene::Camera placed = camera;
    if (camera.node < nodes().size()) placed.transform = scene::rigid_transform(nodes()[camera.node]);
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
SunCascades DrawnScene::find_sun(const scene::Camera& camera, float aspect, const SunMaps& maps) {
    if (maps.count == 0 || lights_.empty() || lights_[0].type != shared::kLightDirectional) return {};
    SunScene sunlit{-lights_[0].direction, bounds_, {}, gpu_->unknown_bounds(), gpu_->has_unbounded_lists()};
    gpu_->parts().each([&](const GpuPart& part) { sunlit.surfaces.push_back(&part.still_surfaces()); });
    return sun_.find(camera, aspect, sunlit, maps, gpu_->parts().parts_version());
}

}  // namespace weft::render
