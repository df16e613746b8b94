#include "file/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "file/file_draft.h"
#include "file/file_target.h"
#include "graph/diagnostics/make_error.h"

namespace weft {
namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

Diagnostic cannot_write(const std::string& path, const std::string& why, std::string help) {
    Diagnostic d;
    d.code = "X510";
    d.file = path;
    d.message = "the file cannot be written: " + why;
    d.help = {std::move(help)};
    return d;
}

std::string remedy(int error, const FileTarget& target) {
    switch (error) {
        case ENOENT:
            return "create the folder first: mkdir -p '" + target.folder() + "'";
        case ENOSPC:
        case EDQUOT:
            return "make room on the disk; the old file is unchanged";
        case EFBIG:
            return "raise the limit for the size of files: see `ulimit -f`";
        case EPIPE:
            return "keep the program that reads the pipe running";
        case EACCES:
        case EPERM:
            return "allow writing to the file and its folder, or choose another place";
        case EROFS:
            return "choose another place: the disk is mounted read-only";
        case EBUSY:
            return "choose another place: a mount point cannot be replaced by a file";
        default:
            return "check the path and the disk";
    }
}

Diagnostic cannot_write(const std::string& path, int error, const FileTarget& target) {
    return cannot_write(path, reason(error), remedy(error, target));
}

Diagnostic is_folder(const std::string& path) {
    const std::string slash = path.ends_with('/') ? "" : "/";
    return cannot_write(path, reason(EISDIR), "name a file in this folder: " + path + slash + "NAME");
}

Status check_file(const std::string& path, const FileTarget& target) {
    const std::string folder = target.folder();
    struct stat status {};
    if (stat(folder.c_str(), &status) != 0) return cannot_write(path, errno, target);
    if (!S_ISDIR(status.st_mode)) return cannot_write(path, ENOTDIR, target);
    // The permissions of the folder may allow this process to replace a read-only file. Refuse to do so,
    // because the owner of the file has protected it.
    if (target.old && faccessat(AT_FDCWD, target.path.c_str(), W_OK, AT_EACCESS) != 0)
        return cannot_write(path, errno, target);
    if (faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) == 0) return Unit{};
    const int error = errno;
    return cannot_write(path, "no file can be created in its folder: " + reason(error),
                        remedy(error, target));
}

// Writes the data and closes the descriptor. Returns the first error, which may also be an error of close().
int write_and_close(int descriptor, std::string_view data) {
    const int error = write_all(descriptor, data);
    const bool closed = close(descriptor) == 0;
    return error != 0 || closed ? error : errno;
}

int write_descriptor(int descriptor, std::string_view data) {
    const int copy = fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    return copy < 0 ? errno : write_and_close(copy, data);
}

int write_stream(const FileTarget& target, std::string_view data) {
    if (target.kind == TargetKind::descriptor) return write_descriptor(target.descriptor, data);
    const int descriptor = open(target.path.c_str(), O_WRONLY | O_TRUNC | O_NOCTTY | O_CLOEXEC);
    return descriptor < 0 ? errno : write_and_close(descriptor, data);
}

int write_draft(const FileTarget& target, std::string_view data, bool sync, FileDraft::Name name) {
    FileDraft draft;
    int error = draft.open(target.folder(), name);
    if (error == 0) error = draft.fill(data, target.old, sync);
    if (error == 0) error = draft.place(target.path.filename().string(), sync);
    return error;
}

// A draft without a name failed with `error`. Returns true if a draft with a name may succeed. Such errors
// have two causes: the file system does not support files without names, or /proc is not mounted. Without
// /proc, a draft without a name cannot get its name at the end.
bool is_worth_a_name(int error) {
    return error == EOPNOTSUPP || error == EISDIR || error == EINVAL || error == ENOENT || error == EPERM;
}

}  // namespace

Status check_writable(const std::string& path) {
    const FileTarget target = find_target(path);
    if (target.error != 0) return cannot_write(path, target.error, target);
    if (target.kind == TargetKind::folder) return is_folder(path);
    if (target.kind == TargetKind::file) return check_file(path, target);
    if (target.kind == TargetKind::descriptor) {
        const int flags = fcntl(target.descriptor, F_GETFL);
        if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) return cannot_write(path, EBADF, target);
        return Unit{};
    }
    if (faccessat(AT_FDCWD, target.path.c_str(), W_OK, AT_EACCESS) != 0)
        return cannot_write(path, errno, target);
    return Unit{};
}

Status write_file(const std::string& path, std::string_view data, Durability durability) {
    // Check again, because the target may have changed since the program called check_writable().
    if (Status writable = check_writable(path); !writable) return writable;
    const FileTarget target = find_target(path);
    const bool sync = durability == Durability::on_disk;
    int error = 0;
    if (target.kind == TargetKind::file) {
        const EndSignalsBlocked blocked;
        error = write_draft(target, data, sync, FileDraft::Name::none);
        if (is_worth_a_name(error)) error = write_draft(target, data, sync, FileDraft::Name::random);
    } else {
        error = write_stream(target, data);
    }
    if (error != 0) return cannot_write(path, error, target);
    return Unit{};
}

Status write_stdout(std::string_view data) {
    if (data.empty()) return Unit{};
    const int error = write_descriptor(STDOUT_FILENO, data);
    if (error == 0) return Unit{};
    return make_error("X512", "standard output cannot be written: " + reason(error),
                      {error == EPIPE ? "keep the program that reads the output running"
                                      : "make room on the disk, or redirect the output to another file"});
}

bool is_stream(const std::string& path) {
    const FileTarget target = find_target(path);
    return target.kind == TargetKind::stream || target.kind == TargetKind::descriptor;
}

}  // namespace weft
