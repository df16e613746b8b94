// Purpose: tests that buffers and images contain the data that were uploaded to them. Every failure must be
// an error with a code and must not leak objects.
#include "weft/vulkan/memory.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <numeric>

#include "tests/vulkan/device_fixture.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"
#include "vulkan/device/to_vk.h"

namespace weft::vk {
namespace {

using MemoryVk = DeviceTest;

std::vector<std::byte> counted_bytes(size_t count) {
    std::vector<std::byte> bytes(count);
    for (size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>(i * 7 + i / 251);
    return bytes;
}

ResourceDecl image_decl(Format format, Extent3D extent, uint32_t mips, uint32_t layers) {
    ResourceDecl decl;
    decl.name = "albedo";
    decl.lifetime = ResourceLifetime::imported;
    decl.format = format;
    decl.extent = extent;
    decl.mips = mips;
    decl.layers = layers;
    decl.usage = usage::kSampled | usage::kTransferSrc | usage::kTransferDst;
    return decl;
}

// Returns the content of one mip of an image that was just uploaded.
std::vector<std::byte> read_back(Device& device, const Image& image, uint32_t mip, size_t size_bytes) {
    Result<Buffer> target = Buffer::create(device, size_bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                           Buffer::Memory::readback, "readback");
    EXPECT_TRUE(target.ok());
    const ResourceDecl& decl = image.decl();
    const Status status = immediate_submit(device, "reading back", [&](VkCommandBuffer commands) {
        VkImageMemoryBarrier2 barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
        barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        barrier.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
        barrier.oldLayout =
            to_vk(decl.aspects == aspect::kColor ? Layout::shader_read_only : Layout::depth_read_only);
        barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        barrier.image = image.handle();
        barrier.subresourceRange = to_vk(SubresourceRange{mip, 1, 0, decl.layers, decl.aspects});
        VkDependencyInfo dependency{};
        dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
        dependency.imageMemoryBarrierCount = 1;
        dependency.pImageMemoryBarriers = &barrier;
        device.fn().vkCmdPipelineBarrier2(commands, &dependency);
        VkBufferImageCopy copy{};
        copy.imageSubresource = layers_to_vk({mip, 1, 0, decl.layers, decl.aspects});
        copy.imageExtent = to_vk(mip_extent(decl.extent, mip));
        device.fn().vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                           target->handle(), 1, &copy);
    });
    EXPECT_TRUE(status.ok());
    return {target->mapped().begin(), target->mapped().end()};
}

TEST_F(MemoryVk, a_buffer_holds_what_was_uploaded) {
    const std::vector<std::byte> bytes = counted_bytes(1000);
    Result<Buffer> buffer =
        Buffer::create(device(), 1000, VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                       Buffer::Memory::device, "instances");
    Result<Buffer> target = Buffer::create(device(), 1000, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                           Buffer::Memory::readback, "readback");
    ASSERT_TRUE(buffer.ok() && target.ok());
    ASSERT_TRUE(upload_buffer(device(), *buffer, bytes).ok());
    const Status status = immediate_submit(device(), "reading back", [&](VkCommandBuffer commands) {
        const VkBufferCopy region{0, 0, 1000};
        device().fn().vkCmdCopyBuffer(commands, buffer->handle(), target->handle(), 1, &region);
    });
    ASSERT_TRUE(status.ok());
    EXPECT_EQ(std::memcmp(target->mapped().data(), bytes.data(), bytes.size()), 0);
}

TEST_F(MemoryVk, every_mip_and_layer_holds_what_was_uploaded) {
    // Mip 0 has 13 × 7 texels × 4 bytes × 2 layers = 728 bytes. This is not a multiple of the alignment in
    // the staging buffer (16 bytes), so there is a gap before mip 1.
    const ResourceDecl decl = image_decl(Format::rgba8, {13, 7, 1}, 3, 2);
    ResourceDecl array = decl;
    array.image_kind = ImageKind::d2_array;
    Result<Image> image = Image::create(device(), array);
    ASSERT_TRUE(image.ok()) << to_text(image.errors());
    EXPECT_NE(image->view(), VK_NULL_HANDLE);
    const std::array<std::vector<std::byte>, 3> levels{
        counted_bytes(13 * 7 * 4 * 2), counted_bytes(6 * 3 * 4 * 2), counted_bytes(3 * 1 * 4 * 2)};
    const std::array<std::span<const std::byte>, 3> spans{levels[0], levels[1], levels[2]};
    const Status status = upload_image(device(), *image, spans);
    ASSERT_TRUE(status.ok()) << to_text(status.errors());
    for (uint32_t mip = 0; mip < 3; ++mip) {
        EXPECT_EQ(read_back(device(), *image, mip, levels[mip].size()), levels[mip]) << "mip " << mip;
    }
}

TEST_F(MemoryVk, depth_and_cubes_can_be_uploaded_and_viewed) {
    ResourceDecl depth = image_decl(Format::d32f, {5, 3, 1}, 1, 1);
    depth.aspects = aspect::kDepth;
    Result<Image> depth_image = Image::create(device(), depth);
    ASSERT_TRUE(depth_image.ok()) << to_text(depth_image.errors());
    const std::array<float, 15> values{0.f, .25f, .5f, .75f, 1.f};
    const std::array<std::span<const std::byte>, 1> level{std::as_bytes(std::span(values))};
    ASSERT_TRUE(upload_image(device(), *depth_image, level).ok());
    const std::vector<std::byte> read = read_back(device(), *depth_image, 0, sizeof(values));
    EXPECT_EQ(std::memcmp(read.data(), values.data(), sizeof(values)), 0);

    ResourceDecl cube = image_decl(Format::rgba16f, {8, 8, 1}, 4, 6);
    cube.image_kind = ImageKind::cube;
    const Result<Image> cube_image = Image::create(device(), cube);
    ASSERT_TRUE(cube_image.ok()) << to_text(cube_image.errors());
    EXPECT_NE(cube_image->view(), VK_NULL_HANDLE);
}

TEST_F(MemoryVk, an_image_that_is_only_copied_has_no_view) {
    ResourceDecl decl = image_decl(Format::rgba8, {4, 4, 1}, 1, 1);
    decl.usage = usage::kTransferSrc | usage::kTransferDst;
    const Result<Image> image = Image::create(device(), decl);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->view(), VK_NULL_HANDLE);
}

TEST_F(MemoryVk, moving_leaves_one_owner) {
    Result<Buffer> made =
        Buffer::create(device(), 16, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Buffer::Memory::upload, "a");
    ASSERT_TRUE(made.ok());
    Buffer first = std::move(*made);
    Buffer second;
    second = std::move(first);
    EXPECT_EQ(first.handle(), VK_NULL_HANDLE);
    EXPECT_EQ(second.mapped().size(), 16u);
    EXPECT_TRUE(Buffer{}.mapped().empty());
}

TEST_F(MemoryVk, sizes_that_do_not_match_are_errors) {
    Result<Image> image = Image::create(device(), image_decl(Format::rgba8, {4, 4, 1}, 2, 1));
    ASSERT_TRUE(image.ok());
    const std::vector<std::byte> bytes = counted_bytes(64);
    const std::array<std::span<const std::byte>, 2> wrong_mip{bytes, bytes};
    const Status status = upload_image(device(), *image, wrong_mip);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.errors().front().code, "V420");
    EXPECT_EQ(status.errors().front().message, "mip 1 of \"albedo\" has 64 bytes; wanted 16");
    EXPECT_FALSE(upload_image(device(), *image, {}).ok());

