// Purpose: from the command line to a session that draws, for the commands that need one.
// Errors: those of scenes (S…), devices (V…) and Session::create().
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

// How the options want the camera's view of the scene drawn.
[[nodiscard]] render::SessionInput session_input(const RenderOptions& options, const PassCatalog& passes);
// The camera's view of the scene at the exposure of the options, or else the scene's own.
[[nodiscard]] render::FrameInput frame_input(const RenderOptions& options, const scene::Scene& scene,
                                             const scene::Camera& camera);
[[nodiscard]] Result<std::unique_ptr<vk::Device>> open_device(const RenderOptions& options);
// Warnings go to stderr.
[[nodiscard]] Result<OpenSession> open_session(const RenderOptions& options);
// The graph's output or a debug view, which are display-encoded already: a PNG takes their bytes as they are.
[[nodiscard]] Status write_output_picture(const std::string& path, const vk::ReadbackData& data);
// Prints what the layers said, pass by pass. True: they said something.
bool report_messages(const std::vector<vk::Message>& messages);
// Prints the errors and returns their exit code; after a time-out it leaves at once, without tearing down
// what the device may still be at work with.
[[nodiscard]] ExitCode fail_on_device(const Diagnostics& errors);

}  // namespace weft::viewer
