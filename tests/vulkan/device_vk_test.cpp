// Purpose: tests that a device is created, that its validation messages arrive, that its properties are read,
// and that Weft can use the device of an embedding program.
#include "weft/vulkan/device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/vulkan/device_fixture.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"
#include "weft/vulkan/memory.h"
#include "weft/vulkan/native.h"

namespace weft::vk {
namespace {

using DeviceVk = DeviceTest;

// Records a fault: the buffer is filled but has no transfer usage, which is an error on every device.
void record_fault(Device& device, VkCommandBuffer commands, const Buffer& buffer) {
    device.fn().vkCmdFillBuffer(commands, buffer.handle(), 0, VK_WHOLE_SIZE, 1);
}

Buffer faulty_buffer(Device& device) {
    Result<Buffer> buffer =
        Buffer::create(device, 64, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Buffer::Memory::device, "lights");
    EXPECT_TRUE(buffer.ok());
    return std::move(*buffer);
}

TEST_F(DeviceVk, comes_up_under_validation_and_says_so) {
    EXPECT_TRUE(device().validating());
    ASSERT_EQ(device().info().layers.size(), 1u);
    EXPECT_EQ(device().info().layers[0].name, "VK_LAYER_KHRONOS_validation");
    EXPECT_EQ(device().info().layers[0].version.substr(0, 2), "1.");
    EXPECT_FALSE(device().info().name.empty());
    EXPECT_FALSE(device().info().driver.empty());
    EXPECT_NE(device().queue().handle, VK_NULL_HANDLE);
    EXPECT_EQ(device().timeout_ns(), DeviceOptions{}.timeout_ns);
}

TEST_F(DeviceVk, a_message_names_the_label_it_was_recorded_under) {
    std::unique_ptr<Device> owned = take_device();
    {
        const Buffer buffer = faulty_buffer(*owned);
        const InstanceFunctions& fn = owned->instance_fn();
        const Status status = immediate_submit(*owned, "a fault", [&](VkCommandBuffer commands) {
            VkDebugUtilsLabelEXT label{};
            label.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
            for (const char* name : {"frame", "light_culling"}) {
                label.pLabelName = name;
                fn.vkCmdBeginDebugUtilsLabelEXT(commands, &label);
            }
            record_fault(*owned, commands, buffer);
            fn.vkCmdEndDebugUtilsLabelEXT(commands);
            fn.vkCmdEndDebugUtilsLabelEXT(commands);
        });
        ASSERT_TRUE(status.ok()) << to_text(status.errors());
    }
    const std::vector<Message> messages = destroy_device(std::move(owned));
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].severity, MessageSeverity::error);
    EXPECT_EQ(messages[0].id, "VUID-vkCmdFillBuffer-dstBuffer-00029");
    EXPECT_EQ(messages[0].pass, "light_culling");
    EXPECT_NE(messages[0].text.find("lights"), std::string::npos)
        << "objects have names: " << messages[0].text;
}

TEST_F(DeviceVk, a_message_without_a_label_names_the_current_pass) {
    std::unique_ptr<Device> owned = take_device();
    {
        const Buffer buffer = faulty_buffer(*owned);
        owned->messages().set_current_pass("shadows");
        const Status status = immediate_submit(
            *owned, "a fault", [&](VkCommandBuffer commands) { record_fault(*owned, commands, buffer); });
        ASSERT_TRUE(status.ok()) << to_text(status.errors());
    }
    const std::vector<Message> messages = destroy_device(std::move(owned));
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].pass, "shadows");
}

TEST_F(DeviceVk, a_missing_barrier_is_heard) {
    std::unique_ptr<Device> owned = take_device();
    {
        Result<Buffer> buffer = Buffer::create(*owned, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                               Buffer::Memory::device, "twice written");
        ASSERT_TRUE(buffer.ok());
        const Status status = immediate_submit(*owned, "two fills", [&](VkCommandBuffer commands) {
            owned->fn().vkCmdFillBuffer(commands, buffer->handle(), 0, VK_WHOLE_SIZE, 1);
            owned->fn().vkCmdFillBuffer(commands, buffer->handle(), 0, VK_WHOLE_SIZE, 2);
        });
        ASSERT_TRUE(status.ok()) << to_text(status.errors());
    }
    const std::vector<Message> messages = destroy_device(std::move(owned));
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].id, "SYNC-HAZARD-WRITE-AFTER-WRITE");
}

