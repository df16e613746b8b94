// Tests passes whose view is in a buffer that the program provides for each frame slot.
#include <array>
#include <cstring>
#include <utility>

#include "tests/vulkan/executor_fixture.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/handle.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint64_t kViewBytes = 512;

// Descriptor sets with one uniform block, and their pool.
struct BlockSets final : ViewSets {
    DescriptorPoolHandle pool;
    std::vector<VkDescriptorSet> sets;
    [[nodiscard]] VkDescriptorSet set(size_t index) const override { return sets[index]; }
};

// A draw source without draws. Set 0 has one uniform block, the view, which is always in a buffer.
class BlockSource final : public DrawSource {
 public:
    explicit BlockSource(Device& device) : device_(device) {
        const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1,
                                                   VK_SHADER_STAGE_ALL, nullptr};
        VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
        info.bindingCount = 1;
        info.pBindings = &binding;
        VkDescriptorSetLayout layout = VK_NULL_HANDLE;
        EXPECT_EQ(device.fn().vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout),
                  VK_SUCCESS);
        layout_ = {device, layout};
    }
    [[nodiscard]] VkDescriptorSetLayout set_layout(uint32_t set) const override {
        return set == 0 ? layout_.get() : VK_NULL_HANDLE;
    }
    [[nodiscard]] VkDescriptorSet frame_set(uint32_t /*slot*/, std::string_view /*view*/) const override {
        ADD_FAILURE() << "the view is in a buffer";
        return VK_NULL_HANDLE;
    }
    [[nodiscard]] Result<std::unique_ptr<ViewSets>> make_view_sets(
        std::span<const ViewPlace> places) const override {
        const DeviceFunctions& fn = device_.fn();
        const auto count = static_cast<uint32_t>(places.size());
        const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, count};
        VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
        pool_info.maxSets = count;
        pool_info.poolSizeCount = 1;
        pool_info.pPoolSizes = &size;
        VkDescriptorPool pool = VK_NULL_HANDLE;
        EXPECT_EQ(fn.vkCreateDescriptorPool(device_.handle(), &pool_info, nullptr, &pool), VK_SUCCESS);
        auto made = std::make_unique<BlockSets>();
        made->pool = {device_, pool};
        made->sets.resize(count);
        const std::vector<VkDescriptorSetLayout> layouts(count, layout_.get());
        VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
        info.descriptorPool = pool;
        info.descriptorSetCount = count;
        info.pSetLayouts = layouts.data();
        EXPECT_EQ(fn.vkAllocateDescriptorSets(device_.handle(), &info, made->sets.data()), VK_SUCCESS);
        for (uint32_t i = 0; i < count; ++i) {
            const VkDescriptorBufferInfo view{places[i].buffer, places[i].offset_bytes, kViewBytes};
            VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
            write.dstSet = made->sets[i];
            write.descriptorCount = 1;
            write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
            write.pBufferInfo = &view;
            fn.vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
        }
        return std::unique_ptr<ViewSets>(std::move(made));
    }
    uint32_t record(const DrawContext& /*context*/) const override { return 0; }

 private:
    Device& device_;
    SetLayoutHandle layout_;
};

using ViewBuffersVk = ExecutorTest;

// The program has one buffer for each frame slot. Each buffer has two views, whose first number tells the
// slot and the element.
TEST_F(ViewBuffersVk, AnImportHasTheViewsOfItsFrameSlot) {
    write_shader("read.comp", R"(
        layout(local_size_x = 1) in;
        layout(set = 0, binding = 0) uniform View { uint number; } view;
        layout(set = 1, binding = 0) writeonly buffer Dst { uint items[]; } dst;
        void main() { dst.items[0] = view.number; })");
    GraphBuilder builder;
    const ResourceId views = builder.buffer("views", 2 * kViewBytes), words = builder.buffer("words", 16);
    builder.cut(views, {kViewBytes});
    const AccessState between{stage::kComputeShader, access::kUniformRead, Layout::undefined};
    builder.import_as(views, between, between);
    PassDecl& read =
        builder.compute("read", {{"views:list", views, Access::uniform_read, test::one_cell(0, 1), kNoId},
                                 {"dst", words, Access::storage_write, {}, kNoId}});
    use_shader(read, "read.comp", ProgramKind::compute);
    read.groups = {1, 1, 1};
    read.view_use = 0;
    builder.pass("show", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});

    const BlockSource source(device());
    std::array<Buffer, kFramesInFlight> buffers;
    ExecutorInput input = input_for(compile_plan(builder));
    input.draws = &source;
    for (uint32_t slot = 0; slot < kFramesInFlight; ++slot) {
        Result<Buffer> made = Buffer::create(device(), 2 * kViewBytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                             Buffer::Memory::upload, "views");
        ASSERT_TRUE(made.ok());
        buffers[slot] = std::move(*made);
        for (uint32_t element = 0; element < 2; ++element) {
            const uint32_t number = 10 * slot + element;
            std::memcpy(buffers[slot].mapped().data() + element * kViewBytes, &number, sizeof number);
        }
        input.bindings.slot_buffers["views"][slot] = buffers[slot].handle();
    }
    const std::unique_ptr<Executor> executor = executor_for(std::move(input));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> frames = run_frames(*executor, 4);
    ASSERT_EQ(frames.size(), 4u);
    for (uint32_t frame = 0; frame < 4; ++frame)
        EXPECT_EQ(values_of<uint32_t>(frames[frame])[0], 10 * (frame % kFramesInFlight) + 1) << frame;
}

}  // namespace
}  // namespace weft::vk
