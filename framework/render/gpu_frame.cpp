#include "render/gpu_frame.h"

#include <array>
#include <cstring>

#include "render/scene_bindings.h"

namespace weft::render {
namespace {

// The memory of a frame slot contains the frame constants, then the sun's constants, then the views: the
// camera's view, and one view for each of the sun's cascades. Each part starts at a multiple of 256 bytes,
// the largest minUniformBufferOffsetAlignment that Vulkan allows.
constexpr uint64_t kAlignmentBytes = 256;
constexpr uint64_t kSunOffsetBytes = 256;
constexpr uint64_t kViewsOffsetBytes = 768;
constexpr uint64_t kViewBytes = 512;
constexpr uint32_t kViews = 1 + shared::kMostSunCascades;
constexpr uint64_t kSlotBytes = kViewsOffsetBytes + kViews * kViewBytes;
static_assert(kSunOffsetBytes % kAlignmentBytes == 0 && kViewsOffsetBytes % kAlignmentBytes == 0 &&
              kViewBytes % kAlignmentBytes == 0);
static_assert(sizeof(shared::FrameConstants) <= kSunOffsetBytes);
static_assert(kSunOffsetBytes + sizeof(shared::SunConstants) <= kViewsOffsetBytes);
static_assert(sizeof(shared::ViewConstants) <= kViewBytes);

// Returns the index of a view in the memory of a slot: i + 1 for the sun's cascade i, 0 for all other names.
uint32_t index_of(std::string_view view) {
    for (uint32_t i = 0; i + 1 < kViews; ++i)
        if (view == sun_view_name(i)) return i + 1;
    return 0;
}

}  // namespace

Result<GpuFrame> GpuFrame::create(vk::Device& device, const scene::Scene& scene) {
    GpuFrame frame;
    Result<DescriptorSets> sets =
        DescriptorSets::create(device, layout_bindings(0), vk::kFramesInFlight * kViews, "frame constants");
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
    for (uint32_t set = 0; set < vk::kFramesInFlight * kViews; ++set) {
        const uint64_t slot_bytes = set / kViews * kSlotBytes;
        const uint64_t view_bytes = slot_bytes + kViewsOffsetBytes + set % kViews * kViewBytes;
        const VkBuffer buffer = frame.constants_.handle();
        const std::array infos{VkDescriptorBufferInfo{buffer, slot_bytes, sizeof(shared::FrameConstants)},
                               VkDescriptorBufferInfo{buffer, view_bytes, sizeof(shared::ViewConstants)}};
        const VkDescriptorBufferInfo sun{buffer, slot_bytes + kSunOffsetBytes, sizeof(shared::SunConstants)};
        write_buffers(device, frame.sets_.sets[set], 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, infos);
        write_images(device, frame.sets_.sets[set], 2, {&image, 1});
        write_buffers(device, frame.sets_.sets[set], 3, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {&sun, 1});
        write_buffers(device, frame.sets_.sets[set], 4, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {&shapes, 1});
        write_images(device, frame.sets_.sets[set], 5, {&pictures, 1});
    }
    return frame;
}

VkDescriptorSet GpuFrame::set(uint32_t slot, std::string_view view) const {
    return sets_.sets[slot * kViews + index_of(view)];
}

void GpuFrame::add_bytes(uint32_t slot, std::string_view view, std::span<const FrameRange> ranges,
                         std::vector<std::byte>& bytes) const {
    const std::span<const std::byte> memory =
        std::as_const(constants_).mapped().subspan(slot * kSlotBytes, kSlotBytes);
    for (const FrameRange& range : ranges) {
        uint64_t block = 0;  // The frame constants.
        if (range.binding == 1) block = kViewsOffsetBytes + index_of(view) * kViewBytes;
        if (range.binding == 3) block = kSunOffsetBytes;
        const auto part = memory.subspan(block + range.offset_bytes, range.size_bytes);
        bytes.insert(bytes.end(), part.begin(), part.end());
    }
}

void GpuFrame::write(uint32_t slot, const shared::FrameConstants& frame, const shared::ViewConstants& camera,
                     const SunCascades& sun) {
    std::byte* memory = constants_.mapped().data() + slot * kSlotBytes;
    std::memcpy(memory, &frame, sizeof frame);
    std::memcpy(memory + kSunOffsetBytes, &sun.constants, sizeof sun.constants);
    memory += kViewsOffsetBytes;
    std::memcpy(memory, &camera, sizeof camera);
    for (uint32_t i = 0; i < sun.count; ++i)
        std::memcpy(memory + (i + 1) * kViewBytes, &sun.views[i], sizeof sun.views[i]);
}

}  // namespace weft::render
