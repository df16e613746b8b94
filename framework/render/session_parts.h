// Purpose: the parts of a Session. A Session only connects them.
#pragma once

#include <memory>

#include "render/drawn_scene.h"
#include "render/frame_loop.h"
#include "render/running_graph.h"

namespace weft::render {

struct SessionParts {
    vk::Device& device;
    DrawnScene scene;
    std::unique_ptr<RunningGraph> graph;
    // Declared last, so that `frames` is destroyed before the other members: frames in flight use the scene.
    FrameLoop frames;
};

}  // namespace weft::render