TEST_F(DeviceVk, an_object_left_alive_is_heard_at_destruction) {
    std::unique_ptr<Device> owned = take_device();
    VkFenceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    VkFence fence = VK_NULL_HANDLE;
    ASSERT_EQ(owned->fn().vkCreateFence(owned->handle(), &info, nullptr, &fence), VK_SUCCESS);
    EXPECT_EQ(owned->messages().count(), 0u);
    EXPECT_EQ(destroy_device(std::move(owned)).size(), 1u);
}

TEST_F(DeviceVk, two_devices_live_side_by_side) {
    const Result<std::unique_ptr<Device>> second = Device::create({});
    ASSERT_TRUE(second.ok());
    EXPECT_FALSE((*second)->validating());
    EXPECT_TRUE((*second)->info().layers.empty());
    EXPECT_NE((*second)->handle(), device().handle());
}

TEST_F(DeviceVk, memory_types_fit_what_was_asked) {
    const VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const uint32_t type = device().memory_type(UINT32_MAX, wanted);
    ASSERT_NE(type, UINT32_MAX);
    EXPECT_EQ(device().memory().memoryTypes[type].propertyFlags & wanted, wanted);
    EXPECT_EQ(device().memory_type(0, 0), UINT32_MAX);
}

// Enables only the features that Weft requires, and one more feature: without it, Device::adopt() refuses an
// llvmpipe device.
void enable_least(FeatureChain& enabled) {
    required_features(enabled);
    enabled.v10().shaderUniformBufferArrayDynamicIndexing = VK_TRUE;
}

TEST_F(DeviceVk, an_adopted_device_works_and_is_left_alive) {
    const NativeDevice own = native(device());
    FeatureChain enabled;
    enable_least(enabled);
    {
        Result<std::unique_ptr<Device>> adopted =
            Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled});
        ASSERT_TRUE(adopted.ok()) << to_text(adopted.errors());
        EXPECT_EQ((*adopted)->info().name, device().info().name);
        // Only the reductions min and max of a sampler need a feature of the device.
        auto formats = device().profile().formats;
        for (auto& [format, features] : formats) features &= ~format_feature::kSampledMinMax;
        EXPECT_EQ((*adopted)->profile().formats, formats);
        EXPECT_EQ((*adopted)->profile().max_sampler_anisotropy, 1.0F);
        Result<Buffer> buffer = Buffer::create(**adopted, 16, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                               Buffer::Memory::device, "adopted");
        ASSERT_TRUE(buffer.ok());
        const std::array<std::byte, 16> bytes{};
        EXPECT_TRUE(upload_buffer(**adopted, *buffer, bytes).ok());
        EXPECT_FALSE((*adopted)->optional().depth_clamp);
    }
    // The adopted Device object is destroyed, but the embedding program still owns the VkDevice and can use
    // it.
    EXPECT_EQ(device().fn().vkDeviceWaitIdle(own.device), VK_SUCCESS);
}

TEST_F(DeviceVk, an_adopted_device_offers_the_optional_features_it_was_made_with) {
    const NativeDevice own = native(device());
    FeatureChain enabled;
    enable_least(enabled);
    enabled.v10().depthClamp = VK_TRUE;
    const auto adopted = Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled});
    ASSERT_TRUE(adopted.ok()) << to_text(adopted.errors());
    EXPECT_TRUE((*adopted)->optional().depth_clamp);
    EXPECT_TRUE((*adopted)->profile().depth_clamp);
    EXPECT_FALSE((*adopted)->optional().fill_mode_non_solid);
    EXPECT_FALSE((*adopted)->profile().non_solid_fill);
}

TEST_F(DeviceVk, an_adopted_device_that_makes_llvmpipe_compile_in_every_frame_is_refused) {
    const NativeDevice own = native(device());
    FeatureChain enabled;
    required_features(enabled);
    const auto adopted = Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled});
    if (!device().info().driver.starts_with("llvmpipe")) {
        EXPECT_TRUE(adopted.ok()) << to_text(adopted.errors());
        return;
    }
    ASSERT_FALSE(adopted.ok());
    EXPECT_EQ(adopted.errors().front().code, "V404");
    EXPECT_NE(adopted.errors().front().message.find("shaderUniformBufferArrayDynamicIndexing"),
              std::string::npos);
    EXPECT_NE(adopted.errors().front().help.front().find("enable_features()"), std::string::npos);
}

