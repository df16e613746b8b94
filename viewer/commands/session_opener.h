// Purpose: opens a session step by step: graph, scene, camera, device, session. After a fault in the graph's
// files the scene and the device are kept, so that trying again is cheap. Errors: as open_session().
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
    // With one attempt the session takes ownership of the scene, which needs less memory.
    enum class Attempts : uint8_t { one, many };
    // `options` must outlive it.
    SessionOpener(const RenderOptions& options, Attempts attempts);

    // Warnings are printed on stderr. With many attempts it may be called again after an error, but not after
    // a success.
    [[nodiscard]] Result<OpenSession> open();

    // After an error: true if an edit of files() may correct it.
    [[nodiscard]] bool is_fixable() const { return is_fixable_; }
    // The files of the graph, its includes and its shaders that were searched, existing or not. Absolute
    // paths.
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }

 private:
    [[nodiscard]] Result<ParsedGraph> parse_checked();
    [[nodiscard]] Status load_scene();
    [[nodiscard]] Result<OpenSession> open_parsed(const ParsedGraph& parsed);

    const RenderOptions& options_;
    const Attempts attempts_;
    const PassCatalog passes_;
    const render::SessionInput input_;
    std::optional<scene::Scene> scene_;
    render::FrameInput frame_;
    std::unique_ptr<vk::Device> device_;
    std::set<std::filesystem::path> files_;
    bool is_fixable_ = false;
};

}  // namespace weft::viewer
