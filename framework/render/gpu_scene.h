// Purpose: a scene on the GPU in the form that graphs use. It has four draw lists. "opaque", "masked" and
// "anisotropic" are sorted by material; "transparent" is sorted by distance in every frame. Each of these
// lists also has a buffer of draw commands. "opaqueStill" and "maskedStill" have the draws of "opaque" and
// "masked" whose objects do not move. Parts can be added to the scene and removed from it while frames run;
// their draws belong to the same lists, but not to the buffers that describe the scene. Further draw lists
// belong to the program. The shaders use descriptor sets 0 (frame), 2 (material) and 3 (draw); see
// frame_set.glsl, material_set.glsl and surface_vertex.glsl in shaders/include/.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/gpu_frame.h"
#include "render/imports/scene_buffers.h"
#include "render/imports/scene_lights.h"
#include "render/parts/draw_recorder.h"
#include "render/parts/gpu_part.h"
#include "render/parts/part_list.h"
#include "render/probes/probe_imports.h"
#include "weft/render/draw_list.h"
#include "weft/vulkan/draw_source.h"

namespace weft::render {

// The settings with which a program makes a scene.
struct SceneSettings {
    OwnDrawLists draw_lists;
    OwnDrawSets draw_sets;
    bool moves_instances = false;
    bool adds_parts = true;
    scene::Probes probes;
};

class GpuScene final : public vk::DrawSource {
 public:
    // `owned` is either null or `&scene`. If it is not null, each texture of the scene is freed after it is
    // copied to the GPU.
    [[nodiscard]] static Result<std::unique_ptr<GpuScene>> create(vk::Device& device,
                                                                  const scene::Scene& scene,
                                                                  const SceneSettings& settings = {},
                                                                  scene::Scene* owned = nullptr);

    // The parts of the scene. The first part is the scene of create().
    [[nodiscard]] PartList& parts() { return parts_; }
    [[nodiscard]] const PartList& parts() const { return parts_; }
    // True if the program replaces descriptor sets that the draws of parts need.
    [[nodiscard]] bool replaces_sets() const { return !settings_.draw_sets.empty(); }
    // True if the program may add parts after create().
    [[nodiscard]] bool takes_parts() const { return settings_.adds_parts; }
    // Begins a frame: moves the objects of all parts to their places at `time_s`. Call it before set_frame().
    void begin_frame(uint32_t slot, double time_s);
    // Writes the imports "sceneLights" and "lightChanges" for a frame slot.
    void set_lights(uint32_t slot, std::span<const shared::Light> lights) { lights_.write(slot, lights); }
    // Returns the box around all objects and all draw lists of the program; nullopt if there are none.
    [[nodiscard]] std::optional<scene::Bounds> bounds() const;
    // Returns the box around the objects that do not move; nullopt if there are none.
    [[nodiscard]] std::optional<scene::Bounds> still_bounds() const;
    // Returns the box around the draw lists of the program and around the parts in which all objects move.
    // Nothing except this box is known about the surfaces of these lists and parts. nullopt: there are no
    // such lists and parts.
    [[nodiscard]] std::optional<scene::Bounds> unknown_bounds() const;
    // Returns true if a draw list of the program does not tell its bounds.
    [[nodiscard]] bool has_unbounded_lists() const;

    // Writes the constants of a frame slot, and sorts the transparent surfaces by distance. Call it between
    // Executor::begin_frame() and run(). The first view is the camera. `united_views`: the views of each pass
    // with multiview.
    [[nodiscard]] Status set_frame(uint32_t slot, const shared::FrameConstants& frame,
                                   const shared::SunConstants& sun, const shared::FurtherSuns& further_suns,
                                   std::span<const FrameView> views, std::span<const ViewNames> united_views);