TEST_F(DeviceVk, what_enable_features_switches_on_is_enough) {
    const NativeDevice own = native(device());
    FeatureChain supported, enabled;
    device().instance_fn().vkGetPhysicalDeviceFeatures2(own.physical, &supported.head());
    enable_features(supported, enabled);
    const auto adopted = Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled});
    ASSERT_TRUE(adopted.ok()) << to_text(adopted.errors());
    EXPECT_EQ(profile_to_json((*adopted)->profile()), profile_to_json(device().profile()));
}

TEST_F(DeviceVk, all_that_an_adopted_device_lacks_is_named) {
    const NativeDevice own = native(device());
    FeatureChain enabled;
    required_features(enabled);
    enabled.v12().timelineSemaphore = VK_FALSE;
    enabled.v13().dynamicRendering = VK_FALSE;
    const auto adopted =
        Device::adopt({own.instance, own.physical, own.device, {{own.queue.handle, 99}}, &enabled});
    ASSERT_FALSE(adopted.ok());
    ASSERT_EQ(adopted.errors().size(), 1u);
    EXPECT_EQ(adopted.errors().front().code, "V404");
    for (const char* name : {"timelineSemaphore", "dynamicRendering", "a first queue", "family 99"})
        EXPECT_NE(adopted.errors().front().message.find(name), std::string::npos) << name;
    EXPECT_FALSE(Device::adopt({own.instance, own.physical, own.device, {}, &enabled}).ok());
}

// Image::adopt() uses an image that the embedding program owns. After the adopted object is destroyed, the
// program must still be able to use the image.
TEST_F(DeviceVk, an_adopted_image_is_left_alive) {
    ResourceDecl decl;
    decl.name = "own";
    decl.kind = ResourceKind::image;
    decl.format = Format::rgba8;
    decl.extent = {4, 4, 1};
    decl.usage = usage::kSampled | usage::kTransferDst;
    Result<Image> own = Image::create(device(), decl);
    ASSERT_TRUE(own.ok()) << to_text(own.errors());
    {
        const Result<Image> adopted = Image::adopt(device(), own->handle(), decl);
        ASSERT_TRUE(adopted.ok()) << to_text(adopted.errors());
        EXPECT_EQ(adopted->handle(), own->handle());
        EXPECT_NE(adopted->view(), own->view());
    }
    const std::vector<std::byte> texels(4 * 4 * 4, std::byte{7});
    const std::array levels{std::span<const std::byte>(texels)};
    EXPECT_TRUE(upload_image(device(), *own, levels).ok());
}

TEST(MachineReportVk, lists_devices_layers_and_the_loader) {
    const Result<MachineReport> report = inspect_machine();
    ASSERT_TRUE(report.ok()) << to_text(report.errors());
    EXPECT_EQ(report->loader_version.substr(0, 2), "1.");
    ASSERT_FALSE(report->devices.empty());
    EXPECT_TRUE(std::any_of(report->devices.begin(), report->devices.end(),
                            [](const DeviceInfo& device) { return device.missing.empty(); }));
    EXPECT_TRUE(std::any_of(report->layers.begin(), report->layers.end(), [](const LayerInfo& layer) {
        return layer.name == "VK_LAYER_KHRONOS_validation";
    }));
}

// framework/profiles/lavapipe.json is used when no device is available. So the file must be equal to the
// profile of the real lavapipe device.
TEST_F(DeviceVk, the_stored_profile_of_lavapipe_is_that_of_the_device) {
    if (device().info().driver.find("Mesa 22.3") == std::string::npos) {
        GTEST_SKIP() << "the stored profile is Mesa 22.3's, this is " << device().info().driver;
    }
    const std::string path = std::string(WEFT_SOURCE_DIR) + "/framework/profiles/lavapipe.json";
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    const Result<DeviceProfile> stored = parse_profile(text.str(), path);
    ASSERT_TRUE(stored.ok()) << to_text(stored.errors());
    DeviceProfile expected = device().profile();
    // The names are not compared, because the device's name contains the vector width of this machine.
    expected.name = stored->name;
    EXPECT_EQ(text.str(), profile_to_json(expected)) << "`weft doctor --json` writes it anew";
}

}  // namespace
}  // namespace weft::vk
