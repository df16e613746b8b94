// Purpose: the contents of a PendingSwap: a whole stage, or only values and pipelines if the plan has the
// same structure, or neither.
#pragma once

#include <memory>
#include <optional>

#include "render/render_stage.h"
#include "weft/load/load_graph.h"
#include "weft/render/pending_swap.h"

namespace weft::render {

struct SwapParts {
    Selection selection;
    Rebuilt rebuilt;
    uint64_t follows = 0;  // StageFingerprint::generation of the stage that this replaces
    StageFingerprint fingerprint;
    std::optional<LoadedGraph> loaded;      // absent: the session keeps its own
    std::optional<ResolvedGraph> resolved;  // for the graph that the session keeps, at the new size
    std::optional<RenderStage> stage;
    std::unique_ptr<vk::Amendment> amendment;
};

}  // namespace weft::render
