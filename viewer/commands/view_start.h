// Purpose: the start of `weft view`: opens a session. If the graph has an error, the command waits until the
// user corrects the file.
#pragma once

#include <optional>

#include "viewer/commands/session_setup.h"
#include "viewer/process/end_signals.h"

namespace weft::viewer {

// Opens the session. If `waits` is true, errors in the graph or its shaders are printed, and each change of
// these files leads to a new attempt. Returns nullopt if the user ended the command before a session was
// open. Errors: those of open_session(). If `waits` is true, only errors that an edit of these files cannot
// correct are returned.
[[nodiscard]] Result<std::optional<OpenSession>> open_when_good(const RenderOptions& options, bool waits,
                                                                EndSignals& end);

}  // namespace weft::viewer
