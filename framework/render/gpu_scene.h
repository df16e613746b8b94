// Purpose: a scene on the GPU in the form that graphs use. It has four draw lists. "opaque", "masked" and
// "anisotropic" are sorted by material; "transparent" is sorted by distance in every frame. Each list also
// has a buffer of draw commands. The shaders use descriptor sets 0 (frame), 2 (material) and 3 (draw); see
// frame_set.glsl, material_set.glsl and surface_vertex.glsl in shaders/include/.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/gpu_frame.h"
#include "render/gpu_geometry.h"
#include "render/gpu_materials.h"
#include "render/imports/scene_buffers.h"
#include "render/motion/moving_objects.h"
#include "render/views/frustum.h"
#include "weft/vulkan/draw_source.h"

namespace weft::render {

class GpuScene final : public vk::DrawSource {
 public:
    // `owned` is either null or `&scene`. If it is not null, each texture of the scene is freed after it is
    // copied to the GPU.
    [[nodiscard]] static Result<std::unique_ptr<GpuScene>> create(vk::Device& device,
                                                                  const scene::Scene& scene,
                                                                  scene::Scene* owned = nullptr);

    // Moves the objects of the scene: writes their transforms for a frame slot. `nodes` is the result of
    // transforms_at(). Call it before set_frame(). Does nothing if no object of the scene moves.
    void move(uint32_t slot, std::span<const glm::mat4> nodes);
    [[nodiscard]] const MovingObjects& moving() const { return moving_; }

    // Writes the constants of a frame slot, and sorts the transparent surfaces by distance. Call it between
    // Executor::begin_frame() and run(). The first view is the camera. `united_views`: the views of each pass
    // with multiview.
    [[nodiscard]] Status set_frame(uint32_t slot, const shared::FrameConstants& frame,
                                   const shared::SunConstants& sun, std::span<const FrameView> views,
                                   std::span<const ViewNames> united_views);

    [[nodiscard]] VkDescriptorSetLayout set_layout(uint32_t set) const override;
    [[nodiscard]] VkDescriptorSet frame_set(uint32_t frame_slot, std::string_view view) const override;
    [[nodiscard]] Result<std::unique_ptr<vk::ViewSets>> make_view_sets(
        std::span<const vk::ViewPlace> places) const override;
    [[nodiscard]] VkDescriptorSet frame_set_of_area(uint32_t frame_slot, std::string_view view,
                                                    const LiveArea& area) const override;
    [[nodiscard]] VkDescriptorSet views_set(uint32_t frame_slot,
                                            std::span<const std::string> views) const override;
    [[nodiscard]] bool draws_several_views() const override { return true; }
    [[nodiscard]] bool add_frame_bytes(uint32_t frame_slot, std::string_view view,
                                       std::span<const FrameRange> ranges,
                                       std::vector<std::byte>& bytes) const override;
    // The order of the transparent objects may change in every frame. The version of any other list changes
    // when one of its objects moves.
    [[nodiscard]] std::optional<uint64_t> list_version(std::string_view list) const override;
    uint32_t record(const vk::DrawContext& context) const override;
    // Hook for tests: if `culls` is false, draws outside of the frustum are recorded too.
    void set_culling(bool culls) { culls_ = culls; }
    [[nodiscard]] uint64_t draw_count(std::string_view list) const override;
    [[nodiscard]] bool is_mirrored(std::string_view view) const override;
    // Adds the buffers that graphs can import: the draw commands of each list, under the name commands_of(),
    // and kSceneBuffers.
    void bind(vk::ImportBindings& to) const;
    // Adds the versions of these buffers. Those of "instances" and "bounds" change when an object moves.
    void add_versions(std::map<std::string, uint64_t, std::less<>>& to) const;

 private:
    void record_counted(const vk::DrawContext& context) const;

    struct Draw {
        MeshRange mesh;
        uint32_t instance = 0;
        uint32_t material = 0;
        // Index of the pipeline variant in the variants of its draw list.
        uint32_t variant = 0;
        bool double_sided = false;
        // True if the transform has a negative determinant, so that the winding of triangles is reversed.
        bool mirrored = false;
        // Centre of the bounds in world space.
        glm::vec3 center{0};
        scene::Bounds box;  // In world space.
    };
    // A draw of an object that moves: an index into DrawList::draws, and one into MovingObjects::all().
    struct MovingDraw {
        uint32_t draw = 0;
        uint32_t object = 0;
    };
    struct DrawList {
        std::vector<Draw> draws;
        std::vector<MovingDraw> moving;
        uint64_t version = 0;
    };
    // The state that the previous draws in a command buffer have set.
    struct DrawState {
        uint32_t material = scene::kNone;
        std::optional<bool> clockwise, double_sided;
    };
    [[nodiscard]] uint32_t count_alike(const vk::DrawContext& context, const std::vector<Draw>& draws,
                                       uint32_t i, const Frusta& frusta) const;
    // Returns the frustums of the views that are drawn; empty if all draws are recorded.
    [[nodiscard]] Frusta find_frusta(const vk::DrawContext& context) const;
    void set_state(const vk::DrawContext& context, const Draw& draw, bool clockwise, DrawState& state) const;
    // Returns the index in `list` of the draw that is recorded as number i, counted from 0. The index differs
    // from i only in the transparent list, which is recorded from far to near.
    [[nodiscard]] uint32_t place_of(std::string_view list, uint32_t i) const;

    GpuScene() = default;
    void sort_draws(const scene::Scene& scene);
    void find_moving_draws();
    [[nodiscard]] Status upload_commands(vk::Device& device);

    GpuGeometry geometry_;
    GpuMaterials materials_;
    GpuFrame frame_;
    SceneBuffers buffers_;
    uint64_t objects_version_ = 0;  // Changes whenever an object has moved.
    // Descriptor set 3 with the instances and the optional vertex streams of all meshes: one for each buffer
    // of GpuGeometry::instances.
    DescriptorSets instances_;
    MovingObjects moving_;
    std::map<std::string, DrawList, std::less<>> lists_;
    // Indices into the transparent list, sorted from far to near as seen from the camera.
    std::vector<uint32_t> far_to_near_;
    struct ViewShape {
        bool mirrored = false;  // True if the picture is a mirror image.
        Frustum frustum;
    };
    // The views of the frame, by name.
    std::map<std::string, ViewShape, std::less<>> views_;
    bool culls_ = true;
    // The buffer of draw commands of each draw list, by the name of the list.
    std::map<std::string, vk::Buffer, std::less<>> commands_;
};

}  // namespace weft::render
