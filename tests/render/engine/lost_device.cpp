#include "tests/render/engine/lost_device.h"

#include "vulkan/device/functions.h"

namespace weft::test {
namespace {

// Global, because the replaced functions are plain functions.
vk::DeviceFunctions working;  // The original functions.
VkDevice lost_handle = VK_NULL_HANDLE;
bool is_lost = false;
Loss noticed_in = Loss::none;
int submits_left = 0;  // Number of submissions before the loss.

// The work that is submitted already must end before its objects are destroyed, because the device is not
// really lost.
VkResult fail() {
    if (!is_lost) static_cast<void>(working.vkDeviceWaitIdle(lost_handle));
    is_lost = true;
    return VK_ERROR_DEVICE_LOST;
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, uint32_t count, const VkSubmitInfo* infos,
                                      VkFence fence) {
    if (is_lost || (noticed_in != Loss::in_wait && submits_left-- == 0)) return fail();
    return working.vkQueueSubmit(queue, count, infos, fence);
}

// Replaces a function that waits.
template <auto Member, class Function>
struct WaitOf;
template <auto Member, class... Args>
struct WaitOf<Member, VkResult(VKAPI_PTR*)(Args...)> {
    static VKAPI_ATTR VkResult VKAPI_CALL call(Args... args) {
        if (is_lost || noticed_in == Loss::in_wait) return fail();
        return (working.*Member)(args...);
    }
};

// Replaces a function that does not notice the loss first.
template <auto Member, class Function>
struct QueryOf;
template <auto Member, class... Args>
struct QueryOf<Member, VkResult(VKAPI_PTR*)(Args...)> {
    static VKAPI_ATTR VkResult VKAPI_CALL call(Args... args) {
        return is_lost ? VK_ERROR_DEVICE_LOST : (working.*Member)(args...);
    }
};

template <template <auto, class> class By, auto Member>
void replace(vk::DeviceFunctions& table) {
    table.*Member = By<Member, std::remove_reference_t<decltype(table.*Member)>>::call;
}

}  // namespace

void lose_device(vk::Device& device, Loss loss) {
    using Table = vk::DeviceFunctions;
    Table& table = device.fn();
    working = table;
    lost_handle = device.handle();
    is_lost = false;
    noticed_in = loss;
    submits_left = loss == Loss::in_second_submit ? 1 : 0;
    table.vkQueueSubmit = submit;
    replace<WaitOf, &Table::vkWaitForFences>(table);
    replace<WaitOf, &Table::vkWaitSemaphores>(table);
    replace<QueryOf, &Table::vkGetFenceStatus>(table);
    replace<QueryOf, &Table::vkGetSemaphoreCounterValue>(table);
    replace<QueryOf, &Table::vkQueueWaitIdle>(table);
    replace<QueryOf, &Table::vkDeviceWaitIdle>(table);
}

}  // namespace weft::test
