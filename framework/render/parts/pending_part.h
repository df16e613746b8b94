// Purpose: a part of a scene whose objects exist, but which the session does not draw yet.
#pragma once

#include <memory>

#include "render/parts/gpu_part.h"
#include "vulkan/memory/uploader.h"
#include "weft/render/scene_part.h"

namespace weft::render {

struct PendingPart {
    std::unique_ptr<GpuPart> part;
    // Declared last, so that `uploads` is destroyed first: its destructor waits for the copies to the part.
    std::unique_ptr<vk::UploadBatch> uploads;
};

// Makes a part and records the copies of its data. May be called from any thread.
[[nodiscard]] Result<ScenePart> make_part(vk::Device& device, const scene::Scene& scene,
                                          bool moves_instances);

}  // namespace weft::render
