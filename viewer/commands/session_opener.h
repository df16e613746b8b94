// Purpose: opens a session in steps: graph, scene, camera, device, session. If the files of the graph contain
// an error, the loaded scene and the device are kept, so that the next attempt is fast. Errors: those of
// open_session().
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "viewer/commands/session_setup.h"
#include "weft/scene/scene.h"

namespace weft::viewer {

class SessionOpener {
 public:
    // If open() is called only once (`one`), the session takes ownership of the scene instead of a copy. This
    // needs less memory.
    enum class Attempts : uint8_t { one, many };
    // `options` must exist as long as the SessionOpener, which stores a reference.
    SessionOpener(const RenderOptions& options, Attempts attempts);

    // Opens the session and prints warnings to stderr. With Attempts::many, the function may be called again
    // after an error, but not after a success.
    [[nodiscard]] Result<OpenSession> open();

    // Returns true if the last open() failed because of the files of the graph, so that an edit of files()
    // may correct the error.
    [[nodiscard]] bool is_fixable() const { return is_fixable_; }
    // Returns the absolute paths of the graph, its includes and its shaders. Paths that were searched but do
    // not exist are in the list, too, because the user may create these files.
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }

 private:
    [[nodiscard]] Result<ParsedGraph> parse_checked();
    [[nodiscard]] Status load_scene(bool automatic_exposure);
    // Finds the probes of the scene, if the graph can use them.
    [[nodiscard]] Status load_probes(const GraphDesc& graph);
    [[nodiscard]] Result<OpenSession> open_parsed(const ParsedGraph& parsed);

    const RenderOptions& options_;
    const Attempts attempts_;
    const PassCatalog passes_;
    const render::SessionInput input_;
    std::optional<scene::Scene> scene_;
    std::optional<scene::Probes> probes_;
    render::FrameInput frame_;
    std::optional<scene::CameraPath> camera_path_;
    std::unique_ptr<vk::Device> device_;
    std::set<std::filesystem::path> files_;
    bool is_fixable_ = false;
};

}  // namespace weft::viewer
