// Purpose: the contents of a PendingSwap, which can replace the running graph. If the structure of the plan
// changed, the parts contain a whole new `stage`. If only values or pipelines changed, they contain an
// `amendment` for the running stage. If nothing changed, they contain neither.
#pragma once

#include <memory>
#include <optional>

#include "render/graph_loader.h"
#include "render/render_stage.h"
#include "weft/render/pending_swap.h"

namespace weft::render {

struct SwapParts {
    Selection selection;
    Rebuilt rebuilt;
    // StageFingerprint::generation of the stage that these parts are meant to replace.
    uint64_t follows = 0;
    StageFingerprint fingerprint;
    // The newly loaded graph; absent if the session keeps its loaded graph.
    std::optional<LoadedGraph> loaded;
    // The session's loaded graph with a new size or new values of parameters; absent if `loaded` has them, or
    // if both stay the same.
    std::optional<ResolvedGraph> resolved;
    std::optional<RenderStage> stage;
    std::unique_ptr<vk::Amendment> amendment;
};

}  // namespace weft::render
