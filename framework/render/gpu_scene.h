// Purpose: a scene on the GPU in the form that graphs use: the lists opaque, masked and anisotropic, sorted
// by material, and transparent, sorted by distance in every frame; a buffer of draw commands for each, and
// the sets 0 (frame), 2 (material) and 3 (draw) that shaders/include/*_set.glsl declare.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/gpu_frame.h"
#include "render/gpu_geometry.h"
#include "render/gpu_materials.h"
#include "weft/vulkan/draw_source.h"

namespace weft::render {

class GpuScene final : public vk::DrawSource {
 public:
    // `owned` is `scene` or null. Each texture in it is freed after it was copied to the GPU.
    [[nodiscard]] static Result<std::unique_ptr<GpuScene>> create(vk::Device& device,
                                                                  const scene::Scene& scene,
                                                                  scene::Scene* owned = nullptr);

    // Fills the slot's constants and sorts transparent surfaces; call it between Executor::begin_frame() and
    // run().
    void set_frame(uint32_t slot, const shared::FrameConstants& frame, const shared::ViewConstants& camera,
                   const SunCascades& sun);

    [[nodiscard]] VkDescriptorSetLayout set_layout(uint32_t set) const override;
    [[nodiscard]] VkDescriptorSet frame_set(uint32_t frame_slot, std::string_view view) const override;
    void record(const vk::DrawContext& context) const override;
    [[nodiscard]] uint64_t draw_count(std::string_view list) const override;
    // The buffer for the import commands_of(list), for any list of import_catalog.h.
    [[nodiscard]] VkBuffer commands(std::string_view list) const;

 private:
    struct Draw {
        MeshRange mesh;
        uint32_t instance = 0;
        uint32_t material = 0;
        uint32_t variant = 0;  // of its list
        bool double_sided = false;
        bool mirrored = false;  // negative determinant: the winding is swapped
        glm::vec3 center{0};    // of its bounds, in world space
    };
    // The state that was last set in a command buffer.
    struct DrawState {
        uint32_t material = scene::kNone;
        std::optional<bool> mirrored, double_sided;
    };
    [[nodiscard]] uint32_t count_alike(const vk::DrawContext& context, const std::vector<Draw>& draws,
                                       uint32_t i) const;
    void set_state(const vk::DrawContext& context, const Draw& draw, DrawState& state) const;
    // The index in its list of the i-th draw.
    [[nodiscard]] uint32_t place_of(std::string_view list, uint32_t i) const;

    GpuScene() = default;
    void sort_draws(const scene::Scene& scene);
    [[nodiscard]] Status upload_commands(vk::Device& device);

    GpuGeometry geometry_;
    GpuMaterials materials_;
    GpuFrame frame_;
    DescriptorSets instances_;  // one set
    std::map<std::string, std::vector<Draw>, std::less<>> lists_;
    std::vector<uint32_t> far_to_near_;                        // the transparent list, sorted for the camera
    std::map<std::string, vk::Buffer, std::less<>> commands_;  // index: list
};

}  // namespace weft::render
