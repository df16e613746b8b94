// Purpose: command buffers and a timeline semaphore of a program, for frames that the program submits itself.
#pragma once

#include <gtest/gtest.h>

#include "vulkan/device/functions.h"
#include "vulkan/device/handle.h"
#include "weft/vulkan/device.h"
#include "weft/vulkan/frame_submit.h"

namespace weft::test {

class OwnCommands {
 public:
    explicit OwnCommands(vk::Device& device) : device_(device) {
        VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
        info.queueFamilyIndex = device.queue().family;
        VkCommandPool pool = VK_NULL_HANDLE;
        EXPECT_EQ(device.fn().vkCreateCommandPool(device.handle(), &info, nullptr, &pool), VK_SUCCESS);
        pool_ = {device, pool};
        VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
        type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
        VkSemaphoreCreateInfo semaphore_info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
        semaphore_info.pNext = &type;
        VkSemaphore semaphore = VK_NULL_HANDLE;
        EXPECT_EQ(device.fn().vkCreateSemaphore(device.handle(), &semaphore_info, nullptr, &semaphore),
                  VK_SUCCESS);
        timeline_ = {device, semaphore};
    }

    // Begins a command buffer, and returns it with the ticket of its submission.
    vk::FrameSubmit begin() {
        VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
        info.commandPool = pool_.get();
        info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        info.commandBufferCount = 1;
        EXPECT_EQ(device_.fn().vkAllocateCommandBuffers(device_.handle(), &info, &commands_), VK_SUCCESS);
        VkCommandBufferBeginInfo begin_info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
        EXPECT_EQ(device_.fn().vkBeginCommandBuffer(commands_, &begin_info), VK_SUCCESS);
        return {commands_, {timeline_.get(), ++value_}};
    }
    // Ends and submits the command buffer, which signals the ticket.
    void submit() {
        EXPECT_EQ(device_.fn().vkEndCommandBuffer(commands_), VK_SUCCESS);
        VkTimelineSemaphoreSubmitInfo values{VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO};
        values.signalSemaphoreValueCount = 1;
        values.pSignalSemaphoreValues = &value_;
        const VkSemaphore semaphore = timeline_.get();
        VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
        info.pNext = &values;
        info.commandBufferCount = 1;
        info.pCommandBuffers = &commands_;
        info.signalSemaphoreCount = 1;
        info.pSignalSemaphores = &semaphore;
        EXPECT_EQ(device_.fn().vkQueueSubmit(device_.queue().handle, 1, &info, VK_NULL_HANDLE), VK_SUCCESS);
    }

 private:
    vk::Device& device_;
    vk::CommandPoolHandle pool_;
    vk::SemaphoreHandle timeline_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    uint64_t value_ = 0;
};

}  // namespace weft::test
