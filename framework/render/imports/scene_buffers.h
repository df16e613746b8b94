// Purpose: the buffers that describe the objects of a scene, for passes that cull or choose objects on the
// GPU. Graphs import them by name: "instances" (shared::Instance), "bounds" (shared::Bounds, one for each
// instance), "meshes" (shared::Mesh) and "materials" (shared::Material).
// Errors: those of vk::Buffer::create() and upload_buffer().
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "render/gpu_geometry.h"
#include "render/motion/moving_objects.h"
#include "shared/bounds.glsl"
#include "shared/instance.glsl"
#include "shared/material.glsl"
#include "shared/mesh.glsl"
#include "weft/imports.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

inline constexpr std::array kSceneBuffers{"instances", "bounds", "meshes", "materials"};

// Returns an import with a buffer that the program writes before the first frame and that passes only read.
[[nodiscard]] ImportDecl scene_buffer(const std::string& name, size_t elements, size_t stride_bytes);
// Makes a buffer of the scene with these bytes.
[[nodiscard]] Result<vk::Buffer> make_scene_buffer(vk::Device& device, std::span<const std::byte> bytes,
                                                   const std::string& name);

// Adds the imports of kSceneBuffers, the strides of their structs, and the numbers "instanceCount",
// "meshCount" and "materialCount". If `scene` is null, each buffer has one element.
void add_scene_buffers(ImportCatalog& catalog, const scene::Scene* scene);

// Returns the boxes of all instances in world space: box_in_world(). A moving instance has its box at time 0.
[[nodiscard]] std::vector<shared::Bounds> instance_bounds(const scene::Scene& scene);
// Returns the elements of the buffer "meshes". `ranges` has the place of each mesh in the vertex and index
// buffers.
[[nodiscard]] std::vector<shared::Mesh> mesh_table(const scene::Scene& scene,
                                                   const std::vector<MeshRange>& ranges);

// The buffers "bounds", "meshes" and "materials" on the GPU. The buffer "instances" belongs to GpuGeometry.
class SceneBuffers {
 public:
    [[nodiscard]] static Result<SceneBuffers> create(vk::Device& device, const scene::Scene& scene,
                                                     const std::vector<MeshRange>& ranges,
                                                     bool moves_instances = false);
    // Writes the bounding boxes of the objects that move (MovingObjects::active()) for a frame slot.
    void move(uint32_t slot, const MovingObjects& objects);
    // Adds the buffers to the imports of an executor.
    void bind(vk::ImportBindings& to) const;

 private:
    // One buffer for all frames, or if objects of the scene move, one mapped buffer per frame slot.
    std::vector<vk::Buffer> bounds_;
    std::map<std::string, vk::Buffer, std::less<>> buffers_;
};
// Adds a buffer of the scene to the imports of an executor. `slots` has one buffer for all frames, or one for
// each frame slot.
void bind_scene_buffer(const std::string& name, const std::vector<vk::Buffer>& slots, vk::ImportBindings& to);

}  // namespace weft::render
