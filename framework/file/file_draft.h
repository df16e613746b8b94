// Purpose: a temporary file (the draft) that gets its final name in one step, when it is complete. If writing
// fails, no temporary file remains. Errors are values of errno; 0 means success.
#pragma once

#include <signal.h>
#include <sys/stat.h>

#include <optional>
#include <string>
#include <string_view>

namespace weft {

// Writes all data to a descriptor. Calls write() several times if necessary.
[[nodiscard]] int write_all(int descriptor, std::string_view data);

// Blocks the signals SIGINT, SIGTERM and SIGHUP as long as this object exists. Otherwise they could end the
// program while a draft with a name exists, and the draft would remain.
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

    // Creates a draft in `folder`. Name::none creates a file without a name, which needs support by the file
    // system. Name::random works on every file system.
    [[nodiscard]] int open(const std::string& folder, Name name);
    // Writes `data` to the draft. `old` is the status of the file that the draft will replace, if there is
    // one: the draft gets the permissions of that file, and also its owner if this process may change owners.
    // If `sync` is true, the data is flushed to the disk.
    [[nodiscard]] int fill(std::string_view data, const std::optional<struct stat>& old, bool sync);
    // Gives the draft the final name `name`, and so replaces an old file of this name. If `sync` is true, the
    // folder is flushed to the disk.
    [[nodiscard]] int place(const std::string& name, bool sync);

 private:
    [[nodiscard]] int open_random();
    [[nodiscard]] int keep_permissions(const struct stat& old) const;
    [[nodiscard]] int give_name(const std::string& name) const;
    [[nodiscard]] int link_random();
    void remove_name();

    int folder_ = -1;
    int file_ = -1;
    std::string name_;  // Name of the draft in its folder; empty while the draft has no name.
};

}  // namespace weft
