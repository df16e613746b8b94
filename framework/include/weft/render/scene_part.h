// Purpose: a part of a scene that is added to a running session: meshes, textures, materials and instances.
// Session::prepare_part() makes it on any thread, Session::add_part() shows it from the next frame on.
#pragma once

#include <memory>

namespace weft::render {

struct PendingPart;

// A part that is not drawn yet. Its memory is allocated and filled, but nothing has been submitted.
class ScenePart {
 public:
    explicit ScenePart(std::unique_ptr<PendingPart> pending);
    ~ScenePart();
    ScenePart(ScenePart&& other) noexcept;
    ScenePart& operator=(ScenePart&& other) noexcept;

    [[nodiscard]] std::unique_ptr<PendingPart> take();

 private:
    std::unique_ptr<PendingPart> pending_;
};

}  // namespace weft::render
