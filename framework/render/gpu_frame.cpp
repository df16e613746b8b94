#include "render/gpu_frame.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "render/scene_bindings.h"
#include "weft/vulkan/draw_source.h"

namespace weft::render {
namespace {

// Each part of a buffer of constants starts at a multiple of 256 bytes, the largest
// minUniformBufferOffsetAlignment that Vulkan allows.
constexpr uint64_t kAlignmentBytes = 256;
// The memory of a frame slot. The memory of the views is separate.
struct FrameSlot {
    alignas(kAlignmentBytes) shared::FrameConstants frame;
    alignas(kAlignmentBytes) shared::SunConstants sun;
    alignas(kAlignmentBytes) shared::FurtherSuns further_suns;
};
constexpr uint64_t kSunOffsetBytes = offsetof(FrameSlot, sun);
constexpr uint64_t kFurtherSunsOffsetBytes = offsetof(FrameSlot, further_suns);
constexpr uint64_t kViewBytes = sizeof(shared::ViewConstants);
// A graph can have a buffer with the constants of several views, one after another. So the size of
// ViewConstants itself must be a multiple of 256 bytes, too.
static_assert(kViewBytes % kAlignmentBytes == 0);
static_assert(kViewBytes == vk::kViewStrideBytes);
static_assert(offsetof(shared::ViewConstants, number) == vk::kViewNumberOffsetBytes);

// The descriptor sets of an executor whose passes read views from buffers.
class BufferViewSets final : public vk::ViewSets {
 public:
    explicit BufferViewSets(DescriptorSets sets) : sets_(std::move(sets)) {}
    [[nodiscard]] VkDescriptorSet set(size_t index) const override { return sets_.sets[index]; }