    [[nodiscard]] VkDescriptorSetLayout set_layout(uint32_t set) const override;
    [[nodiscard]] VkDescriptorSet frame_set(uint32_t frame_slot, std::string_view view) const override;
    [[nodiscard]] Result<std::unique_ptr<vk::ViewSets>> make_view_sets(
        std::span<const vk::ViewPlace> places) const override;
    [[nodiscard]] VkDescriptorSet frame_set_of_area(uint32_t frame_slot, std::string_view view,
                                                    const LiveArea& area) const override;
    [[nodiscard]] VkDescriptorSet views_set(uint32_t frame_slot,
                                            std::span<const std::string> views) const override;
    [[nodiscard]] bool draws_variant(std::string_view list, uint32_t variant) const override;
    [[nodiscard]] bool draws_several_views() const override { return true; }
    [[nodiscard]] bool add_frame_bytes(uint32_t frame_slot, std::string_view view,
                                       std::span<const FrameRange> ranges,
                                       std::vector<std::byte>& bytes) const override;
    // Returns nullopt for the scene's list "transparent", because its order may change in every frame. The
    // version of any other list of the scene changes when an object in the list moves, and when a part that
    // has objects in the list is added or removed.
    [[nodiscard]] std::optional<uint64_t> list_version(std::string_view list) const override;
    uint32_t record(const vk::DrawContext& context) const override;
    [[nodiscard]] const GpuProbes& probes() const { return probes_; }
    // Hook for tests: if `culls` is false, draws outside of the frustum are recorded too.
    void set_culling(bool culls) { culls_ = culls; }
    [[nodiscard]] uint64_t draw_count(std::string_view list) const override;
    [[nodiscard]] bool is_mirrored(std::string_view view) const override;
    // Adds the objects that graphs can import: the draw commands of each list (under the name that
    // commands_of() returns), kSceneBuffers, kSceneLights, kLightChanges, the buffers of the light probes,
    // and the table kMaterialTextures.
    void bind(vk::ImportBindings& to) const;
    // Adds the versions of the buffers that bind() adds. The versions of "instances" and "bounds" change when
    // an object moves. The version of "sceneLights" changes when a light changes.
    void add_versions(std::map<std::string, uint64_t, std::less<>>& to) const;

 private:
    struct ViewShape {
        bool mirrored = false;  // True if the picture is a mirror image.
        glm::mat4 view_projection{1};
        Frustum frustum;
    };
    // A run: consecutive elements of far_to_near_ that belong to the same part. `first` is the index of the
    // first.
    struct SortedRun {
        const GpuPart* part = nullptr;
        uint32_t first = 0;
        uint32_t count = 0;
    };

    GpuScene() = default;
    // Returns the frustums of the views that are drawn; empty if all draws are recorded.
    [[nodiscard]] Frusta find_frusta(const vk::DrawContext& context) const;
    uint32_t record_own(const vk::DrawContext& context, const DrawList& list) const;
    uint32_t record_sorted(const vk::DrawContext& context, DrawRecorder& recorder) const;
    void sort_transparent(const glm::vec3& eye);
    void find_drawn_variants();
    [[nodiscard]] Status upload_commands(vk::Device& device);
    [[nodiscard]] const GpuPart& first() const { return parts_.first(); }

    PartList parts_;
    GpuFrame frame_;
    SceneBuffers buffers_;
    GpuProbes probes_;
    SceneLights lights_;
    SceneSettings settings_;
    uint64_t objects_version_ = 0;  // Changes whenever an object of the first part has moved.
    // Indices into the transparent lists of the parts, from far to near as seen from the camera. Consecutive
    // indices into the list of the same part form a run.
    std::vector<uint32_t> far_to_near_;
    std::vector<SortedRun> sorted_runs_;
    // The views of the frame, by name.
    std::map<std::string, ViewShape, std::less<>> views_;
    uint64_t fixed_views_ = 0;  // FrameView::fixed of the fixed views in views_; 0: no view is fixed.
    bool culls_ = true;
    // The variants of each draw list of the scene that have draws when the scene is created.
    std::map<std::string, std::set<uint32_t>, std::less<>> drawn_variants_;
    // The buffer of draw commands of each draw list, by the name of the list.
    std::map<std::string, vk::Buffer, std::less<>> commands_;
};

}  // namespace weft::render
