#include "sample.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

namespace {

void require(VkResult result, const char* what) {
    if (result != VK_SUCCESS)
        throw std::runtime_error(std::string(what) + " failed: " + std::to_string(result));
}

VkSemaphore make_semaphore(const OwnDevice& own, VkSemaphoreType kind) {
    VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
    type.semaphoreType = kind;
    VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    info.pNext = &type;
    VkSemaphore semaphore = VK_NULL_HANDLE;
    require(vkCreateSemaphore(own.device, &info, nullptr, &semaphore), "vkCreateSemaphore");
    return semaphore;
}

}  // namespace

std::optional<std::string> read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return file ? std::optional(text.str()) : std::nullopt;
}

weft::render::SessionInput session_input(const std::string& graph, const weft::PassCatalog& passes) {
    const std::filesystem::path data = WEFT_DATA_DIR;
    weft::render::SessionInput input;
    input.request.path = data / "graphs" / graph;
    input.request.size = kSize_px;
    input.load.graph_root = data / "graphs";
    input.load.shader_root = data / "shaders";
    input.load.reader = read_file;
    input.passes = &passes;
    return input;
}

weft::render::FrameInput frame_input(const weft::scene::Scene& scene, int frame) {
    weft::render::FrameInput input{scene.cameras.front(), scene.exposure_ev};
    input.delta_time_s = 1.0 / 60.0;
    input.time_s = frame * input.delta_time_s;
    return input;
}

OwnCommands::OwnCommands(const OwnDevice& own)
    : timeline(make_semaphore(own, VK_SEMAPHORE_TYPE_TIMELINE)),
      acquired(make_semaphore(own, VK_SEMAPHORE_TYPE_BINARY)),
      rendered(make_semaphore(own, VK_SEMAPHORE_TYPE_BINARY)),
      own_(own) {
    VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    info.queueFamilyIndex = own.family;
    require(vkCreateCommandPool(own.device, &info, nullptr, &pool_), "vkCreateCommandPool");
}

OwnCommands::~OwnCommands() {
    vkQueueWaitIdle(own_.queue);
    vkDestroyCommandPool(own_.device, pool_, nullptr);
    for (VkSemaphore semaphore : {timeline, acquired, rendered})
        vkDestroySemaphore(own_.device, semaphore, nullptr);
}

VkCommandBuffer OwnCommands::begin() const {
    VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    info.commandPool = pool_;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    require(vkAllocateCommandBuffers(own_.device, &info, &commands), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    require(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    return commands;
}

void OwnCommands::submit(VkCommandBuffer commands, VkSemaphore wait, VkSemaphore signal,
                         uint64_t value) const {
    require(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    VkTimelineSemaphoreSubmitInfo values{VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO};
    values.signalSemaphoreValueCount = 1;
    values.pSignalSemaphoreValues = &value;
    VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    info.pNext = value != 0 ? &values : nullptr;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands;
    info.waitSemaphoreCount = wait != VK_NULL_HANDLE ? 1 : 0;
    info.pWaitSemaphores = &wait;
    info.pWaitDstStageMask = &stage;
    info.signalSemaphoreCount = signal != VK_NULL_HANDLE ? 1 : 0;
    info.pSignalSemaphores = &signal;
    require(vkQueueSubmit(own_.queue, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit");
}

void OwnCommands::wait_for(uint64_t value) const {
    VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
    info.semaphoreCount = 1;
    info.pSemaphores = &timeline;
    info.pValues = &value;
    require(vkWaitSemaphores(own_.device, &info, UINT64_MAX), "vkWaitSemaphores");
}

void paint_image(const OwnDevice& own, VkImage image, const std::array<float, 4>& color) {
    const OwnCommands commands(own);
    const VkCommandBuffer recorded = commands.begin();
    VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(recorded, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0,
                         nullptr, 0, nullptr, 1, &barrier);
    const VkClearColorValue colour{{color[0], color[1], color[2], color[3]}};
    vkCmdClearColorImage(recorded, image, barrier.newLayout, &colour, 1, &barrier.subresourceRange);
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    vkCmdPipelineBarrier(recorded, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, 0,
                         0, nullptr, 0, nullptr, 1, &barrier);
    commands.submit(recorded, VK_NULL_HANDLE, commands.timeline, 1);
    commands.wait_for(1);
}

int run_sample(int argc, char** argv, void (*sample)(OwnDevice& own)) {
    try {
        OwnDevice own(argc > 1 && std::strcmp(argv[1], "--validate") == 0);
        sample(own);
        own.destroy();
        return own.messages == 0 ? 0 : 5;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 1;
    }
}

void require_picture(const std::vector<uint8_t>& texels) {
    for (size_t i = 4; i < texels.size(); ++i)
        if (texels[i] != texels[i % 4]) return;
    throw std::runtime_error("the picture is empty");
}
