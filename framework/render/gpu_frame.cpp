#include "render/gpu_frame.h"

#include <array>
#include <cstring>

namespace weft::render {
namespace {

constexpr uint64_t kViewOffsetBytes = 256;  // the greatest uniform alignment a device may ask for
constexpr uint64_t kSlotBytes = 768;
static_assert(sizeof(shared::FrameConstants) <= kViewOffsetBytes);
static_assert(kViewOffsetBytes + sizeof(shared::ViewConstants) <= kSlotBytes);

constexpr VkShaderStageFlags kStages =
    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
constexpr std::array kBindings{
    VkDescriptorSetLayoutBinding{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, kStages, nullptr},
    VkDescriptorSetLayoutBinding{1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, kStages, nullptr},
    VkDescriptorSetLayoutBinding{2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, kStages, nullptr},
    VkDescriptorSetLayoutBinding{3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, kStages, nullptr},
    VkDescriptorSetLayoutBinding{4, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, kStages, nullptr}};

}  // namespace

Result<GpuFrame> GpuFrame::create(vk::Device& device, const scene::Scene& scene) {
    GpuFrame frame;
    Result<DescriptorSets> sets =
        DescriptorSets::create(device, kBindings, vk::kFramesInFlight, "frame constants");
    if (!sets) return sets.take_errors();
    Result<vk::Buffer> constants =
        vk::Buffer::create(device, kSlotBytes * vk::kFramesInFlight, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                           vk::Buffer::Memory::upload, "frame constants");
    if (!constants) return constants.take_errors();
    Result<GpuEnvironment> surroundings = GpuEnvironment::create(device, scene.environment);
    if (!surroundings) return surroundings.take_errors();
    frame.environment_ = std::move(*surroundings);
    Result<GpuLightFunctions> functions = GpuLightFunctions::create(device, scene);
    if (!functions) return functions.take_errors();
    frame.light_functions_ = std::move(*functions);
    const VkDescriptorImageInfo image = frame.environment_.descriptor(),
                                pictures = frame.light_functions_.pictures();
    const VkDescriptorBufferInfo shapes = frame.light_functions_.functions();
    frame.sets_ = std::move(*sets);
    frame.constants_ = std::move(*constants);
    for (uint32_t slot = 0; slot < vk::kFramesInFlight; ++slot) {
        const uint64_t offset_bytes = slot * kSlotBytes;
        const VkBuffer buffer = frame.constants_.handle();
        const std::array infos{
            VkDescriptorBufferInfo{buffer, offset_bytes, sizeof(shared::FrameConstants)},
            VkDescriptorBufferInfo{buffer, offset_bytes + kViewOffsetBytes, sizeof(shared::ViewConstants)}};
        write_buffers(device, frame.set(slot), 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, infos);
        write_images(device, frame.set(slot), 2, {&image, 1});
        write_buffers(device, frame.set(slot), 3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {&shapes, 1});
        write_images(device, frame.set(slot), 4, {&pictures, 1});
    }
    return frame;
}

void GpuFrame::write(uint32_t slot, const shared::FrameConstants& frame,
                     const shared::ViewConstants& camera) {
    std::byte* memory = constants_.mapped().data() + slot * kSlotBytes;
    std::memcpy(memory, &frame, sizeof frame);
    std::memcpy(memory + kViewOffsetBytes, &camera, sizeof camera);
}

}  // namespace weft::render
