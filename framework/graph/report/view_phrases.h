// Purpose: returns texts that say which views a pass draws, and how.
#pragma once

#include <string>

#include "weft/plan.h"

namespace weft {

// Returns the views that the pass draws, such as "probe(0) to probe(5)" or "camera".
[[nodiscard]] std::string view_range(const PassDecl& pass);
// Returns how the views of a pass with "into": "layers" are drawn, and why, such as: "probe(0) to probe(5) in
// one pass, lowering multiview: the graph asks for it". Empty for other passes.
[[nodiscard]] std::string describe_lowering(const PassDecl& pass);

}  // namespace weft
