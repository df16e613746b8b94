// Purpose: a part of a scene on the GPU: its geometry and materials, the draws of its instances, and their
// motion. The scene of a session is its first part; a program can add and remove further parts. All draws of
// a part are divided into the draw lists of kDrawLists, sorted by material. Errors: V409 to V421.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/gpu_geometry.h"
#include "render/gpu_materials.h"
#include "render/motion/moving_objects.h"
#include "render/views/surface_tree.h"

namespace weft::render {

struct PartDraw {
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

struct PartDrawList {
    std::vector<PartDraw> draws;
    bool changed = false;  // True if a draw has moved in this frame.
};

struct PartInput {
    vk::Device& device;
    const scene::Scene& scene;
    // Null, or `&scene`: each texture of the scene is freed after it is copied to the GPU.
    scene::Scene* owned = nullptr;
    vk::Uploader& uploader;
    bool moves_instances = false;  // True: the program may move the instances.
    bool is_first = false;         // True: the part is the scene with which the session was created.
};

class GpuPart {
 public:
    [[nodiscard]] static Result<std::unique_ptr<GpuPart>> create(const PartInput& input);

    [[nodiscard]] bool can_set_transform(uint32_t instance) const { return moving_.can_set(instance); }
    void set_transform(uint32_t instance, const glm::mat4& transform) { moving_.set(instance, transform); }
    // Begins a frame: moves the objects to their places at `time_s`, and writes their transforms for a frame
    // slot, which must not be in flight.
    void begin_frame(uint32_t slot, double time_s);

    // Returns the transforms of the nodes of the scene at the time of the last begin_frame().
    [[nodiscard]] std::span<const glm::mat4> nodes() const { return nodes_; }
    [[nodiscard]] const MovingObjects& moving() const { return moving_; }
    // Returns the box around all objects; nullopt if the part has none.
    [[nodiscard]] const std::optional<scene::Bounds>& bounds() const { return bounds_; }
    // Returns the box around the draws in the lists of objects that do not move; nullopt if there are none.
    [[nodiscard]] const std::optional<scene::Bounds>& still_bounds() const { return still_bounds_; }
    // Returns the surfaces of the objects that do not move.
    [[nodiscard]] const SurfaceTree& still_surfaces() const { return still_surfaces_; }
    // Returns null if the part has no draw in this list.
    [[nodiscard]] const PartDrawList* list(std::string_view name) const;
    [[nodiscard]] const GpuGeometry& geometry() const { return geometry_; }
    // Returns descriptor set 2 of a material, and descriptor set 3 of a frame slot.
    [[nodiscard]] VkDescriptorSet material_set(uint32_t material) const { return materials_.set(material); }
    [[nodiscard]] VkDescriptorSet draw_set(uint32_t slot) const {
        return instances_.sets[instances_.sets.size() > 1 ? slot : 0];
    }
    // Returns the views of the import "materialTextures"; empty if the part is not the first.
    [[nodiscard]] const std::vector<VkImageView>& material_table() const { return materials_.table(); }
    [[nodiscard]] VkDescriptorSetLayout material_layout() const { return materials_.layout(); }
    [[nodiscard]] VkDescriptorSetLayout draw_layout() const { return instances_.layout.get(); }

 private:
    // A draw of an object that moves.
    struct DrawRef {
        PartDrawList* list = nullptr;
        uint32_t draw = 0;
    };

    GpuPart() = default;
    [[nodiscard]] Status make_draw_sets(vk::Device& device);
    void sort_draws(const scene::Scene& scene);
    void find_moving_draws();
    void drop_from_still_lists(uint32_t object);
    void write_object(uint32_t slot, const MovingObject& object);
    void update_bounds();
    void find_still_bounds();

    GpuGeometry geometry_;
    GpuMaterials materials_;
    // Descriptor set 3 with the instances and the optional vertex streams of all meshes: one for each buffer
    // of GpuGeometry::instances.
    DescriptorSets instances_;
    scene::Motion motion_;
    std::vector<glm::mat4> nodes_;
    MovingObjects moving_;
    std::map<std::string, PartDrawList, std::less<>> lists_;
    // The draws of each object in MovingObjects::all().
    std::vector<std::vector<DrawRef>> draws_of_object_;
    // For each object in MovingObjects::all(): true if it is in the lists of objects that do not move.
    std::vector<bool> is_still_;
    std::optional<scene::Bounds> fixed_bounds_;  // Of the objects that do not move.
    std::optional<scene::Bounds> bounds_;
    std::optional<scene::Bounds> still_bounds_;
    SurfaceTree still_surfaces_;
    bool has_begun_ = false;  // True after the first begin_frame() of a part with moving objects.
};

}  // namespace weft::render
