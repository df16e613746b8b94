#include "file/file_draft.h"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>

namespace weft {
namespace {

constexpr int kMostNames = 100;
constexpr mode_t kNewFile = 0666;  // Permissions of a new file before the process's umask is applied.

// Makes a name for a draft, which is an unfinished file. The name is random, so that no other program can
// create a file or link with this name in advance.
std::string random_name() {
    uint64_t bits = 0;
    while (getrandom(&bits, sizeof bits, 0) != sizeof bits) {
    }
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), ".weft-%016llx.part", static_cast<unsigned long long>(bits));
    return text.data();
}

// Calls `make` with random names, at most kMostNames times, until its result is not EEXIST (the name is
// already in use). `make` returns 0 or a value of errno. Sets `name` to the name, or to "" after an error.
template <class Make>
int with_free_name(std::string& name, Make make) {
    int error = EEXIST;
    for (int i = 0; i < kMostNames && error == EEXIST; ++i) {
        name = random_name();
        error = make(name);
    }
    if (error != 0) name.clear();
    return error;
}

}  // namespace

int write_all(int descriptor, std::string_view data) {
    while (!data.empty()) {
        const ssize_t written = write(descriptor, data.data(), data.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        if (written == 0) return EIO;
        data.remove_prefix(static_cast<size_t>(written));
    }
    return 0;
}

EndSignalsBlocked::EndSignalsBlocked() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
    pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

EndSignalsBlocked::~EndSignalsBlocked() {
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

FileDraft::~FileDraft() {
    if (file_ >= 0) close(file_);
    remove_name();
    if (folder_ >= 0) close(folder_);
}

int FileDraft::open(const std::string& folder, Name name) {
    folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (folder_ < 0) return errno;
    if (name == Name::random) return open_random();
    file_ = openat(folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, kNewFile);
    return file_ < 0 ? errno : 0;
}

int FileDraft::open_random() {
    return with_free_name(name_, [&](const std::string& name) {
        file_ = openat(folder_, name.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, kNewFile);
        return file_ < 0 ? errno : 0;
    });
}

int FileDraft::keep_permissions(const struct stat& old) const {
    struct stat now {};
    if (fstat(file_, &now) != 0) return errno;
    // Set the permissions after the owner, because changing the owner clears the setuid and setgid bits.
    const bool same_owner = old.st_uid == now.st_uid && old.st_gid == now.st_gid;
    const bool owned = same_owner || fchown(file_, old.st_uid, old.st_gid) == 0;
    const mode_t wanted = old.st_mode & (owned ? 07777 : 0777);
    if ((now.st_mode & 07777) == wanted) return 0;
    return fchmod(file_, wanted) == 0 ? 0 : errno;
}

int FileDraft::fill(std::string_view data, const std::optional<struct stat>& old, bool sync) {
    if (old)
        if (const int error = keep_permissions(*old); error != 0) return error;
    if (const int error = write_all(file_, data); error != 0) return error;
    if (sync && fsync(file_) != 0) return errno;
    // Some file systems report a full disk only when a descriptor is closed. So close a copy of the
    // descriptor here and check the result.
    const int copy = fcntl(file_, F_DUPFD_CLOEXEC, 0);
    return copy < 0 || close(copy) != 0 ? errno : 0;
}

int FileDraft::give_name(const std::string& name) const {
    const std::string self = "/proc/self/fd/" + std::to_string(file_);
    return linkat(AT_FDCWD, self.c_str(), folder_, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
}

// Gives the draft a random, unused name. This is necessary because linkat() cannot replace an existing file:
// the draft gets this name first, and then renameat() replaces the file.
int FileDraft::link_random() {
    return with_free_name(name_, [&](const std::string& name) { return give_name(name); });
}

int FileDraft::place(const std::string& name, bool sync) {
    if (name_.empty()) {
        const int error = give_name(name);
        if (error != 0 && error != EEXIST) return error;
        if (error == EEXIST)
            if (const int fault = link_random(); fault != 0) return fault;
    }
    if (!name_.empty() && renameat(folder_, name_.c_str(), folder_, name.c_str()) != 0) return errno;
    name_.clear();
    if (!sync) return 0;
    // An error of flushing the folder is ignored, because the file is already complete and has its name.
    const int folder = openat(folder_, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return 0;
    fsync(folder);
    close(folder);
    return 0;
}

void FileDraft::remove_name() {
    if (!name_.empty()) unlinkat(folder_, name_.c_str(), 0);
    name_.clear();
}

}  // namespace weft
