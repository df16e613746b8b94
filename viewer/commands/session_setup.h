// Purpose: makes a session from the command line, for commands that render. Errors: those of scenes (S…),
// devices (V…) and Session::create().
#pragma once

#include <memory>
#include <vector>

#include "viewer/commands/commands.h"
#include "weft/render/session.h"
#include "weft/vulkan/device.h"

namespace weft::viewer {

struct OpenSession {
    std::unique_ptr<vk::Device> device;
    render::FrameInput frame;                  // with the camera and the exposure; the caller sets the times
    std::unique_ptr<render::Session> session;  // last: destroyed first
};

// The session's input for these options.
[[nodiscard]] render::SessionInput session_input(const RenderOptions& options, const PassCatalog& passes);
// The camera's view of the scene, at the exposure of the options, or else the scene's exposure.
[[nodiscard]] render::FrameInput frame_input(const RenderOptions& options, const scene::Scene& scene,
                                             const scene::Camera& camera);
[[nodiscard]] Result<std::unique_ptr<vk::Device>> open_device(const RenderOptions& options);
// Warnings are printed on stderr.
[[nodiscard]] Result<OpenSession> open_session(const RenderOptions& options);
// For the graph's output or a debug view, which are display-encoded: a PNG stores their bytes unchanged.
[[nodiscard]] Status write_output_picture(const std::string& path, const vk::ReadbackData& data);
// Prints the messages of the validation layers, by pass. True if there were any.
bool report_messages(const std::vector<vk::Message>& messages);
// Prints the errors and returns their exit code. After a time-out it exits at once, without destroying
// objects that the device may still use.
[[nodiscard]] ExitCode fail_on_device(const Diagnostics& errors);

}  // namespace weft::viewer
