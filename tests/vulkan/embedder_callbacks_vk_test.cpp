// Purpose: tests the functions of an embedding program that Weft calls: the allocator of device memory, the
// locks of queues and the log; and the sizes of memory heaps before the objects of a plan exist.
#include <algorithm>
#include <map>
#include <set>

#include "tests/vulkan/executor_fixture.h"
#include "vulkan/device/functions.h"
#include "weft/vulkan/heap_use.h"
#include "weft/vulkan/native.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

// Allocates each block in the middle of a larger VkDeviceMemory.
class PaddedAllocator final : public MemoryAllocator {
 public:
    explicit PaddedAllocator(Device& device) : device_(device) {}
    ~PaddedAllocator() override { EXPECT_EQ(live, 0); }

    VkResult allocate(const MemoryRequest& request, MemoryBlock& block) override {
        if (fails) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        EXPECT_FALSE(request.name.empty());
        ++contents[request.content];
        const DeviceFunctions& fn = device_.fn();
        VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
        info.allocationSize = request.size_bytes + 2 * request.alignment_bytes;
        info.memoryTypeIndex = request.type;
        VkResult result = fn.vkAllocateMemory(device_.handle(), &info, nullptr, &block.memory);
        if (result != VK_SUCCESS) return result;
        block.offset_bytes = request.alignment_bytes;
        if (request.mapped) {
            void* mapped = nullptr;
            result = fn.vkMapMemory(device_.handle(), block.memory, 0, VK_WHOLE_SIZE, 0, &mapped);
            block.mapped = static_cast<std::byte*>(mapped) + block.offset_bytes;
        }
        block.own = this;
        ++live;
        const uint32_t heap = device_.memory().memoryTypes[request.type].heapIndex;
        bytes[heap] += request.size_bytes;
        ++blocks[heap];
        return result;
    }
    void free(const MemoryBlock& block) override {
        EXPECT_EQ(block.own, this);
        device_.fn().vkFreeMemory(device_.handle(), block.memory, nullptr);
        --live;
    }

    bool fails = false;
    int live = 0;
    std::map<uint32_t, uint64_t> bytes;
    std::map<uint32_t, uint32_t> blocks;
    std::map<MemoryContent, uint32_t> contents;

 private:
    Device& device_;
};

std::multiset<VkQueue> locked_queues;
PFN_vkQueueSubmit unlocked_submit = nullptr;

VKAPI_ATTR VkResult VKAPI_CALL submit_under_lock(VkQueue queue, uint32_t count, const VkSubmitInfo* infos,
                                                 VkFence fence) {
    EXPECT_EQ(locked_queues.count(queue), 1u) << "the queue is locked once";
    return unlocked_submit(queue, count, infos, fence);
}

class EmbedderCallbacksVk : public ExecutorTest {
 protected:
    std::unique_ptr<Device> adopt(const EmbedderCallbacks& callbacks) {
        const NativeDevice own = native(device());
        device().instance_fn().vkGetPhysicalDeviceFeatures2(own.physical, &supported_.head());
        enable_features(supported_, enabled_);
        Result<std::unique_ptr<Device>> adopted =
            Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled_, callbacks});
        EXPECT_TRUE(adopted.ok()) << to_text(adopted.errors());
        return adopted ? std::move(*adopted) : nullptr;
    }

    // Makes a plan with images, a buffer, Params in memory, and a readback.
    FramePlan make_plan(Device& on) {
        write_shader("fill.comp", R"(
            layout(local_size_x = 8, local_size_y = 8) in;
            layout(r32ui) uniform writeonly uimage2D dst;
            layout(std430) writeonly buffer Words { uint words[]; } words;
            uniform Params { uint value; } params;
            void main() {
                imageStore(dst, ivec2(gl_GlobalInvocationID.xy), uvec4(params.value));
                words.words[gl_LocalInvocationIndex] = gl_LocalInvocationIndex;
            })");
        GraphBuilder builder;
        const ResourceId a = builder.image("a", Format::r32u, 8);
        const ResourceId words = builder.buffer("words", 64 * sizeof(uint32_t));
        PassDecl& fill = builder.compute("fill", {{"dst", a, Access::storage_write, {}, kNoId},
                                                  {"words", words, Access::storage_write, {}, kNoId}});
        use_shader(fill, "fill.comp", ProgramKind::compute);
        ParamWrite value;
        value.member = "value";
        value.scalar = ScalarType::u32;
        value.value[0] = 9;
        fill.params = {value};
        builder.pass("read", PassKind::readback, {{"src", a, Access::copy_read, {}, kNoId}});
        builder.pass("read_words", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
        const ResolvedGraph graph = builder.build();
        return compile(graph, query_memory_needs(on, graph), {});
    }

    FeatureChain supported_, enabled_;
};