 private:
    DescriptorSets sets_;
};

Result<vk::Buffer> make_constants(vk::Device& device, uint64_t bytes) {
    return vk::Buffer::create(device, bytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, vk::Buffer::Memory::upload,
                              "frame constants");
}

}  // namespace

Result<GpuFrame> GpuFrame::create(vk::Device& device, const scene::Scene& scene) {
    GpuFrame frame;
    frame.device_ = &device;
    Result<DescriptorSets> layout = DescriptorSets::create(device, layout_bindings(0), 0, "frame constants");
    if (!layout) return layout.take_errors();
    Result<vk::Buffer> constants = make_constants(device, sizeof(FrameSlot) * vk::kFramesInFlight);
    if (!constants) return constants.take_errors();
    Result<GpuEnvironment> surroundings = GpuEnvironment::create(device, scene.environment);
    if (!surroundings) return surroundings.take_errors();
    Result<GpuLightFunctions> functions = GpuLightFunctions::create(device, scene);
    if (!functions) return functions.take_errors();
    frame.layout_ = std::move(*layout);
    frame.constants_ = std::move(*constants);
    frame.environment_ = std::move(*surroundings);
    frame.light_functions_ = std::move(*functions);
    if (Status added = frame.add_block(); !added) return added.take_errors();
    return frame;
}

Status GpuFrame::add_block() {
    ViewBlock block;
    constexpr uint32_t kSets = vk::kFramesInFlight * kBlockViews;
    Result<DescriptorSets> sets =
        DescriptorSets::create(*device_, layout_bindings(0), kSets, "frame constants");
    if (!sets) return sets.take_errors();
    Result<vk::Buffer> constants = make_constants(*device_, kSets * kViewBytes);
    if (!constants) return constants.take_errors();
    block.sets = std::move(*sets);
    block.constants = std::move(*constants);
    for (uint32_t set = 0; set < kSets; ++set)
        write_set(block.sets.sets[set], set / kBlockViews,
                  {block.constants.handle(), set * kViewBytes, kViewBytes});
    blocks_.push_back(std::move(block));
    return Unit{};
}

Result<std::unique_ptr<vk::ViewSets>> GpuFrame::make_view_sets(std::span<const vk::ViewPlace> places) const {
    const auto count = static_cast<uint32_t>(places.size());
    Result<DescriptorSets> sets =
        DescriptorSets::create(*device_, layout_bindings(0), count, "views in buffers");
    if (!sets) return sets.take_errors();
    for (uint32_t i = 0; i < count; ++i)
        write_set(sets->sets[i], places[i].frame_slot,
                  {places[i].buffer, places[i].offset_bytes, kViewBytes});
    return std::unique_ptr<vk::ViewSets>(std::make_unique<BufferViewSets>(std::move(*sets)));
}

void GpuFrame::write_set(VkDescriptorSet to, uint32_t slot, const VkDescriptorBufferInfo& views) const {
    const uint64_t slot_bytes = slot * sizeof(FrameSlot);
    const VkDescriptorImageInfo image = environment_.descriptor(), light = environment_.light_descriptor(),
                                pictures = light_functions_.pictures();
    const VkDescriptorBufferInfo shapes = light_functions_.functions();
    const std::array infos{
        VkDescriptorBufferInfo{constants_.handle(), slot_bytes, sizeof(shared::FrameConstants)}, views};
    const VkDescriptorBufferInfo sun{constants_.handle(), slot_bytes + kSunOffsetBytes,
                                     sizeof(shared::SunConstants)};
    const VkDescriptorBufferInfo further{constants_.handle(), slot_bytes + kFurtherSunsOffsetBytes,
                                         sizeof(shared::FurtherSuns)};
    write_buffers(*device_, to, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, infos);
    write_images(*device_, to, 2, {&image, 1});
    write_buffers(*device_, to, 3, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {&sun, 1});
    write_buffers(*device_, to, 4, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {&shapes, 1});
    write_images(*device_, to, 5, {&pictures, 1});
    write_images(*device_, to, 6, {&light, 1});
    write_buffers(*device_, to, 7, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {&further, 1});
}

uint32_t GpuFrame::index_of(std::string_view view) const {
    const auto found = index_of_view_.find(view);
    return found != index_of_view_.end() ? found->second : 0;
}

VkDescriptorSet GpuFrame::set(uint32_t slot, std::string_view view) const {
    const uint32_t index = index_of(view);
    return blocks_[index / kBlockViews].sets.sets[slot * kBlockViews + index % kBlockViews];
}

VkDescriptorSet GpuFrame::set(uint32_t slot, std::span<const std::string> views) const {
    return arrays_.at(ViewNames(views.begin(), views.end())).sets.sets[slot];
}

void GpuFrame::add_bytes(uint32_t slot, std::string_view view, std::span<const FrameRange> ranges,
                         std::vector<std::byte>& bytes) const {
    const std::span<const std::byte> memory =
        std::as_const(constants_).mapped().subspan(slot * sizeof(FrameSlot), sizeof(FrameSlot));
    const uint32_t index = index_of(view);
    const std::span<const std::byte> of_view =
        std::as_const(blocks_[index / kBlockViews].constants)
            .mapped()
            .subspan((slot * kBlockViews + index % kBlockViews) * kViewBytes, kViewBytes);
    for (const FrameRange& range : ranges) {
        const uint64_t block = range.binding == 3   ? kSunOffsetBytes
                               : range.binding == 7 ? kFurtherSunsOffsetBytes
                                                    : 0;
        const std::span<const std::byte> from = range.binding == 1 ? of_view : memory.subspan(block);
        const auto part = from.subspan(range.offset_bytes, range.size_bytes);
        bytes.insert(bytes.end(), part.begin(), part.end());
    }
}

Status GpuFrame::write(uint32_t slot, const shared::FrameConstants& frame, const shared::SunConstants& sun,
                       const shared::FurtherSuns& further_suns, std::span<const FrameView> views,
                       std::span<const ViewNames> united_views) {
    while (blocks_.size() * kBlockViews < views.size())
        if (Status added = add_block(); !added) return added;
    std::byte* memory = constants_.mapped().data() + slot * sizeof(FrameSlot);
    std::memcpy(memory, &frame, sizeof frame);
    std::memcpy(memory + kSunOffsetBytes, &sun, sizeof sun);
    std::memcpy(memory + kFurtherSunsOffsetBytes, &further_suns, sizeof further_suns);
    write_views(slot, views);
    for (const ViewNames& names : united_views)
        if (Status written = write_array(slot, names, views); !written) return written;
    return Unit{};
}

// Writes the constants of the views, except those that the memory of the slot already has.
void GpuFrame::write_views(uint32_t slot, std::span<const FrameView> views) {
    if (!std::ranges::equal(names_, views, {}, {}, &FrameView::name)) {
        names_.clear();
        index_of_view_.clear();
        for (const FrameView& view : views) {
            index_of_view_.emplace(view.name, static_cast<uint32_t>(names_.size()));
            names_.push_back(view.name);
        }
    }
    fixed_.resize(std::max(fixed_.size(), views.size()));
    for (uint32_t i = 0; i < views.size(); ++i) {
        const uint64_t was_fixed = std::exchange(fixed_[i][slot], views[i].fixed);
        if (views[i].fixed != 0 && was_fixed == views[i].fixed) continue;
        std::byte* to = blocks_[i / kBlockViews].constants.mapped().data();
        std::memcpy(to + (slot * kBlockViews + i % kBlockViews) * kViewBytes, &views[i].constants,
                    sizeof views[i].constants);
    }
}

Result<GpuFrame::ViewArray> GpuFrame::make_array(size_t views) const {
    ViewArray array;
    array.slot_bytes = views * kViewBytes;
    Result<DescriptorSets> sets =
        DescriptorSets::create(*device_, layout_bindings(0), vk::kFramesInFlight, "frame constants");
    if (!sets) return sets.take_errors();
    Result<vk::Buffer> constants = make_constants(*device_, array.slot_bytes * vk::kFramesInFlight);
    if (!constants) return constants.take_errors();
    array.sets = std::move(*sets);
    array.constants = std::move(*constants);
    for (uint32_t slot = 0; slot < vk::kFramesInFlight; ++slot)
        write_set(array.sets.sets[slot], slot,
                  {array.constants.handle(), slot * array.slot_bytes, array.slot_bytes});
    return array;
}

Status GpuFrame::write_array(uint32_t slot, const ViewNames& names, std::span<const FrameView> views) {
    auto array = arrays_.find(names);
    if (array == arrays_.end()) {
        Result<ViewArray> made = make_array(names.size());
        if (!made) return made.take_errors();
        array = arrays_.emplace(names, std::move(*made)).first;
    }
    std::byte* to = array->second.constants.mapped().data() + slot * array->second.slot_bytes;
    for (size_t i = 0; i < names.size(); ++i) {
        const shared::ViewConstants& constants = views[index_of(names[i])].constants;
        std::memcpy(to + i * kViewBytes, &constants, sizeof constants);
    }
    return Unit{};
}

}  // namespace weft::render
