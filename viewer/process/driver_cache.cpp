#include "viewer/process/driver_cache.h"

#include <fcntl.h>
#include <pwd.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "viewer/output/report.h"

namespace weft::viewer {
namespace {

namespace fs = std::filesystem;

// Size of the index file in Mesa's shader cache: a counter of 8 bytes, and 2^16 keys of 20 bytes. Mesa
// creates the file with this size, but does not reserve the disk space.
constexpr off_t kIndexBytes = 8 + (1 << 16) * 20;

const char* first_set(std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (const char* value = std::getenv(name)) return value;
    return nullptr;
}

bool is_disabled() {
    const char* value = first_set({"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"});
    if (value == nullptr) return false;
    for (const char* yes : {"1", "true", "y", "yes"})
        if (strcasecmp(value, yes) == 0) return true;
    return false;
}

fs::path home_folder() {
    if (const char* home = std::getenv("HOME")) return home;
    passwd entry{};
    passwd* found = nullptr;
    std::vector<char> text(size_t{1} << 14);
    if (getpwuid_r(getuid(), &entry, text.data(), text.size(), &found) != 0 || found == nullptr) return {};
    return entry.pw_dir;
}

// Returns the folder in which Mesa stores its shader cache.
fs::path cache_folder() {
    if (const char* folder = first_set({"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME"}))
        return fs::path(folder) / "mesa_shader_cache";
    return home_folder() / ".cache" / "mesa_shader_cache";
}

// Creates the index file of the cache if necessary, and reserves its disk space. Returns 0 on success, or a
// value of errno.
int take_disk_space(const fs::path& index) {
    std::error_code error;
    fs::create_directories(index.parent_path(), error);
    if (error) return error.value();
    const int file = open(index.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOCTTY, 0644);
    if (file < 0) return errno;
    struct stat status {};
    int fault = fstat(file, &status) != 0 ? errno : 0;
    if (fault == 0 && !S_ISREG(status.st_mode)) fault = EINVAL;
    if (fault == 0) fault = posix_fallocate(file, 0, kIndexBytes);
    close(file);
    return fault;
}

Diagnostic runs_without(const fs::path& folder, int error) {
    Diagnostic d;
    d.severity = Severity::warning;
    d.code = "X513";
    d.message = "Mesa's shader cache in \"" + folder.string() +
                "\" cannot be used: " + std::generic_category().message(error);
    d.help = {
        "make room on that disk, or name another folder in MESA_SHADER_CACHE_DIR; this run compiles all "
        "shaders without the cache"};
    return d;
}

}  // namespace

void prepare_driver_cache() {
    if (is_disabled()) return;
    const fs::path folder = cache_folder();
    const int error = take_disk_space(folder / "index");
    if (error == 0) return;
    report({runs_without(folder, error)});
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

}  // namespace weft::viewer
