// Purpose: how `weft view` begins: with a graph that is good, or that becomes good while it waits.
#pragma once

#include <optional>

#include "viewer/commands/session_setup.h"
#include "viewer/process/end_signals.h"

namespace weft::viewer {

// Opens the session. Where `waits`, a fault in the graph or its shaders is printed, and it tries again each
// time one of their files changes. Nothing: it was told to end before the graph was good. Errors: as
// open_session(); where `waits`, only those that an edit of these files cannot mend.
[[nodiscard]] Result<std::optional<OpenSession>> open_when_good(const RenderOptions& options, bool waits,
                                                                EndSignals& end);

}  // namespace weft::viewer
