// Purpose: the parts of a Session, which only connects them.
#pragma once

#include <memory>

#include "render/drawn_scene.h"
#include "render/frame_loop.h"
#include "render/running_graph.h"

namespace weft::render {

struct SessionParts {
    DrawnScene scene;
    std::unique_ptr<RunningGraph> graph;
    FrameLoop frames;  // last: destroyed first
};

}  // namespace weft::render
