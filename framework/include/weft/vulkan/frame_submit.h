// Purpose: how a frame reaches the GPU. By default, Weft submits its own command buffers. A program can also
// let these submissions wait for and signal semaphores of its own, or let Weft record the frame into a
// command buffer of the program, which the program then submits itself.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <string>
#include <vector>

namespace weft::vk {

// A semaphore of the program for which a frame waits. The program must submit the signal before the frame,
// unless the semaphore is a timeline semaphore.
struct SemaphoreWait {
    VkSemaphore semaphore = VK_NULL_HANDLE;
    uint64_t value = 0;  // Only for a timeline semaphore; ignored for a binary one.
    // The stages of the frame that wait. For a swapchain image that only the last pass writes, as a colour
    // attachment, VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT is enough.
    VkPipelineStageFlags stages = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    // Name of an import. If a frame has several submissions, the wait begins with the submission that first
    // uses the import; earlier submissions do not wait. Empty, or an import that passes on several queues
    // use: the whole frame waits.
    std::string import = {};
};

// A semaphore of the program that is signalled when all commands of the frame have finished.
struct SemaphoreSignal {
    VkSemaphore semaphore = VK_NULL_HANDLE;
    uint64_t value = 0;  // Only for a timeline semaphore; ignored for a binary one.
};

// A promise of the program: the timeline semaphore will reach the value when the commands of the frame have
// finished. Either the submission of these commands signals the value, or the program calls
// vkSignalSemaphore().
struct FrameTicket {
    VkSemaphore timeline = VK_NULL_HANDLE;
    uint64_t value = 0;
};

struct FrameSubmit {
    // A primary command buffer in recording state, without an active render pass, of the family of the
    // device's first queue. Not null: Weft records the frame into it and submits nothing. The program ends
    // and submits it, in the order of the frames, to the first queue. Only plans with one batch allow this
    // (V422): let SessionInput::queues be 1.
    VkCommandBuffer commands = VK_NULL_HANDLE;
    // Required with `commands` (V423). Weft waits for the ticket before it uses the frame slot again, after
    // kFramesInFlight frames, and in finish(). An overdue ticket is a time-out (V407).
    FrameTicket ticket = {};
    // Only without `commands` (V423). The semaphores must be different from each other.
    std::vector<SemaphoreWait> waits = {};
    std::vector<SemaphoreSignal> signals = {};
};

}  // namespace weft::vk
