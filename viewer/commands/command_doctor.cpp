#include "viewer/commands/commands.h"
#include "viewer/files/files.h"
#include "viewer/output/formatted.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "weft/vulkan/device.h"

namespace weft::viewer {
namespace {

ExitCode fail(const Diagnostics& errors) {
    report(errors);
    return exit_code_for(errors);
}

std::string machine_text(const vk::MachineReport& machine) {
    std::string text = formatted("Vulkan loader     %s\n", machine.loader_version.c_str());
    for (size_t i = 0; i < machine.devices.size(); ++i) {
        const vk::DeviceInfo& device = machine.devices[i];
        text += formatted("device %zu          %s, %s, Vulkan %s%s\n", i, device.name.c_str(),
                          device.driver.c_str(), device.api_version.c_str(),
                          device.timestamps ? "" : ", no timestamps");
        for (const std::string& feature : device.missing)
            text += formatted("  lacks           %s\n", feature.c_str());
    }
    bool validation = false;
    for (const vk::LayerInfo& layer : machine.layers) {
        text += formatted("layer             %s %s\n", layer.name.c_str(), layer.version.c_str());
        validation = validation || layer.name == "VK_LAYER_KHRONOS_validation";
    }
    if (!validation)
        text +=
            "missing           the validation layer; install it: apt-get install vulkan-validationlayers\n";
    text += formatted("shipped files     %s\n", shipped_root().c_str());
    return text + formatted("shader cache      %s\n", shader_cache().c_str());
}

}  // namespace

ExitCode run_doctor(const DoctorOptions& options) {
    if (!options.json) {
        const Result<vk::MachineReport> machine = vk::inspect_machine();
        if (!machine) return fail(machine.errors());
        if (const ExitCode code = print_data(machine_text(*machine)); code != ExitCode::ok) return code;
    }
    // Create the device, although without --json only its name is used. Creating it finds faults that the
    // list of devices does not show. Example: vkCreateDevice fails.
    vk::DeviceOptions device_options;
    device_options.device = options.device;
    const Result<std::unique_ptr<vk::Device>> device = vk::Device::create(device_options);
    if (!device) return fail(device.errors());
    if (options.json) return print_data(profile_to_json((*device)->profile()));
    return print_data(
        formatted("chosen device     %s: has everything that Weft needs\n", (*device)->info().name.c_str()));
}

}  // namespace weft::viewer
