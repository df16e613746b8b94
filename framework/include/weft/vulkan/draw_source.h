// Purpose: the interface through which the executor gets the draws of raster passes. weft_render implements
// it for scenes. The executor asks for the layouts of sets 0, 2 and 3 when it creates pipelines, and for the
// draws when it records commands.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weft/imports.h"
#include "weft/live_value.h"
#include "weft/result.h"
#include "weft/shader_interface.h"
#include "weft/vulkan/device.h"

namespace weft::vk {

// In the descriptor set of several views, the constants of view i begin at i times this number of bytes.
inline constexpr uint32_t kViewStrideBytes = 512;
// Offset of the number of a view in its list, within the constants of the view (binding 1 of descriptor set
// 0). Passes with layer output, whose vertex shader selects the layer by this number, read it.
inline constexpr uint32_t kViewNumberOffsetBytes = 424;

// The attachments of a pass, as a pipeline that draws in the pass needs them.
struct DrawTargets {
    static constexpr uint32_t kMost = 8;
    // Formats by the location of the fragment shader's output; VK_FORMAT_UNDEFINED: no attachment.
    std::array<VkFormat, kMost> colors{};
    uint32_t color_count = 0;
    VkFormat depth = VK_FORMAT_UNDEFINED;
    VkFormat stencil = VK_FORMAT_UNDEFINED;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    uint32_t view_mask = 0;  // The views that each draw draws; 0 without multiview.
    // The size of the area that the pass draws, at the top left of the attachments. For attachments with a
    // live size it changes from frame to frame.
    VkExtent2D extent{};
};

struct DrawContext {
    const DeviceFunctions* fn = nullptr;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::string_view list;  // Name of the draw list, such as "opaque".
    std::string_view view;  // The view that is drawn, such as "camera".
    // With multiview: all views that the draws draw; `view` is the first of them. Else empty.
    std::span<const std::string> views;
    // Index into ImportDecl::variants of the list. The executor has bound the pipeline of this variant.
    uint32_t variant = 0;
    // If `cull` is `material`, the draw source sets the cull mode of each draw. For every value of `cull` it
    // sets the front face of each draw, because mirrored objects have the opposite winding, and so have
    // all objects in a mirrored view.
    CullMode cull = CullMode::material;
    uint32_t frame_slot = 0;  // Less than kFramesInFlight.
    // A buffer with one packed VkDrawIndexedIndirectCommand for each draw of the list, in the order of the
    // list, from the offset on. It replaces the list's own draw commands. Null: the list's own commands are
    // used.
    VkBuffer draw_commands = VK_NULL_HANDLE;
    VkDeviceSize draw_commands_offset_bytes = 0;
    // A buffer with the number of draws, as a 32-bit word at the offset. Then `draw_commands` contains
    // `most_draws` commands in any order, and the source records all draws with one command
    // (vkCmdDrawIndexedIndirectCount). Null: every command is drawn.
    VkBuffer draw_count = VK_NULL_HANDLE;
    VkDeviceSize draw_count_offset_bytes = 0;
    uint32_t most_draws = 0;
    // True: the source may leave out draws that are outside of the frustum of the view, or of the frustums of
    // all `views`. The source must not do this if the shader does not read the matrix of the view
    // (frame_ranges), because such a shader may place vertices anywhere.
    bool culls_draws = false;
    bool depth_clamp = false;  // True: geometry before the near plane and behind the far plane is drawn, too.
    std::span<const FrameRange> frame_ranges;  // The constants of set 0 that the shader reads.
    bool uses_materials = false;               // True: the pipeline layout has set 2 (material).
    bool uses_instances = false;               // True: the pipeline layout has set 3 (draw).
    DrawTargets targets;
};

// A view whose constants are in a buffer of the graph, for the frames of one frame slot.
struct ViewPlace {
    uint32_t frame_slot = 0;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset_bytes = 0;
};

// Copies of descriptor set 0 that an executor owns, because the constants of their views are in buffers of
// the executor's plan.
class ViewSets {
 public:
    virtual ~ViewSets() = default;
    [[nodiscard]] virtual VkDescriptorSet set(size_t index) const = 0;
};

class DrawSource {
 public:
    virtual ~DrawSource() = default;
    // Returns the layout of a set, or VK_NULL_HANDLE if the source does not provide this set. Set 0: frame
    // and view; set 2: material; set 3: draw.
    [[nodiscard]] virtual VkDescriptorSetLayout set_layout(uint32_t set) const = 0;
    // Returns descriptor set 0 of a frame slot for the view with the name `view`, such as "camera".
    [[nodiscard]] virtual VkDescriptorSet frame_set(uint32_t frame_slot, std::string_view view) const = 0;
    // Makes one descriptor set 0 for each place. Such a set has the content of frame_set(), except that the
    // constants of the view are in the buffer. Executors call this function when they are created, also while
    // another thread renders. Returns null if the source offers no views in buffers.
    [[nodiscard]] virtual Result<std::unique_ptr<ViewSets>> make_view_sets(
        std::span<const ViewPlace> /*places*/) const {
        return std::unique_ptr<ViewSets>();
    }
    // Returns descriptor set 0 like frame_set(), for a pass that draws or writes images with a live size.
    // `area` is the part of these images that the pass uses in the frame. In the constants of the view, the
    // viewport has the size of `area`. A source without support for areas returns frame_set().
    [[nodiscard]] virtual VkDescriptorSet frame_set_of_area(uint32_t frame_slot, std::string_view view,
                                                            const LiveArea& /*area*/) const {
        return frame_set(frame_slot, view);
    }
    // Returns descriptor set 0 of a frame slot for a pass with multiview. Binding 1 contains the constants of
    // all views of the pass, in the order of PassDecl::views and kViewStrideBytes apart.
    [[nodiscard]] virtual VkDescriptorSet views_set(uint32_t /*frame_slot*/,
                                                    std::span<const std::string> /*views*/) const {
        return VK_NULL_HANDLE;
    }
    // Returns false if no draw of the list ever uses the variant (an index into ImportDecl::variants). Then
    // no pipeline is created for this variant. Executors call this function when they are created, also while
    // another thread renders.
    [[nodiscard]] virtual bool draws_variant(std::string_view /*list*/, uint32_t /*variant*/) const {
        return true;
    }
    // Returns true if the source supports passes that draw several views (PassDecl::lowering): it provides
    // views_set(), and the constants of each view contain its number at kViewNumberOffsetBytes.
    [[nodiscard]] virtual bool draws_several_views() const { return false; }
    // Returns true if the picture of the view is a mirror image in this frame, so that triangles have the
    // opposite winding.
    [[nodiscard]] virtual bool is_mirrored(std::string_view /*view*/) const { return false; }
    // Records every draw of `context.list` that uses `context.variant`. The executor has bound sets 0 and 1,
    // and binds all that it needs again afterwards, so the source may bind pipelines and sets of its own.
    // The source binds sets 2 and 3 if the pipeline layout has them. It binds vertex buffers in the order of
    // the streams in the import's vertex format. Returns how many draws were left out because they are
    // outside of the frustum.
    virtual uint32_t record(const DrawContext& context) const = 0;
    // Appends the parts `ranges` of the uniform blocks of frame_set() to `bytes`. If all these bytes, and the
    // versions of all draw lists and imports, are the same as in an earlier frame, set 0 has the same content
    // as in that frame. Returns false if the source does not know the content. Then passes with "rest", which
    // are otherwise skipped while their inputs stay the same, run in every frame if they use set 0.
    [[nodiscard]] virtual bool add_frame_bytes(uint32_t /*frame_slot*/, std::string_view /*view*/,
                                               std::span<const FrameRange> /*ranges*/,
                                               std::vector<std::byte>& /*bytes*/) const {
        return false;
    }
    // Returns a number that changes whenever the draws of the list change: their number, order, meshes,
    // transforms, materials or textures. Returns nullopt if they may change in every frame.
    [[nodiscard]] virtual std::optional<uint64_t> list_version(std::string_view /*list*/) const { return {}; }
    // Returns the number of draws in the list, for messages about slow frames.
    [[nodiscard]] virtual uint64_t draw_count(std::string_view /*list*/) const { return 0; }
};

}  // namespace weft::vk
