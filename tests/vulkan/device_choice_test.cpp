// Purpose: tests which device is chosen, and the messages when no device is suitable. The test needs no
// Vulkan device.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <thread>

#include "tests/vulkan/scoped_environment.h"
#include "vulkan/device/instance.h"
#include "vulkan/device/physical_device.h"
#include "weft/vulkan/device_features.h"

namespace weft::vk {
namespace {

Candidate candidate(const std::string& name, VkPhysicalDeviceType type) {
    Candidate result;
    result.type = type;
    result.info.name = name;
    return result;
}

std::vector<Candidate> three_devices() {
    return {candidate("llvmpipe (LLVM 15)", VK_PHYSICAL_DEVICE_TYPE_CPU),
            candidate("Integrated 620", VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU),
            candidate("Discrete 9000", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU)};
}

std::string chosen(const std::vector<Candidate>& candidates, const std::string& wanted) {
    const Result<Candidate> result = choose_device(candidates, wanted);
    return result ? result->info.name : result.errors().front().code;
}

bool mentions(const Diagnostics& errors, const std::string& word) {
    return to_text(errors).find(word) != std::string::npos;
}

TEST(DeviceChoice, prefers_discrete_then_integrated_then_cpu) {
    std::vector<Candidate> devices = three_devices();
    EXPECT_EQ(chosen(devices, ""), "Discrete 9000");
    devices.pop_back();
    EXPECT_EQ(chosen(devices, ""), "Integrated 620");
    devices.pop_back();
    EXPECT_EQ(chosen(devices, ""), "llvmpipe (LLVM 15)");
}

TEST(DeviceChoice, skips_what_cannot_run_weft) {
    std::vector<Candidate> devices = three_devices();
    devices[2].info.missing = {"dynamicRendering"};
    EXPECT_EQ(chosen(devices, ""), "Integrated 620");
}

TEST(DeviceChoice, takes_an_index_or_a_part_of_a_name) {
    EXPECT_EQ(chosen(three_devices(), "0"), "llvmpipe (LLVM 15)");
    // A text that consists of digits is taken as an index, not as a part of a name. There is no device 620.
    EXPECT_EQ(chosen(three_devices(), "620"), "V403");
    EXPECT_EQ(chosen(three_devices(), "Integrated"), "Integrated 620");
}

TEST(DeviceChoice, an_unknown_name_is_answered_with_the_list) {
    const Result<Candidate> result = choose_device(three_devices(), "voodoo");
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.errors().front().code, "V403");
    EXPECT_TRUE(mentions(result.errors(), "1: \"Integrated 620\""));
}

TEST(DeviceChoice, a_device_that_lacks_features_is_refused_by_their_names) {
    std::vector<Candidate> devices{candidate("old", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU)};
    devices[0].info.missing = {"dynamicRendering", "synchronization2"};
    for (const char* wanted : {"", "old"}) {
        const Result<Candidate> result = choose_device(devices, wanted);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.errors().front().code, "V404");
        EXPECT_TRUE(mentions(result.errors(), "dynamicRendering, synchronization2"));
    }
}

TEST(DeviceChoice, features_are_required_exactly_when_missing_ones_are_reported) {
    const FeatureChain nothing;
    const std::vector<std::string> missing = missing_features(nothing);
    EXPECT_NE(std::find(missing.begin(), missing.end(), "dynamicRendering"), missing.end());
    FeatureChain required;
    required_features(required);
    EXPECT_TRUE(missing_features(required).empty());
}

TEST(DeviceMissing, no_loader_names_its_package) {
    const Result<LoaderFunctions> loader = require_loader("libnot-vulkan.so.1");
    ASSERT_FALSE(loader.ok());
    EXPECT_EQ(loader.errors().front().code, "V401");
    EXPECT_TRUE(mentions(loader.errors(), "libvulkan1"));
}

TEST(DeviceMissing, no_driver_names_its_package) {
    const ScopedEnvironment drivers("VK_DRIVER_FILES", "/nonexistent/driver.json");
    const Result<std::unique_ptr<Device>> device = Device::create({});
    ASSERT_FALSE(device.ok());
    EXPECT_EQ(device.errors().front().code, "V402");
    EXPECT_TRUE(mentions(device.errors(), "mesa-vulkan-drivers"));
}

TEST(DeviceMissing, a_machine_without_a_driver_is_still_described) {
    const ScopedEnvironment drivers("VK_DRIVER_FILES", "/nonexistent/driver.json");
    const Result<MachineReport> report = inspect_machine();
    ASSERT_TRUE(report.ok()) << to_text(report.errors());
    EXPECT_TRUE(report->devices.empty());
    EXPECT_FALSE(report->loader_version.empty());
}

TEST(DeviceMissing, validation_without_its_layer_is_an_error) {
    const ScopedEnvironment layers("VK_LAYER_PATH", "/nonexistent");
    DeviceOptions options;
    options.validate = true;
    const Result<std::unique_ptr<Device>> device = Device::create(options);
    ASSERT_FALSE(device.ok());
    EXPECT_EQ(device.errors().front().code, "V405");
    EXPECT_TRUE(mentions(device.errors(), "vulkan-validationlayers"));
}

TEST(MessageCollector, collects_from_many_threads_and_blames_each_thread_s_own_pass) {
    MessageCollector collector;
    collector.set_current_pass("ssao");
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&, t] {
                if (t > 0) collector.set_current_pass("pass" + std::to_string(t));
                for (int i = 0; i < 250; ++i) collector.add({MessageSeverity::error, "id", "", "text"});
            });
        }
    }
    collector.add({MessageSeverity::error, "id", "", "of this thread"});
    collector.add({MessageSeverity::warning, "id", "tonemap", "a message that names its own"});
    std::map<std::string, size_t> blamed;
    for (const Message& message : collector.messages()) ++blamed[message.pass];
    const std::map<std::string, size_t> wanted{{"", 250},      {"pass1", 250}, {"pass2", 250},
                                               {"pass3", 250}, {"ssao", 1},    {"tonemap", 1}};
    EXPECT_EQ(blamed, wanted);
    collector.set_current_pass("");
    EXPECT_EQ(collector.current_pass(), "");
}

}  // namespace
}  // namespace weft::vk
