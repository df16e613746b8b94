// Runs programs in situations where writing must fail: on a full disk, and without the privileges of root.
#pragma once

#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

// Runs a shell script in which the folder $DISK is a separate file system of the given size, such as "64k".
// The folder is removed afterwards. The script may call fill_disk to fill the disk. Requires can_mount().
[[nodiscard]] RunResult run_on_small_disk(const std::string& size, const std::string& script,
                                          const Environment& environment = {});
// Returns true if the user of the test may create a mount namespace and mount a file system in it.
[[nodiscard]] bool can_mount();

// Runs a shell script as a user to whom file permissions apply. If the test runs as root, the script runs
// without root's privileges.
[[nodiscard]] RunResult run_without_privileges(const std::string& script);

// Returns a `weft` command with these arguments, quoted for a shell script.
[[nodiscard]] std::string weft_in_shell(const std::vector<std::string>& arguments);

}  // namespace weft::test
