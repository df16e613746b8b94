#include <cstdio>

#include "commands.h"
#include "files.h"
#include "vulkan/device.h"

namespace weft::viewer {
namespace {

ExitCode fail(const Diagnostics& errors) {
    report(errors);
    return exit_code_for(errors);
}

void print_machine(const vk::MachineReport& machine) {
    std::printf("Vulkan loader     %s\n", machine.loader_version.c_str());
    for (size_t i = 0; i < machine.devices.size(); ++i) {
        const vk::DeviceInfo& device = machine.devices[i];
        std::printf("device %zu          %s, %s, Vulkan %s%s\n", i, device.name.c_str(),
                    device.driver.c_str(), device.api_version.c_str(),
                    device.timestamps ? "" : ", no timestamps");
        for (const std::string& feature : device.missing)
            std::printf("  lacks           %s\n", feature.c_str());
    }
    bool validation = false;
    for (const vk::LayerInfo& layer : machine.layers) {
        std::printf("layer             %s %s\n", layer.name.c_str(), layer.version.c_str());
        validation = validation || layer.name == "VK_LAYER_KHRONOS_validation";
    }
    if (!validation)
        std::printf("missing           the validation layer: apt-get install vulkan-validationlayers\n");
    std::printf("shipped files     %s\n", shipped_root().c_str());
    std::printf("shader cache      %s\n", shader_cache().c_str());
}

}  // namespace

ExitCode run_doctor(const DoctorOptions& options) {
    if (!options.json) {
        const Result<vk::MachineReport> machine = vk::inspect_machine();
        if (!machine) return fail(machine.errors());
        print_machine(*machine);
    }
    // Bringing a device up says more than listing it: a missing feature shows here.
    vk::DeviceOptions device_options;
    device_options.device = options.device;
    const Result<std::unique_ptr<vk::Device>> device = vk::Device::create(device_options);
    if (!device) return fail(device.errors());
    if (options.json) {
        std::fputs(profile_to_json((*device)->profile()).c_str(), stdout);
    } else {
        std::printf("chosen device     %s: everything Weft needs is there\n", (*device)->info().name.c_str());
    }
    return ExitCode::ok;
}

}  // namespace weft::viewer
