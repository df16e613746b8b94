// An example of a program that submits everything itself: Weft records each frame into a command buffer of
// the program, and the program tells by a timeline semaphore when the frame has finished.
// Usage: own_command_buffer [--validate]
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
        weft::render::FrameInput frame = frame_input(scene, i);
        const uint64_t value = static_cast<uint64_t>(i) + 1;
        frame.submit.commands = commands.begin();
        frame.submit.ticket = {commands.timeline, value};
        // The program may record commands of its own before and after the frame.
        take(session->render_frame(frame));
        commands.submit(frame.submit.commands, VK_NULL_HANDLE, commands.timeline, value);
    }
    take(session->finish());  // Waits for the tickets of the frames in flight.
    require_picture(read_image(own, target.image, kSize_px.width, kSize_px.height));
    session.reset();
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
