// Purpose: a minimal DrawSource for tests: one triangle in two vertex streams, and descriptor sets with one
// colour each. Set 0 depends on the view. Set 3 always has kSunColor. The object records which draws were
// requested.
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
    // Creates the triangle. The corners are in clip space, counter-clockwise with y pointing down. The second
    // vertex stream has one weight per corner.
    explicit TriangleSource(Device& device);

    [[nodiscard]] VkDescriptorSetLayout set_layout(uint32_t set) const override;
    [[nodiscard]] VkDescriptorSet frame_set(uint32_t frame_slot, std::string_view view) const override;
    // Records the draws of one variant of a list. With indirect draws, a list has two draws: the triangle and
    // its mirror image.
    uint32_t record(const DrawContext& context) const override;

    // Returns a draw list with two vertex streams: stream 0 has "position" (two floats), stream 1 has
    // "weight" (one float). The list has the variants "plain" and "tinted". In "tinted", the specialisation
    // constants TINT and UNKNOWN are 1. No shader declares UNKNOWN.
    [[nodiscard]] static ImportDecl draw_list(const std::string& name);

    static constexpr std::array<float, 4> kCameraColor{0.25F, 0.5F, 0.75F, 1.0F};
    static constexpr std::array<float, 4> kSunColor{4, 3, 2, 1};
    // The recorded draws as list/variant, for example "opaque/0" for variant 0 of the list "opaque".
    mutable std::vector<std::string> drawn;
    FrontFace front_face = FrontFace::counter_clockwise;

 private:
    void make_frame_sets(Device& device);

    Buffer positions_;
    Buffer weights_;
    Buffer indices_;
    Buffer colors_;
    SetLayoutHandle layout_;
    DescriptorPoolHandle pool_;
    // sets_[0] is set 0 of the view "camera". sets_[1] is set 0 of all other views, such as "sun(0)", and
    // also set 3.
    std::array<VkDescriptorSet, 2> sets_{};
};

}  // namespace weft::vk
