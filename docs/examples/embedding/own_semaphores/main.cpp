// An example of frames that Weft submits between two submissions of the program. Binary semaphores order the
// three, as for an image of a swapchain: the frame waits for `acquired` and signals `rendered`.
// Usage: own_semaphores [--validate]
#include <weft/registry.h>
#include <weft/scene/builtin_scenes.h>
#include <weft/vulkan/device.h>

#include "sample.h"

namespace {

constexpr int kFrames = 4;

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px));
    const weft::scene::Scene scene = take(weft::scene::make_builtin("spheres"));
    const weft::PassCatalog passes = weft::registered_passes();
    weft::render::SessionInput input = session_input("deferred.json", passes);
    input.output = target.image;
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, scene, input, warnings));
    const OwnCommands commands(own);
    for (int i = 0; i < kFrames; ++i) {
        // Stands for vkAcquireNextImageKHR(), which signals a binary semaphore.
        commands.submit(commands.begin(), VK_NULL_HANDLE, commands.acquired, 0);
        weft::render::FrameInput frame = frame_input(scene, i);
        frame.submit.waits = {{commands.acquired, 0, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, "backbuffer"}};
        frame.submit.signals = {{commands.rendered}, {commands.timeline, static_cast<uint64_t>(i) + 1}};
        take(session->render_frame(frame));
        // Stands for vkQueuePresentKHR(), which waits for a binary semaphore.
        commands.submit(commands.begin(), commands.rendered, VK_NULL_HANDLE, 0);
    }
    commands.wait_for(kFrames);
    require_picture(read_image(own, target.image, kSize_px.width, kSize_px.height));
    session.reset();
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
