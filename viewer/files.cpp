#include "files.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

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

std::optional<std::string> read_file(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
}

Status write_file(const std::string& path, const std::string& content) {
    std::ofstream out(path, std::ios::binary);
    out << content;
    out.close();
    if (out) return Unit{};
    return file_error("X510", path, "the file cannot be written",
                      "check that its folder exists and has room");
}

Result<DeviceProfile> load_profile(const std::string& path) {
    const std::string file =
        path.empty() ? (shipped_root() / "framework" / "profiles" / "lavapipe.json").string() : path;
    const std::optional<std::string> text = read_file(file);
    if (!text)
        return file_error("W141", file, "there is no such device profile",
                          "`weft doctor --json > FILE` writes this machine's");
    return parse_profile(*text, file);
}

}  // namespace weft::viewer
