// Runs programs where writing must fail: on a disk that is full, and without the rights of root.
#pragma once

#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

// Runs a shell script where the folder $DISK is a file system of `size` ("64k") of its own, which is gone
// afterwards. The script may use fill_disk, which leaves no room on it. Requires can_mount().
[[nodiscard]] RunResult run_on_small_disk(const std::string& size, const std::string& script,
                                          const Environment& environment = {});
// The system lets this user make a namespace with a file system of its own.
[[nodiscard]] bool can_mount();

// Runs a shell script as a user who may do only what the permissions of files say: root loses its privileges.
[[nodiscard]] RunResult run_without_privileges(const std::string& script);

// `weft` with these arguments, as words of a shell script.
[[nodiscard]] std::string weft_in_shell(const std::vector<std::string>& arguments);

}  // namespace weft::test
