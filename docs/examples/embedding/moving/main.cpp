// An example of embedding Weft in a program that moves everything: the camera, the lights, the instances and
// a parameter of the graph, and that adds and removes a part of the scene while frames run. Usage: moving
// [--validate]
#include <weft/registry.h>
#include <weft/scene/builtin_scenes.h>
#include <weft/vulkan/device.h>

#include <cmath>

#include "sample.h"

namespace {

constexpr int kFrames = 30;
// Frames before which the part of the scene is added and removed.
constexpr int kAdd = 10, kRemove = 20;

// A square above the scene, as an example of a part that a program loads later.
weft::scene::Scene part_scene() {
    weft::scene::Scene part;
    weft::scene::Mesh& mesh = part.meshes.emplace_back();
    mesh.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    mesh.normals.assign(4, {0, 1, 0});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs.assign(4, {0, 0});
    mesh.indices = {0, 2, 1, 0, 3, 2};
    mesh.bounds = {{-1, 0, -1}, {1, 0, 1}};
    part.materials.emplace_back().double_sided = true;
    part.instances.emplace_back().transform[3].y = 2;
    return part;
}

// Returns the input of a frame in which the camera, the exposure, the lights and an instance have moved.
weft::render::FrameInput moved_input(const weft::scene::Scene& scene, int i) {
    weft::render::FrameInput frame = frame_input(scene, i);
    const auto t = static_cast<float>(frame.time_s);
    frame.camera.transform[3].x += 0.5f * std::sin(t);
    frame.exposure_ev += 0.2f * std::sin(t);
    frame.parameters["autoExposure"] = 0;  // The picture has this exposure, not an automatic one.
    frame.lights = scene.lights;
    frame.lights->front().intensity *= 1 + 0.5f * std::sin(t);
    glm::mat4 transform = scene.instances.front().transform;
    transform[3].y += std::abs(std::sin(4 * t));
    frame.transforms = {{0, transform}};
    return frame;
}

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px));
    const weft::scene::Scene scene = take(weft::scene::make_builtin("spheres"));
    const weft::PassCatalog passes = weft::registered_passes();
    weft::render::SessionInput input = session_input("deferred.json", passes);
    input.output = target.image;
    input.moves_instances = true;
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, scene, input, warnings));

    // A program would call prepare_part() on a loading thread, while frames run.
    weft::render::ScenePart part = take(session->prepare_part(part_scene()));
    weft::render::PartId id = weft::render::kFirstPart;
    for (int i = 0; i < kFrames; ++i) {
        if (i == kAdd) id = take(session->add_part(std::move(part)));
        if (i == kRemove) take(session->remove_part(id));
        take(session->render_frame(moved_input(scene, i)));
    }
    require_picture(read_image(own, target.image, kSize_px.width, kSize_px.height));
    session.reset();  // Destroy the session first, because it uses the image.
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
