// Purpose: creates a device with validation for each test. The test fails if a layer reports a message or if
// an object is not freed.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "weft/vulkan/device.h"

namespace weft::vk {

class DeviceTest : public testing::Test {
 protected:
    void SetUp() override {
        Result<std::unique_ptr<Device>> made = Device::create(device_options());
        ASSERT_TRUE(made.ok()) << to_text(made.errors());
        device_ = std::move(*made);
    }

    void TearDown() override {
        if (device_ == nullptr) return;
        for (const Message& message : destroy_device(std::move(device_))) {
            ADD_FAILURE() << message.id << " in \"" << message.pass << "\": " << message.text;
        }
    }

    [[nodiscard]] virtual DeviceOptions device_options() const {
        DeviceOptions options;
        options.validate = true;
        return options;
    }
    [[nodiscard]] Device& device() { return *device_; }
    // Gives the device to a test that causes validation messages on purpose. The test must then destroy the
    // device itself.
    [[nodiscard]] std::unique_ptr<Device> take_device() { return std::move(device_); }

 private:
    std::unique_ptr<Device> device_;
};

}  // namespace weft::vk
