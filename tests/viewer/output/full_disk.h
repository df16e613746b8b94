// Runs programs where writing must fail: on a full disk, and without root's privileges.
#pragma once

#include <string>
#include <vector>

#include "tests/viewer/program.h"

namespace weft::test {

// Runs a shell script with the folder $DISK on its own file system of `size` ("64k"), which is removed
// afterwards. The script may call fill_disk to fill it. Requires can_mount().
[[nodiscard]] RunResult run_on_small_disk(const std::string& size, const std::string& script,
                                          const Environment& environment = {});
// True if this user may create a namespace with its own file system.
[[nodiscard]] bool can_mount();

// Runs a shell script as a user who is restricted by file permissions: root loses its privileges.
[[nodiscard]] RunResult run_without_privileges(const std::string& script);

// A `weft` command with these arguments, quoted for a shell script.
[[nodiscard]] std::string weft_in_shell(const std::vector<std::string>& arguments);

}  // namespace weft::test
