// Purpose: the start of `weft view`: opens a session, or waits until the graph is free of faults.
#pragma once

#include <optional>

#include "viewer/commands/session_setup.h"
#include "viewer/process/end_signals.h"

namespace weft::viewer {

// Opens the session. If `waits`, faults in the graph or its shaders are printed, and each change of one of
// their files leads to another attempt. nullopt: the command was told to end before a session was open.
// Errors: those of open_session(); if `waits`, only errors that an edit of these files cannot correct.
[[nodiscard]] Result<std::optional<OpenSession>> open_when_good(const RenderOptions& options, bool waits,
                                                                EndSignals& end);

}  // namespace weft::viewer
