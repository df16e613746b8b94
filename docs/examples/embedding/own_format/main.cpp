// An example of an output like the image of a swapchain: its format is BGRA8, its only usages are colour
// attachment and copy source, and after the frame it has another layout than by default.
// Usage: own_format [--validate]
#include <weft/registry.h>
#include <weft/scene/builtin_scenes.h>
#include <weft/vulkan/device.h>

#include "sample.h"

namespace {

// Brings the image to the layout in which read_image() copies it.
void make_copyable(const OwnDevice& own, VkImage image) {
    const OwnCommands commands(own);
    const VkCommandBuffer buffer = commands.begin();
    VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(buffer, VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                         VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
    commands.submit(buffer, VK_NULL_HANDLE, VK_NULL_HANDLE, 0);
}

void draw(OwnDevice& own) {
    const std::unique_ptr<weft::vk::Device> device = take(weft::vk::Device::adopt(
        {own.instance, own.physical, own.device, {{own.queue, own.family}}, &own.enabled}));
    weft::OutputFormat format;
    format.format = weft::Format::bgra8;
    format.final_layout = weft::Layout::color_attachment;
    format.usage = weft::usage::kColorAttachment | weft::usage::kTransferSrc;
    const OwnImage target = make_image(own, weft::render::output_create_info(*device, kSize_px, format));
    const weft::scene::Scene scene = take(weft::scene::make_builtin("spheres"));
    const weft::PassCatalog passes = weft::registered_passes();
    weft::render::SessionInput input = session_input("deferred.json", passes);
    input.request.output = format;
    input.output = target.image;
    weft::Diagnostics warnings;
    std::unique_ptr<weft::render::Session> session =
        take(weft::render::Session::create(*device, scene, input, warnings));
    for (int i = 0; i < 3; ++i) take(session->render_frame(frame_input(scene, i)));
    make_copyable(own, target.image);
    require_picture(read_image(own, target.image, kSize_px.width, kSize_px.height));
    session.reset();
    destroy_image(own, target);
}

}  // namespace

int main(int argc, char** argv) {
    return run_sample(argc, argv, draw);
}
