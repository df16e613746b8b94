// Purpose: the two halves of lock_this_process(), files and system calls, and what they share.
#pragma once

#include <string>

#include "viewer/sandbox/sandbox_kernel.h"

namespace weft::viewer {

// Of Landlock; 0: the kernel has none.
[[nodiscard]] int landlock_version();
[[nodiscard]] Status restrict_files(const OpenRules& rules);
// After restrict_files(): what Landlock of this version lets through by other ways is closed here.
[[nodiscard]] Status restrict_calls(int landlock_version);

// X595.
[[nodiscard]] Diagnostic no_sandbox(const std::string& why, const std::string& help);

}  // namespace weft::viewer
