// Purpose: the two parts of lock_this_process(), one for files and one for system calls, and functions that
// both use.
#pragma once

#include <string>

#include "viewer/sandbox/sandbox_kernel.h"

namespace weft::viewer {

// Returns the version of Landlock in the running kernel, or 0 if the kernel does not support Landlock.
[[nodiscard]] int landlock_version();
[[nodiscard]] Status restrict_files(const OpenRules& rules);
// Restricts the system calls. Older versions of Landlock do not restrict some calls, so the function refuses
// these calls itself. It must be called after restrict_files().
[[nodiscard]] Status restrict_calls(int landlock_version);

// Returns the error X595: the sandbox is not available, because of the reason `why`.
[[nodiscard]] Diagnostic no_sandbox(const std::string& why, const std::string& help);

}  // namespace weft::viewer
