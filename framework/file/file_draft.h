// Purpose: a file in the making. It takes its place in a folder in one step, or nothing is left of it.
// Errors are values of errno; 0 is success.
#pragma once

#include <signal.h>
#include <sys/stat.h>

#include <optional>
#include <string>
#include <string_view>

namespace weft {

// Writes everything, however many calls that takes.
[[nodiscard]] int write_all(int descriptor, std::string_view data);

// SIGINT, SIGTERM and SIGHUP wait until it is gone, so that they cannot end the program between making a
// draft with a name and removing it.
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

    // Name::none needs a file system that can make files without a name; Name::random works everywhere.
    [[nodiscard]] int open(const std::string& folder, Name name);
    // The draft gets the permissions of `old`, where there is one, and its owner if this process may give
    // files away.
    [[nodiscard]] int fill(std::string_view data, const std::optional<struct stat>& old, bool sync);
    // Replaces `name` in the folder. False for `sync`: the folder is not flushed to the disk.
    [[nodiscard]] int place(const std::string& name, bool sync);

 private:
    [[nodiscard]] int open_random();
    [[nodiscard]] int keep_permissions(const struct stat& old) const;
    [[nodiscard]] int give_name(const std::string& name) const;
    [[nodiscard]] int link_random();
    void remove_name();

    int folder_ = -1;
    int file_ = -1;
    std::string name_;  // of the draft; empty while it has none
};

}  // namespace weft
