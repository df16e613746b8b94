// Purpose: chooses how the views of a pass with "into": "layers" are drawn: by one pass with multiview, by
// one pass whose vertex stage selects the layer, or by one pass for each view. Part of expand(), because the
// choice determines how many passes a description results in.
#pragma once

#include "graph/resolve/shape_resources.h"

namespace weft {

struct ChosenLowering {
    ViewLowering kind = ViewLowering::none;  // none: one pass for each view.
    uint32_t views = 0;                      // Number of views, if one pass draws all of them.
    std::string reason;                      // As PassDecl::lowering_reason.
};

// Returns the lowering (the way in which the views are drawn) of a pass whose views are drawn to layers. By
// default, the result is the first possible choice of this list: layer output, if the pass leaves out draws;
// multiview; one pass for each view. This function is the only place that decides.
// Errors: W199 (the author's choice is not possible). Reports nothing else: after any other fault it chooses
// one pass for each view, and a later stage reports the fault.
[[nodiscard]] ChosenLowering choose_lowering(const ResolveInput& input, const Values& values,
                                             const Shapes& shapes, const PassDesc& desc, Reporter& reporter);

}  // namespace weft
