// Purpose: opens a session with the options of the command line, for commands that render. Errors: those of
// scenes (S..., X520 to X522), devices (V...) and Session::create().
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viewer/commands/commands.h"
#include "weft/render/session.h"
#include "weft/scene/camera_path.h"
#include "weft/vulkan/device.h"

namespace weft::viewer {

struct OpenSession {
    std::unique_ptr<vk::Device> device;
    // Input of each frame: the camera and the exposure are set, and the caller sets the times.
    render::FrameInput frame;
    std::optional<scene::CameraPath> camera_path;  // The path of --camera-path.
    // Last member, because the session must be destroyed before the device.
    std::unique_ptr<render::Session> session;
};

// Converts the options of the command line to the input of a session.
[[nodiscard]] render::SessionInput session_input(const RenderOptions& options, const PassCatalog& passes);
// Returns the input of a frame: the camera, and the exposure of the options. Without --exposure, the exposure
// of the scene is used. A graph with automatic exposure uses the exposure of the scene only to scale the
// values that it stores.
[[nodiscard]] render::FrameInput frame_input(const RenderOptions& options, const scene::Scene& scene,
                                             const scene::Camera& camera);
[[nodiscard]] Result<std::unique_ptr<vk::Device>> open_device(const RenderOptions& options);
// Opens the graph, the scene, the device and the session. Warnings are printed to stderr.
[[nodiscard]] Result<OpenSession> open_session(const RenderOptions& options);
// Writes the output of the graph or a debug view as a picture. Both are already encoded for display, so a PNG
// contains their bytes unchanged.
[[nodiscard]] Status write_output_picture(const std::string& path, const vk::ReadbackData& data);
// Prints the messages of the validation layers with the name of the pass. Returns true if there were any
// messages.
bool report_messages(const std::vector<vk::Message>& messages);
// Prints the errors and returns the exit code for them. After a time-out of the device, the function ends the
// process at once, because the device may still use objects that would be destroyed.
[[nodiscard]] ExitCode fail_on_device(const Diagnostics& errors);

}  // namespace weft::viewer
