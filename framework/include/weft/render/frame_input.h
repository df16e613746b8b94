// Purpose: the values that a program may change from frame to frame. Of the graph's parameters, only switches
// and scales of live sizes are among them: to change another parameter, swap the plan (Session::prepare()).
// Units: seconds; exposure in EV (radiance is stored multiplied by 2^EV).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/live_value.h"
#include "weft/pass.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/frame_submit.h"

namespace weft::render {

// The matrices of one view of the program. Clip space is Vulkan's, with y down; depth is 1 at the near plane
// and falls with the distance.
struct ViewInput {
    glm::mat4 view{1};        // From world space to view space.
    glm::mat4 projection{1};  // From view space to clip space.
};

// Views by the name of an import of kind "views".
using ViewLists = std::map<std::string, std::vector<ViewInput>, std::less<>>;

struct FrameInput {
    // A camera whose `node` is not kNone moves: its transform comes from the node at `time_s`.
    scene::Camera camera;
    float exposure_ev = 0;
    double time_s = 0;
    double delta_time_s = 0;  // Time since the previous frame.
    // Lists of turns. Key: the name of an import of kind "turns", which a group of passes uses. Value: the
    // numbers of the rounds of that group that run in this frame, in the order in which they run. Without an
    // entry, the group itself chooses: its rounds run in turn.
    std::map<std::string, std::vector<uint32_t>, std::less<>> turns = {};
    // Switches of this frame. Key: the name of a parameter that passes name in "switch". Value: false turns
    // these passes off. Without an entry, the value of the parameter decides. Other names are ignored. Params
    // blocks keep the value of the parameter.
    std::map<std::string, bool, std::less<>> switches = {};
    // The views of this frame for each list in SessionInput::views that the graph uses.
    ViewLists views = {};
    // Scales of the graph's live sizes in this frame, by the name of the parameter. They are clamped to the
    // ranges of the parameters. A scale that is not in the map has the value of its parameter.
    Scales scales = {};
    // Values of the program for passes in C++, by name; may be null. Weft adds the value "lights".
    const HostInputs* host = nullptr;
    // How the frame reaches the GPU: semaphores of the program, or a command buffer of the program.
    vk::FrameSubmit submit = {};
};

}  // namespace weft::render
