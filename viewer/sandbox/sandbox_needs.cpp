#include "viewer/sandbox/sandbox_needs.h"

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "viewer/files/files.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kMostManifestBytes = 1 << 20;

std::vector<fs::path> paths_in(const char* variable) {
    std::vector<fs::path> paths;
    const char* text = std::getenv(variable);
    std::string_view rest = text == nullptr ? "" : text;
    while (!rest.empty()) {
        const size_t end = std::min(rest.find(':'), rest.size());
        if (end > 0) paths.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return paths;
}

// Allows the files of a Vulkan driver. The manifest is a JSON file that names the library of the driver by an
// absolute path, by a path relative to the manifest, or by a file name without a folder. A library without a
// folder is in a system folder, which rules_of_program() already allows.
void add_driver(const fs::path& manifest, OpenRules& rules) {
    rules.read.push_back(manifest);
    const std::optional<std::string> text = read_file(manifest.string(), kMostManifestBytes);
    const nlohmann::json root = nlohmann::json::parse(text ? *text : std::string(), nullptr, false);
    if (!root.is_object() || !root.contains("ICD") || !root["ICD"].is_object()) return;
    const auto& driver = root["ICD"];
    if (!driver.contains("library_path") || !driver["library_path"].is_string()) return;
    const fs::path library = driver["library_path"].get<std::string>();
    if (library.has_parent_path()) rules.run.push_back(manifest.parent_path() / library);
}

void add_vulkan(OpenRules& rules) {
    for (const char* folder :
         {"/etc/vulkan", "/etc/drirc", "/etc/glvnd", "/usr/local/share/vulkan", "/usr/share/vulkan",
          "/usr/share/drirc.d", "/usr/share/glvnd", "/usr/share/libdrm", "/usr/local/nvidia",
          // Folders with information about processors and GPUs.
          "/sys/devices", "/sys/dev/char", "/sys/bus/pci", "/sys/class/drm"})
        rules.read.emplace_back(folder);
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0)
        rules.read.push_back(fs::path(home) / ".local/share/vulkan");
    for (const char* variable : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"})
        for (const fs::path& manifest : paths_in(variable)) add_driver(manifest, rules);
    for (const char* variable : {"VK_LAYER_PATH", "VK_ADD_LAYER_PATH"})
        for (const fs::path& folder : paths_in(variable)) rules.run.push_back(folder);
    for (const char* device : {"/dev/dri", "/dev/nvidia0", "/dev/nvidiactl", "/dev/nvidia-uvm",
                               "/dev/nvidia-modeset", "/dev/nvidia-caps", "/dev/kfd"})
        rules.devices.emplace_back(device);
}

}  // namespace

OpenRules rules_of_program(bool device) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path root = shipped_root();
    OpenRules rules;
    rules.run = {"/lib",
                 "/lib64",
                 "/usr/lib",
                 "/usr/lib64",
                 "/usr/local/lib",
                 program,
                 program.parent_path() / "weft-shader-worker",
                 program.parent_path().parent_path() / "lib/weft"};
    for (const fs::path& folder : paths_in("LD_LIBRARY_PATH")) rules.run.push_back(folder);
    rules.read = {root / "graphs",
                  root / "shaders",
                  root / "profiles",
                  root / "framework/profiles",
                  root / "docs/diagnostics.md",
                  shader_cache(),
                  "/etc/ld.so.cache",
                  "/etc/localtime",
                  "/usr/share/zoneinfo",
                  "/usr/share/locale",
                  "/proc/self",
                  "/proc/cpuinfo",
                  "/proc/meminfo",
                  "/proc/stat",
                  "/proc/sys/vm/overcommit_memory",
                  "/sys/devices/system/cpu",
                  "/sys/devices/system/node",
                  "/dev/urandom",
                  "/dev/random",
                  "/dev/zero"};
    rules.devices = {"/dev/null"};
    if (device) add_vulkan(rules);
    return rules;
}

}  // namespace weft::viewer
