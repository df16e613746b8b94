// Purpose: the buffers that describe the objects of a scene, for passes that cull or choose objects on the
// GPU. Graphs import them by name: "instances" (shared::Instance), "bounds" (shared::Bounds, one for each
// instance), "meshes" (shared::Mesh) and "materials" (shared::Material).
// Errors: those of vk::Buffer::create() and upload_buffer().
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "render/gpu_geometry.h"
#include "shared/bounds.glsl"
#include "shared/instance.glsl"
#include "shared/material.glsl"
#include "shared/mesh.glsl"
#include "weft/imports.h"
#include "weft/scene/scene.h"

namespace weft::render {

inline constexpr std::array kSceneBuffers{"instances", "bounds", "meshes", "materials"};

// Adds the imports of kSceneBuffers, the strides of their structs, and the numbers "instanceCount",
// "meshCount" and "materialCount". If `scene` is null, each buffer has one element.
void add_scene_buffers(ImportCatalog& catalog, const scene::Scene* scene);

// Returns the axis-aligned box in world space around the corners of each instance's transformed box.
[[nodiscard]] std::vector<shared::Bounds> instance_bounds(const scene::Scene& scene);
// Returns the elements of "meshes". `ranges` has the place of each mesh in the vertex and index buffers.
[[nodiscard]] std::vector<shared::Mesh> mesh_table(const scene::Scene& scene,
                                                   const std::vector<MeshRange>& ranges);

// The buffers "bounds", "meshes" and "materials" on the GPU. The buffer "instances" belongs to GpuGeometry.
class SceneBuffers {
 public:
    [[nodiscard]] static Result<SceneBuffers> create(vk::Device& device, const scene::Scene& scene,
                                                     const std::vector<MeshRange>& ranges);
    // `name` is one of kSceneBuffers except "instances".
    [[nodiscard]] VkBuffer find(std::string_view name) const { return buffers_.find(name)->second.handle(); }

 private:
    std::map<std::string, vk::Buffer, std::less<>> buffers_;
};

}  // namespace weft::render
