// The file part of the sandbox: restricts which files the process can open. It uses Landlock, which exists
// since Linux 5.13.
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "viewer/sandbox/sandbox_parts.h"

namespace weft::viewer {
namespace {

// Constants that are missing in the Landlock header of Debian 12. That header defines version 2; the kernel
// may support newer versions.
constexpr uint64_t kTruncate = 1ull << 14;  // The right to truncate a file, since Landlock version 3.
// The right to use ioctl on devices, since Landlock version 5.
constexpr uint64_t kDeviceControl = 1ull << 15;
constexpr uint64_t kTcp = 3;     // The rights to bind and to connect TCP sockets, since Landlock version 4.
constexpr uint64_t kScopes = 3;  // Restrictions of abstract sockets and of signals, since Landlock version 6.
// The structure landlock_ruleset_attr of Landlock version 6. Versions 4 and 5 have no member `scopes`.
// Versions 1 to 3 have only `files`.
struct RulesetAttributes {
    uint64_t files, tcp, scopes;
};

constexpr uint64_t kReadFile = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr uint64_t kReadFolder = kReadFile | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr uint64_t kRun = LANDLOCK_ACCESS_FS_EXECUTE;
constexpr uint64_t kWriteFile = LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;
constexpr uint64_t kWriteFolder =
    kReadFolder | kWriteFile | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REMOVE_FILE;
// The rights that can be granted for a single file. All other rights apply only to folders.
constexpr uint64_t kOfFiles = kReadFile | kRun | kWriteFile | kDeviceControl;

RulesetAttributes handled_by(int version) {
    RulesetAttributes all{(1ull << 13) - 1, 0, 0};  // Landlock version 1 has 13 rights.
    if (version >= 2) all.files |= LANDLOCK_ACCESS_FS_REFER;
    if (version >= 3) all.files |= kTruncate;
    if (version >= 4) all.tcp = kTcp;
    if (version >= 5) all.files |= kDeviceControl;
    if (version >= 6) all.scopes = kScopes;
    return all;
}

size_t attribute_bytes(int version) {
    return version >= 6 ? 24 : version >= 4 ? 16 : 8;
}

// Grants rights to a file, or to a folder and all files below it. Returns 0 on success, or a value of errno.
// A path that does not exist or that the process may not open gets no rule, and the function returns 0.
int allow(int ruleset, const std::filesystem::path& path, uint64_t rights) {
    const int opened = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (opened < 0) return errno == ENOENT || errno == ENOTDIR || errno == EACCES ? 0 : errno;
    struct stat status {};
    const bool is_folder = fstat(opened, &status) == 0 && S_ISDIR(status.st_mode);
    landlock_path_beneath_attr attributes{};
    attributes.allowed_access = is_folder ? rights : rights & kOfFiles;
    attributes.parent_fd = opened;
    const long failed = syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &attributes, 0u);
    const int error = failed == 0 ? 0 : errno;
    close(opened);
    // Pipes and sockets that the process inherited are not in a file system. They cannot have a rule, and do
    // not need one.
    return error == EBADFD ? 0 : error;
}

int allow_all(int ruleset, const OpenRules& rules, uint64_t handled) {
    const std::pair<const std::vector<std::filesystem::path>*, uint64_t> kinds[] = {
        {&rules.read, kReadFolder},
        {&rules.run, kReadFolder | kRun},
        {&rules.write, kWriteFolder},
        {&rules.devices, kReadFolder | kWriteFile | kDeviceControl}};
    for (const auto& [paths, rights] : kinds)
        for (const std::filesystem::path& path : *paths)
            if (const int error = allow(ruleset, path, rights & handled); error != 0) return error;
    return 0;
}

}  // namespace

int landlock_version() {
    const long version =
        syscall(SYS_landlock_create_ruleset, nullptr, size_t{0}, LANDLOCK_CREATE_RULESET_VERSION);
    return version < 0 ? 0 : static_cast<int>(version);
}

Status restrict_files(const OpenRules& rules) {
    const int version = landlock_version();
    if (version == 0)
        return no_sandbox(
            std::string("the kernel does not offer Landlock: ") + std::strerror(errno),
            "use Linux 5.13 or newer with Landlock enabled: /sys/kernel/security/lsm must list landlock");
    const RulesetAttributes attributes = handled_by(version);
    const long made = syscall(SYS_landlock_create_ruleset, &attributes, attribute_bytes(version), 0u);
    if (made < 0)
        return no_sandbox(std::string("Landlock cannot create a rule set: ") + std::strerror(errno), {});
    const int ruleset = static_cast<int>(made);
    int error = allow_all(ruleset, rules, attributes.files);
    if (error == 0 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) error = errno;
    if (error == 0 && syscall(SYS_landlock_restrict_self, ruleset, 0u) != 0) error = errno;
    close(ruleset);
    if (error != 0) return no_sandbox(std::string("Landlock rejects the rules: ") + std::strerror(error), {});
    return Unit{};
}

}  // namespace weft::viewer