    Result<Buffer> small =
        Buffer::create(device(), 16, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Buffer::Memory::device, "small");
    ASSERT_TRUE(small.ok());
    EXPECT_EQ(upload_buffer(device(), *small, bytes).errors().front().code, "V420");
}

TEST_F(MemoryVk, images_beyond_the_device_are_refused_before_they_are_made) {
    for (const ResourceDecl& decl :
         {image_decl(Format::rgba8, {1u << 20, 1, 1}, 1, 1), image_decl(Format::rgba8, {4, 4, 1}, 9, 1),
          image_decl(Format::rgba8, {4, 4, 1}, 1, 1u << 20)}) {
        const Result<Image> image = Image::create(device(), decl);
        ASSERT_FALSE(image.ok());
        EXPECT_EQ(image.errors().front().code, "V421");
    }
}

VkResult VKAPI_CALL out_of_memory(VkDevice, const VkMemoryAllocateInfo*, const VkAllocationCallbacks*,
                                  VkDeviceMemory*) {
    return VK_ERROR_OUT_OF_DEVICE_MEMORY;
}

TEST_F(MemoryVk, running_out_of_memory_is_a_typed_error_and_leaks_nothing) {
    const PFN_vkAllocateMemory real = device().fn().vkAllocateMemory;
    device().fn().vkAllocateMemory = out_of_memory;
    const Result<Buffer> buffer =
        Buffer::create(device(), 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Buffer::Memory::device, "lights");
    const Result<Image> image = Image::create(device(), image_decl(Format::rgba8, {4, 4, 1}, 1, 1));
    device().fn().vkAllocateMemory = real;
    ASSERT_FALSE(buffer.ok());
    EXPECT_EQ(buffer.errors().front().code, "V410");
    EXPECT_NE(buffer.errors().front().message.find("lights"), std::string::npos);
    ASSERT_FALSE(image.ok());
    EXPECT_EQ(image.errors().front().code, "V410");
}

