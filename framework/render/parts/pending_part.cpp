#include "render/parts/pending_part.h"

#include <utility>

namespace weft::render {

ScenePart::ScenePart(std::unique_ptr<PendingPart> pending) : pending_(std::move(pending)) {}
ScenePart::~ScenePart() = default;
ScenePart::ScenePart(ScenePart&& other) noexcept = default;
ScenePart& ScenePart::operator=(ScenePart&& other) noexcept = default;

std::unique_ptr<PendingPart> ScenePart::take() {
    return std::move(pending_);
}

Result<ScenePart> make_part(vk::Device& device, const scene::Scene& scene, bool moves_instances) {
    Result<std::unique_ptr<vk::UploadBatch>> uploads = vk::UploadBatch::create(device);
    if (!uploads) return uploads.take_errors();
    Result<std::unique_ptr<GpuPart>> part =
        GpuPart::create({device, scene, nullptr, **uploads, moves_instances, false});
    if (!part) return part.take_errors();
    if (Status ended = (*uploads)->end(); !ended) return ended.take_errors();
    auto pending = std::make_unique<PendingPart>();
    pending->part = std::move(*part);
    pending->uploads = std::move(*uploads);
    return ScenePart(std::move(pending));
}

}  // namespace weft::render
