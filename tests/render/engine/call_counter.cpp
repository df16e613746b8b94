#include "tests/render/engine/call_counter.h"

#include <atomic>
#include <thread>

namespace weft::test {
namespace {

// Global, because the counting functions are plain functions. They have no access to the CallCounter.
std::thread::id counted_thread;
std::atomic<int64_t> allocations = 0, idle_waits = 0, pipelines = 0, submissions = 0, command_pools = 0;

template <auto Member, std::atomic<int64_t>* Count, class Function>
struct Counted;
template <auto Member, std::atomic<int64_t>* Count, class... Args>
struct Counted<Member, Count, VkResult(VKAPI_PTR*)(Args...)> {
    static inline VkResult(VKAPI_PTR* real)(Args...) = nullptr;
    static VKAPI_ATTR VkResult VKAPI_CALL call(Args... args) {
        if (std::this_thread::get_id() == counted_thread) ++*Count;
        return real(args...);
    }
};

template <auto Member, std::atomic<int64_t>* Count>
void count(vk::DeviceFunctions& table) {
    using By = Counted<Member, Count, std::remove_reference_t<decltype(table.*Member)>>;
    By::real = table.*Member;
    table.*Member = By::call;
}

}  // namespace

CallCounter::CallCounter(vk::Device& device) : device_(device), functions_(device.fn()) {
    using Table = vk::DeviceFunctions;
    Table& table = device.fn();
    counted_thread = std::this_thread::get_id();
    allocations = idle_waits = pipelines = submissions = command_pools = 0;
    count<&Table::vkAllocateMemory, &allocations>(table);
    count<&Table::vkQueueWaitIdle, &idle_waits>(table);
    count<&Table::vkDeviceWaitIdle, &idle_waits>(table);
    count<&Table::vkCreateGraphicsPipelines, &pipelines>(table);
    count<&Table::vkCreateComputePipelines, &pipelines>(table);
    count<&Table::vkQueueSubmit, &submissions>(table);
    count<&Table::vkQueueSubmit2, &submissions>(table);
    count<&Table::vkCreateCommandPool, &command_pools>(table);
}

CallCounter::~CallCounter() {
    device_.fn() = functions_;
}

CallCounts CallCounter::counts() const {
    return {allocations, idle_waits, pipelines, submissions, command_pools};
}

}  // namespace weft::test
