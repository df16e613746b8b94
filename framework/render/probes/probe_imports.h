// Purpose: the imports with which graphs see the irradiance probes of a scene, and their buffers on the GPU.
// "probePoints", "probeCells" and "probeGrid" are buffers (shared/probe_grid.glsl), "probeFaces" is a list of
// views. The number "irradianceProbes" is the number of probes, and "probeCellSlots" the number of slots in
// "probeCells". A graph that lets the program choose the rounds of its probes imports "probeTurns".
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
inline constexpr std::array kProbeBuffers{"probePoints", "probeCells", "probeGrid"};

// Adds the imports, the strides of their structs, and the numbers. `probes`: those of a
// scene; null: the catalogue describes no scene, and has two probes.
void add_probe_imports(ImportCatalog& catalog, const scene::ProbeVolume* probes);

class GpuProbes {
 public:
    [[nodiscard]] static Result<GpuProbes> create(vk::Device& device, const scene::ProbeVolume& volume);
    // Adds the buffers to the imports of an executor.
    void bind(vk::ImportBindings& to) const;
    // Adds the versions of the buffers, which never change.
    static void add_versions(std::map<std::string, uint64_t, std::less<>>& to);
    [[nodiscard]] const std::vector<shared::ProbePoint>& points() const { return points_; }
    // Returns the views of the list "probeFaces".
    [[nodiscard]] const std::vector<shared::ViewConstants>& faces() const { return faces_; }

 private:
    std::vector<shared::ProbePoint> points_;
    std::vector<shared::ViewConstants> faces_;
    std::map<std::string, vk::Buffer, std::less<>> buffers_;
};

}  // namespace weft::render
