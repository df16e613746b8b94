// Purpose: a minimal DrawSource: one triangle in two vertex streams, a frame set with one colour per view,
// and a set 3 with another colour. It records its calls for the test.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "vulkan/device/handle.h"
#include "weft/vulkan/draw_source.h"
#include "weft/vulkan/memory.h"

namespace weft::vk {

class TriangleSource final : public DrawSource {
 public:
    // Corners in clip space, counter-clockwise with y pointing down; the second stream has a weight per
    // corner.
    explicit TriangleSource(Device& device);

    [[nodiscard]] VkDescriptorSetLayout set_layout(uint32_t set) const override;
    [[nodiscard]] VkDescriptorSet frame_set(uint32_t frame_slot, std::string_view view) const override;
    // With indirect draws, a list has two draws: the indices of the triangle, then those of its mirror image.
    void record(const DrawContext& context) const override;

    // Stream 0: "position" (two floats), stream 1: "weight" (one float). Variants "plain" and "tinted" (TINT
    // is true).
    [[nodiscard]] static ImportDecl draw_list(const std::string& name);

    static constexpr std::array<float, 4> kCameraColor{0.25F, 0.5F, 0.75F, 1.0F};
    static constexpr std::array<float, 4> kSunColor{4, 3, 2, 1};
    mutable std::vector<std::string> drawn;  // "opaque/0"
    FrontFace front_face = FrontFace::counter_clockwise;

 private:
    void make_frame_sets(Device& device);

    Buffer positions_;
    Buffer weights_;
    Buffer indices_;
    Buffer colors_;
    SetLayoutHandle layout_;
    DescriptorPoolHandle pool_;
    std::array<VkDescriptorSet, 2> sets_{};  // camera, sun(0)
};

}  // namespace weft::vk
