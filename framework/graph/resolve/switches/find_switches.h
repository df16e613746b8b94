// Purpose: finds the switches of a graph: the parameters that passes name in "switch". Gives each pass its
// switch, and the combinations of the switches in which it runs. Errors: W233 a switch is no parameter, or
// the graph has too many switches; W235 a pass has "switch" together with a key that excludes it.
#pragma once

#include "graph/resolve/expand.h"
#include "graph/resolve/pass_reporter.h"

namespace weft {

void find_switches(const ResolveInput& input, Expansion& expansion, PassReporter& report, Reporter& reporter);

}  // namespace weft