TEST_F(EmbedderCallbacksVk, memory_comes_from_the_program_and_as_much_as_was_foretold) {
    PaddedAllocator memory(device());
    const std::unique_ptr<Device> adopted = adopt({.memory = &memory});
    ASSERT_NE(adopted, nullptr);
    const FramePlan plan = make_plan(*adopted);
    const Result<std::vector<HeapUse>> foretold = heap_use(*adopted, plan);
    ASSERT_TRUE(foretold.ok()) << to_text(foretold.errors());
    EXPECT_EQ(memory.live, 0) << "no object is created";
    Result<std::unique_ptr<Executor>> executor = Executor::create(*adopted, input_for(plan));
    ASSERT_TRUE(executor.ok()) << to_text(executor.errors());
    ASSERT_FALSE(foretold->empty());
    ASSERT_EQ(foretold->size(), memory.bytes.size());
    for (const HeapUse& use : *foretold) {
        EXPECT_EQ(use.size_bytes, memory.bytes[use.heap]);
        EXPECT_EQ(use.allocations, memory.blocks[use.heap]);
    }
    std::set<size_t> with_image;
    for (const Placement& placement : plan.memory.placements)
        if (plan.graph.resources[placement.resource].kind == ResourceKind::image)
            with_image.insert(placement.heap);
    EXPECT_EQ(memory.contents[MemoryContent::images] + memory.contents[MemoryContent::both],
              with_image.size());
    EXPECT_GT(memory.contents[MemoryContent::buffers], 0u) << "those for Params and readbacks";
    const NativeResource image = (*executor)->native(find_resource(plan.graph, "a"));
    EXPECT_GT(image.offset_bytes, 0u) << "the offset of the block counts";
    const std::vector<ReadbackData> read = run_frames(**executor, 3);
    ASSERT_EQ(read.size(), 6u);
    EXPECT_EQ(values_of<uint32_t>(read[0]), std::vector<uint32_t>(64, 9));
    EXPECT_EQ(values_of<uint32_t>(read[1])[63], 63u);
}

TEST_F(EmbedderCallbacksVk, an_allocator_without_memory_is_an_error_that_names_the_object) {
    PaddedAllocator memory(device());
    const std::unique_ptr<Device> adopted = adopt({.memory = &memory});
    ASSERT_NE(adopted, nullptr);
    memory.fails = true;
    const Result<Buffer> buffer =
        Buffer::create(*adopted, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Buffer::Memory::upload, "lights");
    const Result<std::unique_ptr<Executor>> executor =
        Executor::create(*adopted, input_for(make_plan(*adopted)));
    ASSERT_FALSE(buffer.ok());
    EXPECT_EQ(buffer.errors()[0].code, "V410");
    EXPECT_NE(buffer.errors()[0].message.find("\"lights\""), std::string::npos);
    ASSERT_FALSE(executor.ok());
    EXPECT_EQ(executor.errors()[0].code, "V410");
}

TEST_F(EmbedderCallbacksVk, each_use_of_a_queue_is_locked) {
    locked_queues.clear();
    uint32_t locks = 0;
    EmbedderCallbacks callbacks;
    callbacks.lock_queue = [&](VkQueue queue) {
        locked_queues.insert(queue);
        ++locks;
    };
    callbacks.unlock_queue = [](VkQueue queue) { locked_queues.erase(queue); };
    const std::unique_ptr<Device> adopted = adopt(callbacks);
    ASSERT_NE(adopted, nullptr);
    unlocked_submit = std::exchange(adopted->fn().vkQueueSubmit, submit_under_lock);
    Result<Buffer> buffer =
        Buffer::create(*adopted, 16, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Buffer::Memory::device, "uploaded");
    ASSERT_TRUE(buffer.ok());
    const std::array<std::byte, 16> bytes{};
    EXPECT_TRUE(upload_buffer(*adopted, *buffer, bytes).ok());
    EXPECT_EQ(locks, 1u);
    Result<std::unique_ptr<Executor>> executor = Executor::create(*adopted, input_for(make_plan(*adopted)));
    ASSERT_TRUE(executor.ok());
    EXPECT_EQ(run_frames(**executor, 3).size(), 6u);
    EXPECT_EQ(locks, 4u);
    EXPECT_TRUE(locked_queues.empty());
}

