// An example of two sessions on one device, for example for the game and for a preview in its editor. They
// render alternately and share their pipelines.
// Usage: two_sessions [--validate]
#include <weft/registry.h>
#include <weft/scene/builtin_scenes.h>
#include <weft/vulkan/device.h>
#include <weft/vulkan/shared_pipelines.h>

#include "sample.h"

namespace {

struct View {
    weft::scene::Scene scene;
    OwnImage target;
    std::unique_ptr<weft::render::Session> session;
};

View make_view(const OwnDevice& own, weft::vk::Device& device, const char* scene,
               weft::render::SessionInput input) {
    View view;
    view.scene = take(weft::scene::make_builtin(scene));
    view.target = make_image(own, weft::render::output_create_info(device, kSize_px));
    input.output = view.target.image;
    weft::Diagnostics warnings;
    view.session = take(weft::render::Session::create(device, view.scene, input, warnings));
    return view;
}

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const weft::PassCatalog passes = weft::registered_passes();
    weft::vk::SharedPipelines pipelines;  // Must be destroyed after the sessions and before the device.
    weft::render::SessionInput input = session_input("deferred.json", passes);
    input.pipelines = &pipelines;
    View game = make_view(own, *device, "spheres", input);
    View preview = make_view(own, *device, "brushed", input);
    for (int i = 0; i < 3; ++i) {
        take(game.session->render_frame(frame_input(game.scene, i)));
        take(preview.session->render_frame(frame_input(preview.scene, i)));
    }
    const auto first = read_image(own, game.target.image, kSize_px.width, kSize_px.height);
    const auto second = read_image(own, preview.target.image, kSize_px.width, kSize_px.height);
    require_picture(first);
    require_picture(second);
    if (first == second) throw std::runtime_error("the pictures of different scenes are equal");
    for (View* view : {&game, &preview}) {
        view->session.reset();
        destroy_image(own, view->target);
    }
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
