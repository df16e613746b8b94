// Purpose: the imports with which graphs see the light probes of a scene, and their buffers on the GPU.
// Irradiance probes: "probePoints", "probeCells" and "probeGrid" are buffers (shared/probe_grid.glsl),
// "probeFaces" is a list of views, the number "irradianceProbes" is the number of probes, and
// "probeCellSlots" the number of slots in "probeCells". Reflection probes: "reflectionPoints"
// (shared::ProbePoint) and "reflectionBoxes" (shared::ReflectionBox) are buffers, "reflectionFaces" is a list
// of views, and the number "reflectionProbes" is the number of probes. If a group has one round for each
// probe, the imports "probeTurns" and "reflectionTurns" select the rounds that run in a frame.
// Errors: those of vk::Buffer::create() and upload_buffer().
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "render/probes/probe_tables.h"
#include "weft/imports.h"
#include "weft/vulkan/executor.h"

namespace weft::render {

inline constexpr const char* kProbeTurns = "probeTurns";
inline constexpr const char* kReflectionTurns = "reflectionTurns";
inline constexpr std::array kProbeBuffers{"probePoints", "probeCells", "probeGrid", "reflectionPoints",
                                          "reflectionBoxes"};

// Adds the imports, the strides of their structs, and the numbers. `probes`: the light probes of a scene. If
// it is null, the catalogue describes no scene, and one probe of each kind is assumed.
void add_probe_imports(ImportCatalog& catalog, const scene::Probes* probes);

class GpuProbes {
 public:
    [[nodiscard]] static Result<GpuProbes> create(vk::Device& device, const scene::Probes& scene);
    // Adds the buffers to the imports of an executor.
    void bind(vk::ImportBindings& to) const;
    // Adds the versions of the buffers, which never change.
    static void add_versions(std::map<std::string, uint64_t, std::less<>>& to);
    [[nodiscard]] const std::vector<shared::ProbePoint>& points() const { return points_; }
    // Returns the views of the list "probeFaces".
    [[nodiscard]] const std::vector<shared::ViewConstants>& faces() const { return faces_; }
    [[nodiscard]] const std::vector<shared::ProbePoint>& reflection_points() const {
        return reflection_points_;
    }
    // Returns the views of the list "reflectionFaces".
    [[nodiscard]] const std::vector<shared::ViewConstants>& reflection_faces() const {
        return reflection_faces_;
    }

 private:
    std::vector<shared::ProbePoint> points_, reflection_points_;
    std::vector<shared::ViewConstants> faces_, reflection_faces_;
    std::map<std::string, vk::Buffer, std::less<>> buffers_;
};

}  // namespace weft::render
