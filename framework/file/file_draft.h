// Purpose: a temporary file that becomes visible under its final name in one step. On failure no temporary
// file remains. Errors are values of errno; 0 is success.
#pragma once

#include <signal.h>
#include <sys/stat.h>

#include <optional>
#include <string>
#include <string_view>

namespace weft {

// Writes all data, with several calls of write() if necessary.
[[nodiscard]] int write_all(int descriptor, std::string_view data);

// Blocks SIGINT, SIGTERM and SIGHUP while it exists, so that they cannot end the program between creation and
// removal of a named draft.
class EndSignalsBlocked {
 public:
    EndSignalsBlocked();
    ~EndSignalsBlocked();
    EndSignalsBlocked(const EndSignalsBlocked&) = delete;
    EndSignalsBlocked& operator=(const EndSignalsBlocked&) = delete;

 private:
    sigset_t before_;
};

class FileDraft {
 public:
    enum class Name : bool { none, random };

    FileDraft() = default;
    ~FileDraft();
    FileDraft(const FileDraft&) = delete;
    FileDraft& operator=(const FileDraft&) = delete;

    // Name::none requires a file system that supports unnamed files; Name::random works on every file system.
    [[nodiscard]] int open(const std::string& folder, Name name);
    // Copies the permissions of `old` to the draft, if `old` exists, and its owner, if this process may
    // change owners.
    [[nodiscard]] int fill(std::string_view data, const std::optional<struct stat>& old, bool sync);
    // Replaces `name` in the folder. With `sync` false the folder is not flushed to the disk.
    [[nodiscard]] int place(const std::string& name, bool sync);

 private:
    [[nodiscard]] int open_random();
    [[nodiscard]] int keep_permissions(const struct stat& old) const;
    [[nodiscard]] int give_name(const std::string& name) const;
    [[nodiscard]] int link_random();
    void remove_name();

    int folder_ = -1;
    int file_ = -1;
    std::string name_;  // name of the draft; empty while it has none
};

}  // namespace weft