TEST_F(EmbedderCallbacksVk, the_log_gets_messages_of_the_validation_layer_and_errors) {
    std::vector<Message> logged;
    EmbedderCallbacks callbacks;
    callbacks.log = [&](const Message& message) { logged.push_back(message); };
    std::unique_ptr<Device> adopted = adopt(callbacks);
    ASSERT_NE(adopted, nullptr);
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.code = "W1";
    warning.message = "old";
    Diagnostics warnings{warning, warning};
    warnings[1].message = "new";
    adopted->log(warnings, 1);
    ASSERT_EQ(logged.size(), 1u);
    EXPECT_EQ(logged[0].severity, MessageSeverity::warning);
    EXPECT_NE(logged[0].text.find("new"), std::string::npos);

    adopted->messages().set_current_pass("blur");
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;  // The size 0 is not allowed.
    VkBuffer buffer = VK_NULL_HANDLE;
    (void)adopted->fn().vkCreateBuffer(adopted->handle(), &info, nullptr, &buffer);
    ASSERT_EQ(logged.size(), 2u);
    EXPECT_EQ(logged[1].severity, MessageSeverity::error);
    EXPECT_EQ(logged[1].pass, "blur");
    EXPECT_EQ(adopted->messages().count(), 0u) << "messages go to the log and are not stored";
    adopted->fn().vkDestroyBuffer(adopted->handle(), buffer, nullptr);
    adopted.reset();
    (void)device().fn().vkCreateBuffer(device().handle(), &info, nullptr, &buffer);
    EXPECT_EQ(logged.size(), 2u) << "after the Device is destroyed, nothing is logged";
    device().fn().vkDestroyBuffer(device().handle(), buffer, nullptr);
    EXPECT_EQ(destroy_device(take_device()).size(), 2u) << "both messages, of the messenger of the test";
}

VKAPI_ATTR VkResult VKAPI_CALL lost_at_wait(VkDevice, uint32_t, const VkFence*, VkBool32, uint64_t) {
    return VK_ERROR_DEVICE_LOST;
}

// A device can also be lost where no frame is waited for by begin_frame(): the destructor notices it then.
TEST_F(EmbedderCallbacksVk, after_the_loss_of_the_device_everything_is_destroyed) {
    for (const bool noticed : {true, false}) {
        std::vector<Message> logged;
        EmbedderCallbacks callbacks;
        callbacks.log = [&](const Message& message) { logged.push_back(message); };
        const std::unique_ptr<Device> adopted = adopt(callbacks);
        ASSERT_NE(adopted, nullptr);
        Result<std::unique_ptr<Executor>> executor =
            Executor::create(*adopted, input_for(make_plan(*adopted)));
        ASSERT_TRUE(executor.ok());
        ASSERT_TRUE((*executor)->begin_frame().ok());
        ASSERT_TRUE((*executor)->run({}).ok());
        // The device is not really lost, so the frame must finish before its objects are destroyed.
        ASSERT_EQ(device().fn().vkDeviceWaitIdle(device().handle()), VK_SUCCESS);
        adopted->fn().vkWaitForFences = lost_at_wait;
        if (noticed) {
            const Status finished = (*executor)->finish();
            ASSERT_FALSE(finished.ok());
            EXPECT_EQ(finished.errors()[0].code, "V408");
            EXPECT_NE(to_text(finished.errors()).find("create them again"), std::string::npos);
            ASSERT_EQ(logged.size(), 1u);
            EXPECT_EQ(logged[0].id, "V408");
        }
        executor->reset();
        EXPECT_FALSE(adopted->abandoned())
            << "the objects are destroyed, and the test device reports no leak";
    }
}

}  // namespace
}  // namespace weft::vk