VkResult VKAPI_CALL device_lost(VkQueue, uint32_t, const VkSubmitInfo*, VkFence) {
    return VK_ERROR_DEVICE_LOST;
}

TEST_F(MemoryVk, a_lost_device_is_a_typed_error_and_leaks_nothing) {
    Result<Buffer> buffer =
        Buffer::create(device(), 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Buffer::Memory::device, "lights");
    ASSERT_TRUE(buffer.ok());
    const PFN_vkQueueSubmit real = device().fn().vkQueueSubmit;
    device().fn().vkQueueSubmit = device_lost;
    const Status status = upload_buffer(device(), *buffer, counted_bytes(64));
    device().fn().vkQueueSubmit = real;
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.errors().front().code, "V408");
}

VkResult VKAPI_CALL never_ready(VkDevice, uint32_t, const VkFence*, VkBool32, uint64_t) {
    return VK_TIMEOUT;
}

TEST_F(MemoryVk, a_time_out_is_a_typed_error_after_which_nothing_is_destroyed) {
    std::unique_ptr<Device> owned = take_device();
    {
        Result<Buffer> buffer =
            Buffer::create(*owned, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Buffer::Memory::device, "lights");
        ASSERT_TRUE(buffer.ok());
        const PFN_vkWaitForFences real = owned->fn().vkWaitForFences;
        owned->fn().vkWaitForFences = never_ready;
        const Status status = upload_buffer(*owned, *buffer, counted_bytes(64));
        owned->fn().vkWaitForFences = real;
        ASSERT_FALSE(status.ok());
        EXPECT_EQ(status.errors().front().code, "V407");
        ASSERT_EQ(owned->fn().vkDeviceWaitIdle(owned->handle()), VK_SUCCESS);
    }
    EXPECT_TRUE(owned->abandoned());
    // After the time-out, destroy_device() does not destroy the device and only returns the messages of the
    // validation layer. There must be none.
    EXPECT_TRUE(destroy_device(std::move(owned)).empty());
}

TEST(CreationInfo, follows_the_declaration) {
    ResourceDecl decl = image_decl(Format::rgba16f, {64, 64, 1}, 7, 6);
    decl.image_kind = ImageKind::cube;
    VkImageCreateInfo info = image_create_info(decl);
    EXPECT_EQ(info.flags, static_cast<VkImageCreateFlags>(VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT));
    EXPECT_EQ(info.mipLevels, 7u);
    EXPECT_EQ(info.arrayLayers, 6u);
    decl.image_kind = ImageKind::d2_array;
    // A transient image may share memory with another image, but no pass reads the texels of one image
    // through the other image. So VK_IMAGE_CREATE_ALIAS_BIT is not needed.
    decl.lifetime = ResourceLifetime::transient;
    info = image_create_info(decl);
    EXPECT_EQ(info.flags, 0u);

    ResourceDecl buffer;
    buffer.kind = ResourceKind::buffer;
    buffer.size_bytes = 256;
    buffer.usage = usage::kStorage;
    EXPECT_EQ(buffer_create_info(buffer).size, 256u);
}

}  // namespace
}  // namespace weft::vk
