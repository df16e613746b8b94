// Purpose: what all samples of this folder need: values out of results, the input of a session, and command
// buffers. If a Vulkan function fails, std::runtime_error is thrown.
#pragma once

#include <weft/render/session.h>
#include <weft/scene/scene.h>

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "own_device.h"

inline constexpr weft::Extent3D kSize_px{320, 180, 1};

// Returns the value of a result, or throws if the result contains errors. Weft returns errors as values.
template <class T>
T take(weft::Result<T> result) {
    if (!result) throw std::runtime_error(weft::to_text(result.errors()));
    return std::move(*result);
}

// Returns the content of a file.
std::optional<std::string> read_file(const std::string& path);

// Returns the input for a session that renders an installed graph, such as "deferred.json".
weft::render::SessionInput session_input(const std::string& graph, const weft::PassCatalog& passes);

// Returns the first camera and the exposure of the scene, at the time of frame `frame`.
weft::render::FrameInput frame_input(const weft::scene::Scene& scene, int frame);

// A command pool, a timeline semaphore and a binary semaphore of the program.
class OwnCommands {
 public:
    explicit OwnCommands(const OwnDevice& own);
    ~OwnCommands();
    OwnCommands(const OwnCommands&) = delete;

    // Returns a new command buffer in recording state.
    VkCommandBuffer begin() const;
    // Ends and submits a command buffer. It waits for the binary semaphore `wait` and signals `signal` with
    // the value `value` (0 for a binary semaphore). Both may be null.
    void submit(VkCommandBuffer commands, VkSemaphore wait, VkSemaphore signal, uint64_t value) const;
    void wait_for(uint64_t value) const;  // Waits until the timeline semaphore has this value.

    VkSemaphore timeline = VK_NULL_HANDLE;
    VkSemaphore acquired = VK_NULL_HANDLE;  // Binary.
    VkSemaphore rendered = VK_NULL_HANDLE;  // Binary.

 private:
    const OwnDevice& own_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
};

// Fills the image with one colour, and leaves it in the layout SHADER_READ_ONLY_OPTIMAL. Waits for the GPU.
void paint_image(const OwnDevice& own, VkImage image, const std::array<float, 4>& color);

// Creates the device, with the validation layer if the program has the argument --validate, calls `sample`
// and returns the exit code of the program.
int run_sample(int argc, char** argv, void (*sample)(OwnDevice& own));

// Throws unless the picture shows something: not all of its texels have the same value.
void require_picture(const std::vector<uint8_t>& texels);
