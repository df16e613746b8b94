#include "viewer/files/files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "graph/syntax/contained_file.h"

namespace weft::viewer {
namespace {

Diagnostic file_error(const std::string& code, const std::string& path, std::string message,
                      std::string help) {
    Diagnostic d;
    d.code = code;
    d.file = path;
    d.message = std::move(message);
    d.help = {std::move(help)};
    return d;
}

}  // namespace

std::filesystem::path shipped_root() {
    std::error_code error;
    std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    const std::filesystem::path installed = folder.parent_path() / "share" / "weft";
    if (std::filesystem::exists(installed / "graphs" / "deferred.json", error)) return installed;
    while (!folder.empty()) {
        if (std::filesystem::exists(folder / "graphs" / "deferred.json", error)) return folder;
        if (folder == folder.root_path()) break;
        folder = folder.parent_path();
    }
    return std::filesystem::current_path(error);
}

std::filesystem::path shader_cache() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return std::filesystem::path(cache) / "weft" / "shaders";
    if (const char* home = std::getenv("HOME"); home && *home)
        return std::filesystem::path(home) / ".cache" / "weft" / "shaders";
    return {};
}

std::optional<std::string> read_file(const std::string& path, uint64_t most_bytes) {
    return disk_reader(most_bytes)(path);
}

FileReader reader_up_to(uint64_t most_bytes) {
    return disk_reader(most_bytes);
}

Result<Limits> load_limits(const std::string& file) {
    if (file.empty()) return Limits{};
    return read_limits(file, reader_up_to(GraphLimits{}.json_bytes));
}

namespace {

constexpr uint64_t kMostProfileBytes = 1 << 20;

std::filesystem::path profile_folder() {
    const std::filesystem::path root = shipped_root();
    std::error_code error;
    const bool installed = std::filesystem::exists(root / "profiles", error);
    return installed ? root / "profiles" : root / "framework" / "profiles";
}

std::vector<std::string> shipped_profiles() {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(profile_folder(), error))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

Diagnostic no_such_profile(const std::string& name) {
    const std::vector<std::string> known = shipped_profiles();
    std::string list;
    for (const std::string& shipped : known) list += (list.empty() ? "" : ", ") + shipped;
    Diagnostic d = file_error("W141", name, "the device profile does not exist",
                              "give a file, or one of the shipped profiles: " + list);
    const std::string guess = did_you_mean_text(name, known);
    if (!guess.empty()) d.help.insert(d.help.begin(), guess);
    d.help.push_back("`weft doctor --json > FILE` writes the profile of this machine");
    return d;
}

}  // namespace

Result<DeviceProfile> load_profile(const std::string& file_or_name) {
    const std::string name = file_or_name.empty() ? "lavapipe" : file_or_name;
    std::string file = name;
    std::optional<std::string> text =
        file_or_name.empty() ? std::nullopt : read_file(file, kMostProfileBytes);
    if (!text && name.find_first_of("/.") == std::string::npos) {
        file = (profile_folder() / (name + ".json")).string();
        text = read_file(file, kMostProfileBytes);
    }
    if (!text) return no_such_profile(name);
    if (text->size() > kMostProfileBytes)
        return file_error("W140", file, "the file is larger than 1 MiB",
                          "give a profile that `weft doctor --json` wrote");
    return parse_profile(*text, file);
}

}  // namespace weft::viewer
