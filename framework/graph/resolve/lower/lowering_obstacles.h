// Purpose: finds the rules of a pass, of its list of views and of the device that forbid a lowering (a way to
// draw several views with one pass). Private to choose_lowering().
#pragma once

#include <optional>
#include <string>

#include "graph/resolve/shape_resources.h"

namespace weft {

// The reason why a lowering is not possible, and what the author can change. The reason is empty if the pass
// has a fault that a later stage reports.
struct LoweringObstacle {
    std::string reason;
    std::string remedy;
};

struct LoweringParts {
    const ResolveInput& input;
    const Values& values;
    const Shapes& shapes;
    const PassDesc& desc;
    const ViewList& list;
    const ShaderInterface& shader;
};

// Returns the first obstacle for drawing all views by one pass, whatever the lowering.
[[nodiscard]] std::optional<LoweringObstacle> one_pass_obstacle(const LoweringParts& parts,
                                                                Reporter& reporter);
[[nodiscard]] std::optional<LoweringObstacle> multiview_obstacle(const LoweringParts& parts);
[[nodiscard]] std::optional<LoweringObstacle> layer_output_obstacle(const LoweringParts& parts);

}  // namespace weft
