// Purpose: the two parts of lock_this_process(), for files and system calls, and shared functions.
#pragma once

#include <string>

#include "viewer/sandbox/sandbox_kernel.h"

namespace weft::viewer {

// The version of Landlock; 0: the kernel does not support it.
[[nodiscard]] int landlock_version();
[[nodiscard]] Status restrict_files(const OpenRules& rules);
// Call this after restrict_files(). It also refuses system calls that would bypass this version of Landlock.
[[nodiscard]] Status restrict_calls(int landlock_version);

// Builds the error X595.
[[nodiscard]] Diagnostic no_sandbox(const std::string& why, const std::string& help);

}  // namespace weft::viewer
