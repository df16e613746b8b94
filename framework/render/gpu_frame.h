// Purpose: the descriptor sets that are bound as set 0: one for each pair of a frame slot and a view that
// passes use, and one for each pair of a frame slot and the views of a pass with multiview. Each set refers
// to the frame constants, the sun's shadow cascades, and the view or views of the set. The host writes these
// constants for each frame slot. All sets also refer to the same environment and light functions.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/descriptor_sets.h"
#include "render/frame_data.h"
#include "render/gpu_environment.h"
#include "render/gpu_light_functions.h"
#include "render/views/frame_views.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

class GpuFrame {
 public:
    [[nodiscard]] static Result<GpuFrame> create(vk::Device& device, const scene::Scene& scene);

    // Writes the constants of a frame slot, and makes descriptor sets for views that have none. The slot must
    // not be in flight: Executor::begin_frame() returns a free one. The first view is the camera.
    // `united_views`: the views of each pass with multiview.
    [[nodiscard]] Status write(uint32_t slot, const shared::FrameConstants& frame,
                               const shared::SunConstants& sun, const shared::FurtherSuns& further_suns,
                               std::span<const FrameView> views, std::span<const ViewNames> united_views);
    [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_.layout.get(); }
    // Makes descriptor sets whose views are in buffers; see DrawSource::make_view_sets().
    [[nodiscard]] Result<std::unique_ptr<vk::ViewSets>> make_view_sets(
        std::span<const vk::ViewPlace> places) const;
    // Appends parts of the uniform blocks of a set; see DrawSource::add_frame_bytes().
    void add_bytes(uint32_t slot, std::string_view view, std::span<const FrameRange> ranges,
                   std::vector<std::byte>& bytes) const;
    // Returns descriptor set 0 for a view of the last write(), such as "camera" or "sun(1)". For any other
    // name, returns the set of the camera.
    [[nodiscard]] VkDescriptorSet set(uint32_t slot, std::string_view view) const;
    // Returns descriptor set 0 for several views that one pass draws at once. These views must be an element
    // of `united_views` in the last write().
    [[nodiscard]] VkDescriptorSet set(uint32_t slot, std::span<const std::string> views) const;

 private:
    // Memory and descriptor sets for up to kBlockViews views. Frames in flight may use them, so a block is
    // not freed when the number of views becomes smaller.
    struct ViewBlock {
        DescriptorSets sets;  // Index: slot * kBlockViews + index of the view in the block.
        vk::Buffer constants;
    };
    static constexpr uint32_t kBlockViews = 8;

    // Memory and descriptor sets for the views of a pass with multiview, one part for each frame slot. They
    // are never freed before the GpuFrame, because frames in flight may use them.
    struct ViewArray {
        DescriptorSets sets;
        vk::Buffer constants;
        uint64_t slot_bytes = 0;
    };

    [[nodiscard]] Status add_block();
    void write_views(uint32_t slot, std::span<const FrameView> views);
    // Writes all bindings of a descriptor set 0. `views` has the constants of the view or views.
    void write_set(VkDescriptorSet to, uint32_t slot, const VkDescriptorBufferInfo& views) const;
    [[nodiscard]] Status write_array(uint32_t slot, const ViewNames& names, std::span<const FrameView> views);
    [[nodiscard]] Result<ViewArray> make_array(size_t views) const;
    [[nodiscard]] uint32_t index_of(std::string_view view) const;

    vk::Device* device_ = nullptr;
    DescriptorSets layout_;  // Only the layout of set 0.
    vk::Buffer constants_;   // The constants of the frame, the sun and the further suns.
    std::vector<ViewBlock> blocks_;
    std::map<std::string, uint32_t, std::less<>> index_of_view_;
    std::vector<std::string> names_;  // The names of the views of the last write().
    // For each view and frame slot: the value of FrameView::fixed when the constants in the memory of the
    // slot were written.
    std::vector<std::array<uint64_t, vk::kFramesInFlight>> fixed_;
    std::map<ViewNames, ViewArray> arrays_;
    GpuEnvironment environment_;
    GpuLightFunctions light_functions_;
};

}  // namespace weft::render
