// Purpose: the values that a program may change from frame to frame. They include those parameters of the
// graph that can change without a new plan. To change another parameter, prepare a new plan and swap to it
// (Session::prepare(), swap_in()). Units: metres, seconds; exposure in EV (radiance is stored multiplied by
// 2^EV).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

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

// The number of a part of the scene that Session::add_part() has added. The scene with which the session was
// created is the part kFirstPart.
using PartId = uint64_t;
inline constexpr PartId kFirstPart = 0;

// A new transform of an instance. It stays until the next new transform.
struct InstanceTransform {
    uint32_t instance = 0;   // Index into Scene::instances of the part.
    glm::mat4 transform{1};  // From object space to world space.
    PartId part = kFirstPart;
};

// Values of the graph's parameters by name.
using ParameterValues = std::map<std::string, double, std::less<>>;

// The colours of the sky: radiance in cd/m².
struct SkyColors {
    glm::vec3 zenith{0};
    glm::vec3 horizon{0};
    // The colour below the horizon. Absent: the light of the horizon, reflected by a grey ground.
    std::optional<glm::vec3> ground = {};
};

struct FrameInput {
    // A camera whose `node` is not kNone moves: its transform comes from the node at `time_s`.
    scene::Camera camera;
    // The pre-exposure in EV: radiance is stored multiplied by 2^exposure_ev. It is also the exposure of the
    // picture, unless the graph has automatic exposure (modules/exposure.json) and its parameter
    // `autoExposure` is not 0.
    float exposure_ev = 0;
    double time_s = 0;
    double delta_time_s = 0;  // Time since the previous frame.
    // True: the camera has jumped since the previous frame. Shaders then see no history in this frame:
    // `<port>Valid` is 0 for each port that reads an earlier frame, and the view of this frame is also used
    // as the view of the previous frame.
    bool camera_cut = false;
    // The rounds of groups that run in this frame. A round is one copy of all passes of a group. Key: the
    // name of the import of kind "turns" that the group uses. Value: the numbers of the rounds, in the order
    // in which they run. Without an entry, the rounds of the group take turns.
    std::map<std::string, std::vector<uint32_t>, std::less<>> turns = {};
    // The views of this frame for each list in SessionInput::views that the graph uses.
    ViewLists views = {};
    // Values of the graph's parameters. A value stays until the next value of the same parameter, or until
    // Session::swap_in(), resize() or rebind(). Three kinds of parameters can change here, without a new plan
    // and without a Vulkan object:
    // - Parameters of cost `live`, as `weft plan` lists them: the expressions of the graph are evaluated
    //   once.
    // - Switches: 0 turns the passes with this switch off, any other value turns them on. In the `Params`
    //   blocks of shaders, the parameter keeps the value with which the graph was prepared. The change
    //   allocates no memory.
    // - Scales of live sizes (the used areas of images, which may change in every frame), clamped to the
    //   range of the parameter. The change allocates no memory.
    // Error: W242.
    ParameterValues parameters = {};
    // The lights of this frame; they replace the lights of the scene. Their `node` is ignored. The graph's
    // buffer of lights has a fixed size: further lights are left out. Absent: the lights of the scene.
    std::optional<std::vector<scene::Light>> lights = {};
    // The sky of this frame; it replaces the colours of the scene. A scene with an environment map shows this
    // map instead. Absent: the colours of the scene, which are black in a session without a scene.
    std::optional<SkyColors> sky = {};
    // The instances that move in this frame. The part must have been made with `moves_instances`, and the
    // instance must not follow a node. Error: W244.
    std::vector<InstanceTransform> transforms = {};
    // Called once in render_frame(), when the GPU no longer reads the buffers of the frame's slot: the
    // program writes its own buffers of this slot here (ImportObject::slot_buffers). May be empty.
    std::function<void(uint32_t slot)> fill_slot = {};
    // Versions of the contents of the program's own imports, by name. Give an import a new number whenever
    // its content changes. A pass with "rest" is skipped while its inputs stay the same. If it reads an
    // import without a version, it runs in every frame.
    std::map<std::string, uint64_t, std::less<>> import_versions = {};
    // Values of the program for passes in C++, by name; may be null. Weft adds the value "lights".
    const HostInputs* host = nullptr;
    // How the frame reaches the GPU: semaphores of the program, or a command buffer of the program.
    vk::FrameSubmit submit = {};
};

}  // namespace weft::render
