// Purpose: a draw list of one triangle, for tests of draw lists of the program.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <span>

#include "render/descriptor_sets.h"
#include "weft/render/draw_list.h"
#include "weft/vulkan/memory.h"

namespace weft::test {

// Has its own vertices and its own material set.
class TriangleList final : public render::DrawList {
 public:
    static constexpr glm::vec4 kTint{0.25f, 0.5f, 0.75f, 1};

    explicit TriangleList(vk::Device& device, float size = 20) {
        const std::array<glm::vec4, 3> corners{
            glm::vec4(-size, -size, 0, 1), {size, -size, 0, 1}, {0, 2 * size, 0, 1}};
        vertices_ = filled(device, std::as_bytes(std::span(corners)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
        paint_ = filled(device, std::as_bytes(std::span(&kTint, 1)), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1,
                                                   VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
        Result<render::DescriptorSets> sets =
            render::DescriptorSets::create(device, {&binding, 1}, 1, "paint");
        EXPECT_TRUE(sets);
        sets_ = std::move(*sets);
        const VkDescriptorBufferInfo info{paint_.handle(), 0, VK_WHOLE_SIZE};
        render::write_buffers(device, sets_.sets[0], 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {&info, 1});
    }
    uint32_t record(const vk::DrawContext& draw, const render::DrawView& view) const override {
        const VkBuffer vertices = vertices_.handle();
        const VkDeviceSize offset = 0;
        draw.fn->vkCmdBindVertexBuffers(draw.commands, 0, 1, &vertices, &offset);
        bind_material(draw);
        draw.fn->vkCmdDraw(draw.commands, 3, 1, 0, 0);
        targets = draw.targets;
        views = view.all_view_projections.size();
        seen = view;
        seen.all_view_projections = {};  // They exist only during the call.
        return 0;
    }
    void bind_material(const vk::DrawContext& draw) const {
        if (draw.uses_materials)
            draw.fn->vkCmdBindDescriptorSets(draw.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw.layout, 2,
                                             1, &sets_.sets[0], 0, nullptr);
    }
    std::optional<uint64_t> version() const override { return 1; }
    std::optional<scene::Bounds> bounds() const override { return scene::Bounds{{-20, -20, 0}, {20, 40, 0}}; }
    uint64_t count() const override { return 1; }
    VkDescriptorSetLayout layout() const { return sets_.layout.get(); }

    mutable vk::DrawTargets targets;
    mutable render::DrawView seen;
    mutable size_t views = 0;  // Number of views that the last draws draw at once; 0 without multiview.

 private:
    static vk::Buffer filled(vk::Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage) {
        Result<vk::Buffer> buffer =
            vk::Buffer::create(device, bytes.size(), usage, vk::Buffer::Memory::upload, "triangle");
        EXPECT_TRUE(buffer);
        std::ranges::copy(bytes, buffer->mapped().begin());
        return std::move(*buffer);
    }

    vk::Buffer vertices_, paint_;
    render::DescriptorSets sets_;
};

}  // namespace weft::test
